// Exact ties: a symmetric part lies as well on itself turned round, and neither corners nor lengths can tell. Where the
// model did not move, or moved as a whole, positions can.

#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

/// A face whose image is farther than this, in edges, is asked whether it lies right.
constexpr double kFar = 0.3;

class Ties {
 public:
  explicit Ties(Workbench& bench)
      : bench_(bench),
        placement_(*bench.misfit.placement()),
        edge_(bench.misfit.edge()),
        landings_(source_.vertex_count()),
        tried_(source_.face_count(), false) {}

  std::size_t settle() {
    std::size_t changed = 0;
    const auto consider = [&](HalfedgeId entry) {
      if (spent_ > budget_ || tried_[source_.face(entry)] || lies_near(entry)) return;
      const Candidate seed = nearest_pair(entry);
      if (!seed.target.valid()) return;
      changed += lay(seed);
    };
    const std::vector<HalfedgeId> history = bench_.patchwork.history();
    for (const HalfedgeId entry : history) consider(entry);
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      if (!bench_.patchwork.is_matched(FaceId(f))) consider(source_.first(FaceId(f)));
    }
    return changed;
  }

 private:
  /// The target vertex on which one of the source lands, if any is near; found when it is first asked for.
  struct Landing {
    bool known = false;
    VertexId vertex;
  };

  [[nodiscard]] bool lies_near(HalfedgeId entry) const {
    return bench_.patchwork.is_matched(source_.face(entry)) &&
           bench_.misfit.distance({entry, bench_.patchwork.image(entry)}) < kFar;
  }
  /// The target face whose corners are where these land, if there is one.
  [[nodiscard]] Candidate nearest_pair(HalfedgeId entry) {
    const VertexId w = landing(entry);
    if (!w.valid()) return {};
    const HalfedgeId some = target_.halfedge(FanId(w.value));
    if (!some.valid()) return {};
    for (const HalfedgeId t : target_.outgoing(FanId(w.value))) {
      if (corners_land(entry, t)) return {entry, t};
    }
    return {};
  }
  [[nodiscard]] VertexId landing(HalfedgeId s) {
    const VertexId v = source_.origin(s);
    Landing& landing = landings_[v];
    if (!landing.known) {
      landing = {true, bench_.target_grid->nearest(placement_(source_.positions()[v.value]), kFar * edge_)};
    }
    return landing.vertex;
  }
  [[nodiscard]] bool corners_land(HalfedgeId entry, HalfedgeId t) {
    if (source_.size(source_.face(entry)) != target_.size(target_.face(t))) return false;
    HalfedgeId s = entry;
    do {
      if (landing(s) != target_.origin(t)) return false;
      s = source_.next(s);
      t = target_.next(t);
    } while (s != entry);
    return true;
  }
  std::size_t lay(Candidate seed) {
    if (!extend_seed(bench_, seed, kSeedFaces, true)) return 0;
    for (const Candidate& pair : bench_.ghost.pairs()) {
      if (bench_.misfit.distance(pair) < kFar) tried_[source_.face(pair.source)] = true;
    }
    spent_ += kSeedCost + bench_.ghost.pairs().size();
    return expand(bench_, bench_.patchwork.fresh_region());
  }

  Workbench& bench_;
  Similarity placement_;
  double edge_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  PerVertex<Landing> landings_;
  PerFace<bool> tried_;
  std::size_t budget_ = kSeedsBudget * source_.face_count(), spent_ = 0;
};

}  // namespace

std::size_t settle_ties(Workbench& bench) {
  const std::size_t changed = Ties(bench).settle();
  bench.ghost.restart();
  return changed;
}

}  // namespace quadmatch::regions
