#include "image_match.hpp"

#include <quadmatch/match/matcher.hpp>

#include "part_mesh.hpp"

namespace quadmatch::use {

Match match_with_image(const Mesh& mesh, const Mesh& other, const MirrorPlane& plane, ImageOptions asked) {
  MatchOptions options;
  options.orientation = OrientationChoice::Reversing;
  options.positions = asked.positions;
  options.progress = asked.progress;
  // One side of a model is no edited copy of the other: a posed limb is as long in another place, so lengths cannot say
  // which way round it hangs; and what only one side has is no row of quads.
  options.stages.turns = options.stages.rows = false;
  return asked.positions ? match(mesh, moved(other, plane), options).match : match(mesh, other, options).match;
}

}  // namespace quadmatch::use
