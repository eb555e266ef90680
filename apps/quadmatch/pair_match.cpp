#include "pair_match.hpp"

#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>

#include "dirt.hpp"

namespace quadmatch::cli {
namespace {

MatchSide side_of(const MeshFile& file) { return {file.path, file.mesh.vertex_count(), file.mesh.face_count()}; }

/// The match of a file, if it is of these meshes.
Expected<Match> given_match(const std::string& path, const MeshFile& source, const MeshFile& target) {
  Expected<MatchFile> file = read_match(path);
  if (!file) return Unexpected(file.error());
  if (Expected<void> fitting = fits(*file, side_of(source), side_of(target)); !fitting) {
    return Unexpected(fitting.error());
  }
  return std::move(file->match);
}

Match found_match(const MatchWishes& wishes, const MeshFile& source, const MeshFile& target, Progress& progress) {
  MatchOptions options;
  options.positions = !wishes.no_positions;
  options.waves = wishes.waves;
  options.orientation = orientation_choices().at(wishes.orientation);
  if (progress.visible()) {
    options.progress = [&progress](std::size_t matched, std::size_t most) {
      progress.update(matched, most);
      return true;
    };
  }
  return match(source.mesh, target.mesh, options).match;
}

}  // namespace

bool wishes_fit(const MatchWishes& wishes) {
  if (wishes.file.empty() || (!wishes.no_positions && wishes.orientation == "auto")) return true;
  complain(fmt::format("{} is about matching, but --match gives the match; leave one of them out",
                       wishes.no_positions ? "--no-positions" : "--orientation"));
  return false;
}

std::optional<Match> find_or_read_match(const MatchWishes& wishes, const MeshFile& source, const MeshFile& target,
                                        Progress& progress) {
  if (wishes.file.empty()) return found_match(wishes, source, target, progress);
  Expected<Match> match = given_match(wishes.file, source, target);
  if (match) return *std::move(match);
  if (match.error().path.empty()) match.error().path = display_name(wishes.file);
  complain(match.error());
  return std::nullopt;
}

void warn_of_dirt(const MeshFile& file) {
  const std::string dirt = describe_dirt(file.mesh, "matching");
  if (!dirt.empty()) warn(fmt::format("{}: {}", display_name(file.path), dirt));
}

}  // namespace quadmatch::cli
