#include "assemble.hpp"

#include <algorithm>
#include <utility>

namespace quadmatch::regions {
namespace {

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
  explicit Assembly(const Sides& sides)
      : sides_(sides),
        image_(sides.source.mesh.vertex_count()),
        origin_(sides.target.mesh.vertex_count()),
        seen_(sides.source.mesh.vertex_count()) {}

  Region region_of(const Piece& piece, Orientation orientation) {
    Region region;
    region.orientation = orientation;
    region.faces.reserve(piece.pairs.size());
    seen_.start();
    for (const Candidate& pair : piece.pairs) {
      region.faces.push_back(face_pair(pair, orientation));
      note_vertices(pair, region.evidence);
    }
    return region;
  }

  [[nodiscard]] std::vector<VertexPair> vertices() const {
    std::vector<VertexPair> pairs;
    for (std::uint32_t v = 0; v < image_.size(); ++v) {
      if (image_[VertexId(v)].valid()) pairs.push_back({VertexId(v), image_[VertexId(v)]});
    }
    return pairs;
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
  /// Larger regions come first, and keep what they have.
  void note_vertices(const Candidate& pair, Evidence& evidence) {
    auto [s, t] = pair;
    do {
      const VertexId v = sides_.source.mesh.origin(s), w = sides_.target.mesh.origin(t);
      if (seen_.add(v)) {
        const VertexCode left = sides_.source.code(v), right = sides_.target.code(w);
        evidence.source_extraordinary += left.extraordinary();
        evidence.target_extraordinary += right.extraordinary();
        evidence.agreeing += left.extraordinary() && left == right;
        if (!image_[v].valid() && !origin_[w].valid()) {
          image_[v] = w;
          origin_[w] = v;
        }
      }
      s = sides_.source.mesh.next(s);
      t = sides_.target.mesh.next(t);
    } while (s != pair.source);
  }

  const Sides& sides_;
  PerVertex<VertexId> image_, origin_;
  Seen seen_;
};

}  // namespace

Match assemble(const Sides& sides, std::vector<Piece> pieces, Orientation orientation, bool with_waves) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.pairs.size() > b.pairs.size(); });
  Assembly assembly(sides);
  Match match;
  for (Piece& piece : pieces) {
    match.regions.push_back(assembly.region_of(piece, orientation));
    if (with_waves) match.regions.back().waves = std::move(piece.waves);
  }
  match.vertices = assembly.vertices();
  return match;
}

}  // namespace quadmatch::regions
