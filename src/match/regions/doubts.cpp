// Doubts: which of two rows of quads was taken out, and which half of a row that was cut in two is the old one, nobody
// can know where nothing else tells. What lies as well on something else is set apart, to be called ambiguous.

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

/// Another map that costs at most so much more, by face that it changes, is as good.
constexpr double kTie = 0.05;

class Doubts {
 public:
  explicit Doubts(Workbench& bench) : bench_(bench) {}

  /// @return the regions of their own that doubtful faces now form.
  std::vector<std::uint32_t> set_apart() {
    for (const auto& [region, faces] : largest_first(bench_.patchwork)) {
      extend_region(bench_, bench_.rim.entries(region), region, most_faces_beyond(faces));
      for (const Candidate& pair : would_join(bench_, kTie)) doubt(pair);
    }
    bench_.ghost.restart();
    return give_own_regions();
  }

 private:
  /// A face, after the region that it has now.
  using Doubtful = std::pair<std::uint32_t, FaceId>;

  /// What a pair would take away: the partner of its source face, and that of its target face.
  void doubt(Candidate pair) {
    const FaceId face = bench_.sides.source.mesh.face(pair.source);
    const FaceId owner = bench_.patchwork.origin(bench_.sides.target.mesh.face(pair.target));
    for (const FaceId matched : {face, owner}) {
      if (!matched.valid() || !bench_.patchwork.is_matched(matched)) continue;
      doubtful_.emplace_back(bench_.patchwork.region(matched), matched);
    }
  }
  [[nodiscard]] std::vector<std::uint32_t> give_own_regions() {
    std::sort(doubtful_.begin(), doubtful_.end());
    std::vector<std::uint32_t> apart;
    std::uint32_t from = Patchwork::kNoRegion;
    for (const auto& [region, face] : doubtful_) {
      if (std::exchange(from, region) != region) apart.push_back(bench_.patchwork.fresh_region());
      bench_.patchwork.set_region(face, apart.back());
    }
    return apart;
  }

  Workbench& bench_;
  std::vector<Doubtful> doubtful_;
};

}  // namespace

std::vector<std::uint32_t> set_doubts_apart(Workbench& bench) { return Doubts(bench).set_apart(); }

}  // namespace quadmatch::regions
