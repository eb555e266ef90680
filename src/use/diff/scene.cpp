#include "scene.hpp"

namespace quadmatch::use {

Scene forwards(const Sides& sides, const Area& area, bool positions) {
  Scene scene{
      &sides.source, &sides.target, area.source_faces, area.target_faces, area.source_pieces, area.target_pieces, {},
      area.torn,     area.joined,   positions};
  scene.rim.reserve(area.disputes.size());
  for (const Dispute& dispute : area.disputes) {
    scene.rim.push_back({dispute.source, dispute.target, dispute.in_source, dispute.in_target});
  }
  return scene;
}

Scene backwards(const Scene& scene) {
  Scene turned{scene.after,         scene.before, scene.faces_after, scene.faces_before, scene.pieces_after,
               scene.pieces_before, {},           scene.joined,      scene.torn,         scene.positions};
  turned.rim.reserve(scene.rim.size());
  for (const RimSide& side : scene.rim) turned.rim.push_back({side.after, side.before, side.in_after, side.in_before});
  return turned;
}

}  // namespace quadmatch::use
