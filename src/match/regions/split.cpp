#include "split.hpp"

#include <utility>

namespace quadmatch::regions {
namespace {

class Splitter {
 public:
  Splitter(const Sides& sides, Patchwork& patchwork)
      : source_(sides.source.mesh),
        target_(sides.target.mesh),
        patchwork_(patchwork),
        piece_of_(source_.face_count(), kNone),
        source_vertices_(source_.vertex_count()),
        target_vertices_(target_.vertex_count()) {}

  std::vector<Piece> split() {
    for (const HalfedgeId start : patchwork_.history()) {
      const FaceId face = source_.face(start);
      if (patchwork_.is_matched(face) && piece_of_[face] == kNone) walk(start);
    }
    for (const Piece& piece : pieces_) {
      const std::uint32_t region = patchwork_.fresh_region();
      for (const Candidate& pair : piece.pairs) patchwork_.set_region(source_.face(pair.source), region);
    }
    return std::move(pieces_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// The partner of a vertex, as far as the piece sees it that noted it last.
  struct Partner {
    std::uint32_t piece = kNone;
    VertexId vertex;
  };

  void walk(HalfedgeId start) {
    number_ = static_cast<std::uint32_t>(pieces_.size());
    pieces_.emplace_back();
    Piece& piece = pieces_.back();
    label_ = piece.region = patchwork_.region(source_.face(start));
    accept({start, patchwork_.image(start)}, piece);
    for (std::size_t here = 0; here < piece.pairs.size(); ++here) {
      if (piece.waves.empty() || here == piece.waves.back()) {
        piece.waves.push_back(static_cast<std::uint32_t>(piece.pairs.size()));
      }
      auto [s, t] = piece.pairs[here];
      const HalfedgeId entry = s;
      do {
        const Candidate beyond{source_.twin(s), target_.twin(t)};
        if (beyond.source.valid() && beyond.target.valid() && continues(beyond) && fits(beyond)) accept(beyond, piece);
        s = source_.next(s);
        t = target_.next(t);
      } while (s != entry);
    }
  }

  [[nodiscard]] bool continues(Candidate candidate) const {
    const FaceId face = source_.face(candidate.source);
    return patchwork_.is_matched(face) && patchwork_.region(face) == label_ && piece_of_[face] == kNone &&
           patchwork_.image(candidate.source) == candidate.target;
  }
  [[nodiscard]] bool fits(Candidate candidate) const {
    auto [s, t] = candidate;
    do {
      const VertexId v = source_.origin(s), w = target_.origin(t);
      const Partner& left = source_vertices_[v];
      const Partner& right = target_vertices_[w];
      if (left.piece == number_ ? left.vertex != w : right.piece == number_) return false;
      if (!edge_fits(s, t)) return false;
      s = source_.next(s);
      t = target_.next(t);
    } while (s != candidate.source);
    return true;
  }
  [[nodiscard]] bool edge_fits(HalfedgeId s, HalfedgeId t) const {
    const HalfedgeId beside = source_.twin(s);
    const HalfedgeId beside_target = target_.twin(t);
    if (beside.valid() && piece_of_[source_.face(beside)] == number_) return patchwork_.image(beside) == beside_target;
    if (!beside_target.valid() || !patchwork_.is_taken(target_.face(beside_target))) return true;
    return piece_of_[patchwork_.origin(target_.face(beside_target))] != number_;
  }
  void accept(Candidate candidate, Piece& piece) {
    piece_of_[source_.face(candidate.source)] = number_;
    piece.pairs.push_back(candidate);
    auto [s, t] = candidate;
    do {
      source_vertices_[source_.origin(s)] = {number_, target_.origin(t)};
      target_vertices_[target_.origin(t)] = {number_, source_.origin(s)};
      s = source_.next(s);
      t = target_.next(t);
    } while (s != candidate.source);
  }

  const Mesh& source_;
  const Mesh& target_;
  Patchwork& patchwork_;
  PerFace<std::uint32_t> piece_of_;
  PerVertex<Partner> source_vertices_, target_vertices_;
  std::vector<Piece> pieces_;
  std::uint32_t number_ = 0;
  std::uint32_t label_ = 0;
};

}  // namespace

std::vector<Piece> split(const Sides& sides, Patchwork& patchwork) { return Splitter(sides, patchwork).split(); }

}  // namespace quadmatch::regions
