// Condition 4 of §2.1. Two quads that share three vertices have a diagonal of one of them in common, and so have two
// that share two vertices otherwise than by a common edge. So it is enough to look at pairs of vertices that are a
// diagonal of some quad and belong to another quad as well; a clean mesh has none.

#include "overlaps.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace quadmatch {
namespace {

constexpr std::uint32_t kDiagonal = 0x80000000;

/// Two vertices of a quad, filed under the lower one. Quads are fewer than 2^29, so the top bit is free.
struct PairUse {
  std::uint32_t high;
  std::uint32_t face_and_kind;

  [[nodiscard]] FaceId face() const { return FaceId(face_and_kind & ~kDiagonal); }
  [[nodiscard]] bool diagonal() const { return (face_and_kind & kDiagonal) != 0; }
  bool operator<(const PairUse& other) const { return high != other.high ? high < other.high : face() < other.face(); }
};

using Quad = std::array<std::uint32_t, 4>;

Quad corners_of(const Mesh& mesh, FaceId face) {
  const VertexId* const corner = mesh.corners().data() + mesh.first(face).value;
  return {corner[0].value, corner[1].value, corner[2].value, corner[3].value};
}

bool is_proper_quad(const Mesh& mesh, FaceId face) {
  if (mesh.size(face) != 4) return false;
  const auto [a, b, c, d] = corners_of(mesh, face);
  return a != b && a != c && a != d && b != c && b != d && c != d;
}

/// Call `use(low, high, kind)` for the four sides and two diagonals of every proper quad.
template <class Use>
void for_each_pair(const Mesh& mesh, Use use) {
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (!is_proper_quad(mesh, FaceId(f))) continue;
    const Quad corner = corners_of(mesh, FaceId(f));
    for (std::uint32_t i = 0; i < 4; ++i) {
      for (std::uint32_t j = i + 1; j < 4; ++j) {
        const auto [low, high] = std::minmax(corner[i], corner[j]);
        use(low, high, f | (j == i + 2 ? kDiagonal : 0));
      }
    }
  }
}

/// Pairs of faces with two vertices in common that are a diagonal of one of them.
void list_suspects(std::span<const PairUse> sharing, std::vector<Overlap>& suspects) {
  constexpr std::size_t kMostCompared = 32;
  const auto diagonal = std::find_if(sharing.begin(), sharing.end(), [](const PairUse& use) { return use.diagonal(); });
  if (sharing.size() < 2 || diagonal == sharing.end()) return;
  const auto list = [&suspects](const PairUse& a, const PairUse& b) {
    suspects.push_back({std::min(a.face(), b.face()), std::max(a.face(), b.face())});
  };
  if (sharing.size() > kMostCompared) {
    for (const PairUse& use : sharing) {
      if (use.face() != diagonal->face()) list(use, *diagonal);
    }
    return;
  }
  for (std::size_t i = 0; i < sharing.size(); ++i) {
    for (std::size_t j = i + 1; j < sharing.size(); ++j) {
      if (sharing[i].diagonal() || sharing[j].diagonal()) list(sharing[i], sharing[j]);
    }
  }
}

/// Count what two quads share.
Overlap meeting(const Mesh& mesh, FaceId one, FaceId other) {
  Overlap overlap{one, other};
  const Quad a = corners_of(mesh, one);
  const Quad b = corners_of(mesh, other);
  for (std::size_t i = 0; i < 4; ++i) {
    overlap.shared_vertices += static_cast<std::uint32_t>(std::count(b.begin(), b.end(), a[i]));
    for (std::size_t j = 0; j < 4; ++j) {
      overlap.shared_edges += std::minmax(a[i], a[(i + 1) % 4]) == std::minmax(b[j], b[(j + 1) % 4]) ? 1 : 0;
    }
  }
  return overlap;
}

/// Where each vertex's share starts, from the counts of the vertices before it: `counts` has one more than vertices.
void accumulate(std::vector<std::uint32_t>& counts) {
  std::uint32_t sum = 0;
  for (std::uint32_t& count : counts) sum += std::exchange(count, sum);
}

/// A face's vertices in ascending order, by which duplicates are told.
std::vector<VertexId> sorted_corners(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.corners().subspan(mesh.first(face).value, mesh.size(face));
  std::vector<VertexId> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

VertexId lowest_corner(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.corners().subspan(mesh.first(face).value, mesh.size(face));
  return *std::min_element(corners.begin(), corners.end());
}

}  // namespace

std::vector<Overlap> overlapping_quads(const Mesh& mesh) {
  std::vector<std::uint32_t> starts(std::size_t{mesh.vertex_count()} + 1, 0);
  for_each_pair(mesh, [&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++starts[low]; });
  accumulate(starts);
  std::vector<PairUse> uses(starts.back());
  std::vector<std::uint32_t> filled(starts.begin(), starts.end() - 1);
  for_each_pair(mesh, [&](std::uint32_t low, std::uint32_t high, std::uint32_t face_and_kind) {
    uses[filled[low]++] = {high, face_and_kind};
  });

  std::vector<Overlap> suspects;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto begin = uses.begin() + starts[v];
    const auto end = uses.begin() + starts[v + 1];
    std::sort(begin, end);
    for (auto first = begin, last = begin; first != end; first = last) {
      while (last != end && last->high == first->high) ++last;
      list_suspects({first, last}, suspects);
    }
  }
  std::sort(suspects.begin(), suspects.end());
  suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());

  std::vector<Overlap> overlaps;
  for (const Overlap& suspect : suspects) {
    const Overlap overlap = meeting(mesh, suspect.one, suspect.other);
    if (overlap.shared_vertices < 4) overlaps.push_back(overlap);
  }
  return overlaps;
}

std::vector<Duplicate> duplicate_faces(const Mesh& mesh) {
  std::vector<std::uint32_t> starts(std::size_t{mesh.vertex_count()} + 1, 0);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) ++starts[lowest_corner(mesh, FaceId(f)).value];
  accumulate(starts);
  std::vector<FaceId> faces(mesh.face_count());
  std::vector<std::uint32_t> filled(starts.begin(), starts.end() - 1);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    faces[filled[lowest_corner(mesh, FaceId(f)).value]++] = FaceId(f);
  }

  std::vector<Duplicate> duplicates;
  std::vector<std::pair<std::vector<VertexId>, FaceId>> alike;  // faces of one lowest vertex, by their corners
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (starts[v + 1] - starts[v] < 2) continue;
    alike.clear();
    for (std::uint32_t i = starts[v]; i < starts[v + 1]; ++i) {
      alike.emplace_back(sorted_corners(mesh, faces[i]), faces[i]);
    }
    std::sort(alike.begin(), alike.end());
    for (std::size_t first = 0, i = 1; i < alike.size(); ++i) {
      if (alike[i].first != alike[first].first) first = i;
      if (i != first) duplicates.push_back({alike[i].second, alike[first].second});
    }
  }
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}

}  // namespace quadmatch
