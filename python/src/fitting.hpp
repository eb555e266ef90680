#pragma once
/// Is a match of these meshes, and is it one at all?

#include <stdexcept>

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/verify/verify.hpp>

#include "errors.hpp"

namespace quadmatch::python {

[[nodiscard]] inline MatchSide side_of(const MeshFile& file) {
  return {file.path, file.mesh.vertex_count(), file.mesh.face_count()};
}

/// Refuse a match of meshes of other sizes, with a ValueError.
inline void check_fits(const MatchFile& match, const MeshFile& source, const MeshFile& target) {
  const Expected<void> fitting = fits(match, side_of(source), side_of(target));
  if (!fitting) raise(fitting.error());
}

/// No match leaves this module that the definition does not allow.
inline void check_sound(const Verdict& verdict) {
  if (verdict.sound()) return;
  throw std::runtime_error(fmt::format("internal error: the match found is not sound ({}); please report it",
                                       verdict.faults.front().message));
}

}  // namespace quadmatch::python
