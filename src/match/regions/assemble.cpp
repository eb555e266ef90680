#include "assemble.hpp"

#include <algorithm>
#include <utility>

#include <quadmatch/mesh/large_pages.hpp>

namespace quadmatch::regions {
namespace {

/// How many pairs ahead the corners of faces are asked for: long enough for memory to answer.
constexpr std::size_t kAhead = 16;

FacePair face_pair(const Sides& sides, const Candidate& pair, Orientation orientation) {
  const Mesh& source = sides.source.mesh;
  const Mesh& target = sides.target.mesh;
  const FaceId q = source.face(pair.source), r = target.face(pair.target);
  const std::uint32_t size = source.size(q);
  const std::uint32_t sum = target.corner(pair.target) + size - source.corner(pair.source);
  const std::uint32_t corner = sum >= size ? sum - size : sum;
  // In the mirror corner k is corner n - 1 - k of the face as it was given (Mesh::mirrored).
  return {q, r, orientation == Orientation::Preserving ? corner : size - 1 - corner};
}

/// Calls visit(piece, h) once for every piece that has a corner at a fan, with a corner there.
template <class PieceAt, class Visit>
void for_each_piece_at(const Mesh& mesh, FanId fan, std::vector<std::uint32_t>& met, PieceAt piece_at, Visit visit) {
  met.clear();
  for (const HalfedgeId h : mesh.outgoing(fan)) {
    const std::uint32_t piece = piece_at(mesh.face(h));
    if (piece == kNoPiece || std::find(met.begin(), met.end(), piece) != met.end()) continue;
    met.push_back(piece);
    visit(piece, h);
  }
}

}  // namespace

void weigh_pieces(const Sides& sides, const Patchwork& patchwork, const PieceOfRegion& piece_of,
                  std::vector<Piece>& pieces) {
  std::vector<std::uint32_t> met;
  const auto at_source = [&](FaceId face) {
    return patchwork.is_matched(face) ? piece_of[patchwork.region(face)] : kNoPiece;
  };
  const auto at_target = [&](FaceId face) {
    return patchwork.is_taken(face) ? piece_of[patchwork.region(patchwork.origin(face))] : kNoPiece;
  };
  for (const FanId fan : sides.source.separatrices.nodes) {
    for_each_piece_at(sides.source.mesh, fan, met, at_source, [&](std::uint32_t piece, HalfedgeId h) {
      const FanId image = sides.target.mesh.fan(patchwork.image(h));
      ++pieces[piece].evidence.source_extraordinary;
      pieces[piece].evidence.agreeing += sides.source.codes[fan] == sides.target.codes[image];
    });
  }
  for (const FanId fan : sides.target.separatrices.nodes) {
    for_each_piece_at(sides.target.mesh, fan, met, at_target,
                      [&](std::uint32_t piece, HalfedgeId) { ++pieces[piece].evidence.target_extraordinary; });
  }
}

Match assemble(const Sides& sides, std::vector<Piece> pieces, Orientation orientation, bool with_waves) {
  Match match;
  match.regions.reserve(pieces.size());
  for (Piece& piece : pieces) {
    Region& region = match.regions.emplace_back();
    region.orientation = orientation;
    region.evidence = piece.evidence;
    region.ways = piece.ways;
    region.ambiguous = piece.ambiguous;
    reserve_on_large_pages(region.faces, piece.pairs.size());
    for (const Candidate& pair : piece.pairs) region.faces.push_back(face_pair(sides, pair, orientation));
    if (with_waves) region.waves = std::move(piece.waves);
  }
  return match;
}

std::vector<VertexPair> combined_vertices(const Mesh& source, const Mesh& target, const std::vector<Region>& regions) {
  const bool may_disagree = regions.size() > 1;  // a region by itself is one-to-one
  PerVertex<VertexId> image(source.vertex_count()), origin(may_disagree ? target.vertex_count() : 0);
  for (const Region& region : regions) {
    for (std::size_t k = 0; k < region.faces.size(); ++k) {
      const FacePair& ahead = region.faces[std::min(k + kAhead, region.faces.size() - 1)];
      source.prefetch_corners(source.first(ahead.source));
      target.prefetch_corners(target.first(ahead.target));
      const FacePair& pair = region.faces[k];
      const std::uint32_t size = source.size(pair.source);
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const VertexId v = source.corners()[source.first(pair.source).value + corner];
        if (image[v].valid()) continue;
        const std::uint32_t other = image_corner(region.orientation, pair.rotation, corner, size);
        const VertexId w = target.corners()[target.first(pair.target).value + other];
        if (may_disagree && std::exchange(origin[w], origin[w].valid() ? origin[w] : v).valid()) continue;
        image[v] = w;
      }
    }
  }
  std::vector<VertexPair> pairs;
  reserve_on_large_pages(pairs, source.vertex_count());
  for (std::uint32_t v = 0; v < image.size(); ++v) {
    if (image[VertexId(v)].valid()) pairs.push_back({VertexId(v), image[VertexId(v)]});
  }
  return pairs;
}

}  // namespace quadmatch::regions
