#include "split.hpp"

#include <algorithm>
#include <utility>

namespace quadmatch::regions {
namespace {

class Splitter {
 public:
  Splitter(const Sides& sides, Patchwork& patchwork, const std::vector<HalfedgeId>& rim)
      : source_(sides.source.mesh),
        target_(sides.target.mesh),
        patchwork_(patchwork),
        is_calm_(source_.face_count(), true),
        piece_of_(source_.face_count(), kNone),
        source_vertices_(source_.vertex_count()),
        target_vertices_(target_.vertex_count()) {
    find_calm(rim);
  }

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

  /// A face is calm if no corner of it is one of the rim's, nor one of several fans in either mesh. All faces about
  /// such corners lie on all faces about their images: nothing can disagree there.
  void find_calm(const std::vector<HalfedgeId>& rim) {
    const auto unsettle_about = [&](HalfedgeId corner) {
      for (const HalfedgeId h : source_.outgoing(source_.fan(corner))) is_calm_[source_.face(h)] = false;
    };
    for (const HalfedgeId entry : rim) {
      for (const HalfedgeId h : source_.halfedges(source_.face(entry))) unsettle_about(h);
    }
    if (source_.split_vertices().empty() && target_.split_vertices().empty()) return;
    const auto is_split = [](const Mesh& mesh, VertexId v) {
      return std::binary_search(mesh.split_vertices().begin(), mesh.split_vertices().end(), v);
    };
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      if (!patchwork_.is_matched(FaceId(f))) continue;
      for (const HalfedgeId h : source_.halfedges(FaceId(f))) {
        const bool may_disagree =
            is_split(source_, source_.origin(h)) || is_split(target_, target_.origin(patchwork_.image(h)));
        if (may_disagree) is_calm_[FaceId(f)] = false;
      }
    }
  }

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
      const bool is_calm = is_calm_[source_.face(s)];
      do {
        const Candidate beyond{source_.twin(s), target_.twin(t)};
        if (is_calm ? piece_of_[source_.face(beyond.source)] == kNone : continues(beyond)) {
          if (fits(beyond)) accept(beyond, piece);
        }
        s = source_.next(s);
        t = target_.next(t);
      } while (s != entry);
    }
  }

  [[nodiscard]] bool continues(Candidate candidate) const {
    if (!candidate.source.valid() || !candidate.target.valid()) return false;
    const FaceId face = source_.face(candidate.source);
    return patchwork_.is_matched(face) && patchwork_.region(face) == label_ && piece_of_[face] == kNone &&
           patchwork_.image(candidate.source) == candidate.target;
  }
  [[nodiscard]] bool fits(Candidate candidate) const {
    if (is_calm_[source_.face(candidate.source)]) return true;
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
    if (is_calm_[source_.face(candidate.source)]) return;
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
  PerFace<char> is_calm_;
  PerFace<std::uint32_t> piece_of_;
  PerVertex<Partner> source_vertices_, target_vertices_;
  std::vector<Piece> pieces_;
  std::uint32_t number_ = 0;
  std::uint32_t label_ = 0;
};

}  // namespace

std::vector<Piece> split(const Sides& sides, Patchwork& patchwork, Rim& rim) {
  return Splitter(sides, patchwork, rim.entries()).split();
}

}  // namespace quadmatch::regions
