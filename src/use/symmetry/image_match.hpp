#pragma once
/// A match of a mesh with a mirror image.

#include <functional>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

#include "mirror_plane.hpp"

namespace quadmatch::use {

struct ImageOptions {
  bool positions;  ///< look at them, if the meshes have some
  const std::function<bool(std::size_t, std::size_t)>& progress;
};

/// A mesh on another, or itself, in a mirror: its faces turned over, and its positions mirrored too, so that a model at
/// rest lies on its image by a motion.
[[nodiscard]] Match match_with_image(const Mesh& mesh, const Mesh& other, const MirrorPlane& plane, ImageOptions asked);

}  // namespace quadmatch::use
