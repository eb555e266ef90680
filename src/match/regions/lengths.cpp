#include "lengths.hpp"

#include <algorithm>
#include <cmath>

#include "nth_smallest.hpp"

namespace quadmatch::regions {
namespace {

float log_distance(const Point& a, const Point& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  constexpr double kTiny = 1e-30, kVast = 1e30;  // two vertices in one place, and what is beyond all sense
  return 0.5F * std::log(static_cast<float>(std::clamp(x * x + y * y + z * z, kTiny, kVast)));
}

}  // namespace

Lengths::Lengths(const Mesh& mesh) : mesh_(&mesh), first_(mesh.face_count(), kUnknown) {
  pairs_.reserve(mesh.halfedge_count());
}

void Lengths::measure(FaceId face) const {
  const std::span<const Point> positions = mesh_->positions();
  const std::size_t first = pairs_.size();
  for (const HalfedgeId h : mesh_->halfedges(face)) {
    const HalfedgeId next = mesh_->next(h);
    const Point& here = positions[mesh_->origin(h).value];
    const float edge = log_distance(here, positions[mesh_->origin(next).value]);
    // A quad's second half of the diagonals is its first from the other end.
    const std::size_t corner = pairs_.size() - first;
    const float diagonal = mesh_->size(face) == 4 && corner >= 2
                               ? pairs_[first + corner - 2].diagonal
                               : log_distance(here, positions[mesh_->tip(next).value]);
    pairs_.push_back({edge, diagonal});
  }
  first_[face] = static_cast<std::uint32_t>(first);
}

void Lengths::measure_all() const {
  for (std::uint32_t f = 0; f < mesh_->face_count(); ++f) {
    if (first_[FaceId(f)] == kUnknown) measure(FaceId(f));
  }
}

float Lengths::median_edge() const {
  measure_all();
  std::vector<float> lengths;
  lengths.reserve(pairs_.size());
  for (const Pair& pair : pairs_) lengths.push_back(pair.edge);
  return nth_smallest(lengths, (lengths.size() - 1) / 2);
}

}  // namespace quadmatch::regions
