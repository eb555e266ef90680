// Half-edges from a polygon soup: §2.1's operations, in arrays.

#include <quadmatch/mesh/mesh.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/mesh/large_pages.hpp>

namespace quadmatch {
namespace {

constexpr std::size_t kMostCorners = 0x7fffffff;

Expected<void> check_faces(const PolygonSoup& soup) {
  const bool quads = soup.face_starts.empty();
  if (soup.corners.size() > kMostCorners) {
    return Unexpected(Error{ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 face corners; split it"});
  }
  if (quads ? soup.corners.size() % 4 != 0
            : soup.face_starts.front() != 0 || soup.face_starts.back() != soup.corners.size()) {
    return Unexpected(Error{ErrorCode::BadIndex, "the face starts do not divide the corners into faces"});
  }
  const std::size_t faces = quads ? soup.corners.size() / 4 : soup.face_starts.size() - 1;
  for (std::size_t f = 0; !quads && f < faces; ++f) {
    const std::uint32_t start = soup.face_starts[f];
    const std::uint32_t end = soup.face_starts[f + 1];
    if (end < start + 3) {
      return Unexpected(Error{ErrorCode::TooFewCorners, fmt::format("face f{} has fewer than three corners", f)});
    }
  }
  for (std::size_t corner = 0; corner < soup.corners.size(); ++corner) {
    if (soup.corners[corner].value < soup.vertex_count) continue;
    const auto after = std::upper_bound(soup.face_starts.begin(), soup.face_starts.end(), corner);
    const std::size_t face = quads ? corner / 4 : static_cast<std::size_t>(after - soup.face_starts.begin()) - 1;
    return Unexpected(
        Error{ErrorCode::BadIndex, fmt::format("face f{} names vertex v{}, but there are only {} vertices", face,
                                               soup.corners[corner].value, soup.vertex_count)});
  }
  return {};
}

/// A half-edge filed under the lower of its ends: the higher end, and the half-edge with its direction on top.
struct EdgeUse {
  std::uint32_t high;
  std::uint32_t halfedge_and_direction;

  static constexpr std::uint32_t kDownward = 0x80000000;

  [[nodiscard]] HalfedgeId halfedge() const { return HalfedgeId(halfedge_and_direction & ~kDownward); }
  [[nodiscard]] bool downward() const { return (halfedge_and_direction & kDownward) != 0; }
  bool operator<(const EdgeUse& other) const {
    return high != other.high ? high < other.high : halfedge().value < other.halfedge().value;
  }
};

/// Sort the few uses at one vertex; most vertices have two to four.
void sort_uses(EdgeUse* begin, EdgeUse* end) {
  if (end - begin > 16) {
    std::sort(begin, end);
    return;
  }
  for (EdgeUse* here = begin; here != end; ++here) {
    for (EdgeUse* back = here; back != begin && *back < *(back - 1); --back) std::swap(*back, *(back - 1));
  }
}

}  // namespace

Expected<Mesh> Mesh::build(PolygonSoup soup) {
  if (Expected<void> fine = check_faces(soup); !fine) return Unexpected(std::move(fine).error());

  Mesh mesh;
  mesh.vertex_count_ = soup.vertex_count;
  mesh.positions_ = std::move(soup.positions);
  mesh.origin_ = std::move(soup.corners);
  const std::uint32_t corners = mesh.halfedge_count();
  bool quads = true;
  for (std::size_t f = 0; f + 1 < soup.face_starts.size(); ++f) {
    quads = quads && soup.face_starts[f + 1] == soup.face_starts[f] + 4;
  }
  if (quads) {
    mesh.face_count_ = corners / 4;
  } else {
    mesh.face_starts_ = std::move(soup.face_starts);
    mesh.face_count_ = static_cast<std::uint32_t>(mesh.face_starts_.size()) - 1;
    assign_on_large_pages(mesh.face_of_, corners, std::uint32_t{0});
    for (std::uint32_t f = 0; f < mesh.face_count_; ++f) {
      std::fill(mesh.face_of_.begin() + mesh.face_starts_[f], mesh.face_of_.begin() + mesh.face_starts_[f + 1], f);
    }
  }
  mesh.pair_twins();
  mesh.gather_fans();
  return mesh;
}

/// Twins by a counting sort of the half-edges by their lower end: linear, and blind to the order of the faces.
void Mesh::pair_twins() {
  const std::uint32_t count = halfedge_count();
  assign_on_large_pages(twin_, count, HalfedgeId());
  std::vector<std::uint32_t> starts;
  assign_on_large_pages(starts, std::size_t{vertex_count_} + 1, std::uint32_t{0});
  const auto ends_of = [this](std::uint32_t h) { return std::pair(origin_[h].value, tip(HalfedgeId(h)).value); };
  for (std::uint32_t h = 0; h < count; ++h) {
    const auto [from, to] = ends_of(h);
    if (from == to) {
      seams_.push_back({VertexId(from), VertexId(to), SeamKind::Degenerate, 1});
    } else {
      ++starts[std::min(from, to) + 1];
    }
  }
  for (std::uint32_t v = 0; v < vertex_count_; ++v) starts[v + 1] += starts[v];

  std::vector<EdgeUse> uses;
  assign_on_large_pages(uses, starts.back(), EdgeUse());
  std::vector<std::uint32_t> filled;
  reserve_on_large_pages(filled, vertex_count_);
  filled.assign(starts.begin(), starts.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h) {
    const auto [from, to] = ends_of(h);
    if (from == to) continue;
    uses[filled[std::min(from, to)]++] = {std::max(from, to), from > to ? h | EdgeUse::kDownward : h};
  }

  edge_count_ = count;
  for (std::uint32_t v = 0; v < vertex_count_; ++v) {
    EdgeUse* const begin = uses.data() + starts[v];
    EdgeUse* const end = uses.data() + starts[v + 1];
    sort_uses(begin, end);
    for (EdgeUse *first = begin, *last = begin; first != end; first = last) {
      while (last != end && last->high == first->high) ++last;
      const std::ptrdiff_t along = last - first;
      if (along == 1) continue;
      const HalfedgeId one = first->halfedge();
      const HalfedgeId other = first[1].halfedge();
      if (along == 2 && first->downward() != first[1].downward() && face(one) != face(other)) {
        twin_[one.value] = other;
        twin_[other.value] = one;
        --edge_count_;
      } else {
        const SeamKind kind = along > 2                                  ? SeamKind::NonManifold
                              : first->downward() == first[1].downward() ? SeamKind::Winding
                                                                         : SeamKind::SelfGlued;
        seams_.push_back({VertexId(v), VertexId(first->high), kind, static_cast<std::uint32_t>(along)});
      }
    }
  }
  std::sort(seams_.begin(), seams_.end(),
            [](const Seam& a, const Seam& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
}

/// Walk around every vertex; what the first walk does not reach is a further fan.
void Mesh::gather_fans() {
  assign_on_large_pages(fan_start_, vertex_count_, HalfedgeId());
  std::vector<bool> walked(halfedge_count(), false);
  std::vector<std::pair<HalfedgeId, FanId>> further;
  for (std::uint32_t number = 0; number < halfedge_count(); ++number) {
    if (walked[number]) continue;
    HalfedgeId start(number);
    for (HalfedgeId h = rotate_cw(start); h.valid() && h.value != number; h = rotate_cw(h)) start = h;
    if (rotate_cw(start).valid()) start = HalfedgeId(number);  // a full circle begins at its lowest half-edge
    const VertexId v = origin(start);
    FanId fan(v.value);
    if (fan_start_[v.value].valid()) {
      fan = FanId(static_cast<std::uint32_t>(fan_start_.size()));
      fan_start_.push_back(start);
      further_fan_vertex_.push_back(v);
      further.emplace_back(start, fan);
    } else {
      fan_start_[v.value] = start;
    }
    for (const HalfedgeId h : outgoing(fan)) walked[h.value] = true;
  }
  if (further.empty()) return;

  assign_on_large_pages(fan_of_, halfedge_count(), std::uint32_t{0});
  for (std::uint32_t h = 0; h < halfedge_count(); ++h) fan_of_[h] = origin_[h].value;
  for (const auto& [start, fan] : further) {
    for (const HalfedgeId h : outgoing(fan)) fan_of_[h.value] = fan.value;
  }
  split_vertices_ = further_fan_vertex_;
  std::sort(split_vertices_.begin(), split_vertices_.end());
  split_vertices_.erase(std::unique(split_vertices_.begin(), split_vertices_.end()), split_vertices_.end());
}

std::uint32_t Mesh::valence(FanId p) const {
  std::uint32_t faces = 0;
  for ([[maybe_unused]] const HalfedgeId h : outgoing(p)) ++faces;
  return faces + (is_boundary(p) ? 1 : 0);
}

Mesh Mesh::mirrored() const {
  Mesh mirror = *this;
  // Corner k of a face becomes corner n - 1 - k, so the side that left corner k leaves corner n - 2 - k.
  const auto reversed_side = [this](HalfedgeId h) {
    const FaceId f = face(h);
    const std::uint32_t n = size(f);
    return HalfedgeId(first(f).value + (2 * n - 2 - corner(h)) % n);
  };
  for (std::uint32_t number = 0; number < halfedge_count(); ++number) {
    const HalfedgeId h(number);
    const HalfedgeId reversed = reversed_side(h);
    const HalfedgeId other = twin(h);
    mirror.origin_[reversed.value] = tip(h);
    mirror.twin_[reversed.value] = other.valid() ? reversed_side(other) : other;
    if (!fan_of_.empty()) mirror.fan_of_[reversed.value] = fan_of_[next(h).value];
  }
  for (std::uint32_t p = 0; p < fan_count(); ++p) {
    HalfedgeId last = fan_start_[p];
    if (!last.valid()) continue;
    for (const HalfedgeId h : outgoing(FanId(p))) last = h;
    mirror.fan_start_[p] = reversed_side(prev(last));  // the last edge counter-clockwise is the first in the mirror
  }
  return mirror;
}

}  // namespace quadmatch
