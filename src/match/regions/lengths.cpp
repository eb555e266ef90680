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
  const std::size_t size = mesh_->size(face);
  const std::span<const VertexId> corners = mesh_->corners().subspan(mesh_->first(face).value, size);
  const auto place = [&](std::size_t corner) -> const Point& {
    return mesh_->positions()[corners[corner < size ? corner : corner - size].value];
  };
  const std::size_t first = pairs_.size();
  for (std::size_t corner = 0; corner < size; ++corner) {
    const float edge = log_distance(place(corner), place(corner + 1));
    // A quad's second half of the diagonals is its first from the other end.
    const float diagonal =
        size == 4 && corner >= 2 ? pairs_[first + corner - 2].diagonal : log_distance(place(corner), place(corner + 2));
    pairs_.push_back({edge, diagonal});
  }
  first_[face] = static_cast<std::uint32_t>(first);
}

float Lengths::single_edge(HalfedgeId h) const {
  if (first_[mesh_->face(h)] != kUnknown) return edge(h);
  return log_distance(mesh_->positions()[mesh_->origin(h).value], mesh_->positions()[mesh_->tip(h).value]);
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
