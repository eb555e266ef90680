#include "image_match.hpp"

#include <quadmatch/match/matcher.hpp>

#include "part_mesh.hpp"

namespace quadmatch::use {

Match match_with_image(const Mesh& mesh, const Mesh& other, const MirrorPlane& plane, ImageOptions asked) {
  MatchOptions options;
  options.orientation = OrientationChoice::Reversing;
  options.positions = asked.positions;
  options.progress = asked.progress;
  return asked.positions ? match(mesh, moved(other, plane), options).match : match(mesh, other, options).match;
}

}  // namespace quadmatch::use
