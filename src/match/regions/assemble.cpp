#include "assemble.hpp"

#include <algorithm>
#include <utility>

namespace quadmatch::regions {
namespace {

/// How many pairs ahead the corners of faces are asked for: long enough for memory to answer.
constexpr std::size_t kAhead = 16;

/// Notes which vertices have been seen, region after region.
class Seen {
 public:
  explicit Seen(std::size_t vertices) : last_(vertices, 0) {}
  void start() { ++now_; }
  /// @return true the first time since start().
  bool add(VertexId v) { return std::exchange(last_[v], now_) != now_; }

 private:
  PerVertex<std::uint32_t> last_;
  std::uint32_t now_ = 0;
};

class Assembly {
 public:
  explicit Assembly(const Sides& sides) : sides_(sides), seen_(sides.source.mesh.vertex_count()) {}

  Region region_of(const Piece& piece, Orientation orientation) {
    Region region;
    region.orientation = orientation;
    region.ways = piece.ways;
    region.ambiguous = piece.ambiguous;
    region.faces.reserve(piece.pairs.size());
    seen_.start();
    for (std::size_t k = 0; k < piece.pairs.size(); ++k) {
      const Candidate& ahead = piece.pairs[std::min(k + kAhead, piece.pairs.size() - 1)];
      sides_.source.mesh.prefetch_corners(ahead.source);
      sides_.target.mesh.prefetch_corners(ahead.target);
      region.faces.push_back(face_pair(piece.pairs[k], orientation));
      weigh_vertices(piece.pairs[k], region.evidence);
    }
    return region;
  }

 private:
  [[nodiscard]] FacePair face_pair(const Candidate& pair, Orientation orientation) const {
    const Mesh& source = sides_.source.mesh;
    const Mesh& target = sides_.target.mesh;
    const FaceId q = source.face(pair.source), r = target.face(pair.target);
    const std::uint32_t size = source.size(q);
    const std::uint32_t corner = (target.corner(pair.target) + size - source.corner(pair.source)) % size;
    // In the mirror corner k is corner n - 1 - k of the face as it was given (Mesh::mirrored).
    return {q, r, orientation == Orientation::Preserving ? corner : size - 1 - corner};
  }
  void weigh_vertices(const Candidate& pair, Evidence& evidence) {
    auto [s, t] = pair;
    do {
      const VertexId v = sides_.source.mesh.origin(s), w = sides_.target.mesh.origin(t);
      const VertexCode left = sides_.source.code(v), right = sides_.target.code(w);
      if ((left.extraordinary() || right.extraordinary()) && seen_.add(v)) {
        evidence.source_extraordinary += left.extraordinary();
        evidence.target_extraordinary += right.extraordinary();
        evidence.agreeing += left.extraordinary() && left == right;
      }
      s = sides_.source.mesh.next(s);
      t = sides_.target.mesh.next(t);
    } while (s != pair.source);
  }

  const Sides& sides_;
  Seen seen_;
};

}  // namespace

Match assemble(const Sides& sides, std::vector<Piece> pieces, Orientation orientation, bool with_waves) {
  Assembly assembly(sides);
  Match match;
  match.regions.reserve(pieces.size());
  for (Piece& piece : pieces) {
    match.regions.push_back(assembly.region_of(piece, orientation));
    if (with_waves) match.regions.back().waves = std::move(piece.waves);
  }
  return match;
}

std::vector<VertexPair> combined_vertices(const Mesh& source, const Mesh& target, const std::vector<Region>& regions) {
  PerVertex<VertexId> image(source.vertex_count()), origin(target.vertex_count());
  for (const Region& region : regions) {
    for (std::size_t k = 0; k < region.faces.size(); ++k) {
      const FacePair& ahead = region.faces[std::min(k + kAhead, region.faces.size() - 1)];
      source.prefetch_corners(source.first(ahead.source));
      target.prefetch_corners(target.first(ahead.target));
      const FacePair& pair = region.faces[k];
      const std::uint32_t size = source.size(pair.source);
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const std::uint32_t other = image_corner(region.orientation, pair.rotation, corner, size);
        const VertexId v = source.corners()[source.first(pair.source).value + corner];
        const VertexId w = target.corners()[target.first(pair.target).value + other];
        if (image[v].valid() || origin[w].valid()) continue;
        image[v] = w;
        origin[w] = v;
      }
    }
  }
  std::vector<VertexPair> pairs;
  pairs.reserve(source.vertex_count());
  for (std::uint32_t v = 0; v < image.size(); ++v) {
    if (image[VertexId(v)].valid()) pairs.push_back({VertexId(v), image[VertexId(v)]});
  }
  return pairs;
}

}  // namespace quadmatch::regions
