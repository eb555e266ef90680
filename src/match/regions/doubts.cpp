// Doubts: which of two rows of quads was taken out, and which half of a row that was cut in two is the old one, nobody
// can know where nothing else tells. What lies as well on something else is set apart, to be called ambiguous.

#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

/// Another map that costs at most so much more, by face that it changes, is as good.
constexpr double kTie = 0.05;

class Doubts {
 public:
  explicit Doubts(Workbench& bench) : bench_(bench), doubtful_(bench.sides.source.mesh.face_count(), false) {}

  /// @return the regions of their own that doubtful faces now form.
  std::vector<std::uint32_t> set_apart() {
    const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench_);
    for (const std::uint32_t region : largest_first(faces)) {
      extend_region(bench_, faces[region], region, most_faces_beyond(faces[region].size()));
      for (const Candidate& pair : would_join(bench_, kTie)) doubt(pair);
    }
    bench_.ghost.restart();
    std::vector<std::uint32_t> apart;
    for (const std::vector<HalfedgeId>& entries : faces) give_own_region(entries, apart);
    return apart;
  }

 private:
  /// What a pair would take away: the partner of its source face, and that of its target face.
  void doubt(Candidate pair) {
    const FaceId face = bench_.sides.source.mesh.face(pair.source);
    const FaceId owner = bench_.patchwork.origin(bench_.sides.target.mesh.face(pair.target));
    if (bench_.patchwork.is_matched(face)) doubtful_[face] = true;
    if (owner.valid()) doubtful_[owner] = true;
  }
  void give_own_region(const std::vector<HalfedgeId>& entries, std::vector<std::uint32_t>& apart) {
    bool is_first = true;
    for (const HalfedgeId entry : entries) {
      const FaceId face = bench_.sides.source.mesh.face(entry);
      if (!doubtful_[face]) continue;
      if (is_first) apart.push_back(bench_.patchwork.fresh_region());
      is_first = false;
      bench_.patchwork.set_region(face, apart.back());
    }
  }

  Workbench& bench_;
  PerFace<bool> doubtful_;
};

}  // namespace

std::vector<std::uint32_t> set_doubts_apart(Workbench& bench) { return Doubts(bench).set_apart(); }

}  // namespace quadmatch::regions
