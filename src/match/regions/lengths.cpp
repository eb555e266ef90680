#include "lengths.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadmatch::regions {
namespace {

float log_distance(const Point& a, const Point& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  constexpr double kTiny = 1e-30, kVast = 1e30;  // two vertices in one place, and what is beyond all sense
  return 0.5F * std::log(static_cast<float>(std::clamp(x * x + y * y + z * z, kTiny, kVast)));
}

}  // namespace

Lengths::Lengths(const Mesh& mesh) : at_(mesh.halfedge_count()) {
  const std::span<const Point> positions = mesh.positions();
  for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
    const HalfedgeId h(number), next = mesh.next(h), twin = mesh.twin(h);
    const Point& here = positions[mesh.origin(h).value];
    at_[h].edge = twin < h ? at_[twin].edge : log_distance(here, positions[mesh.origin(next).value]);
    // A quad's second half of the diagonals is its first from the other end.
    const HalfedgeId opposite = mesh.next(next);
    const bool known = opposite < h && mesh.next(mesh.next(opposite)) == h;
    at_[h].diagonal = known ? at_[opposite].diagonal : log_distance(here, positions[mesh.origin(opposite).value]);
  }
}

float Lengths::median_edge() const {
  std::vector<float> lengths;
  lengths.reserve(at_.size());
  for (const Pair& pair : at_) lengths.push_back(pair.edge);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() - 1) / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace quadmatch::regions
