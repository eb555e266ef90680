#include "texture_lists.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;

bool fits_corners(const Mesh& mesh, const Property& list) {
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t count = list.list_starts[f + 1] - list.list_starts[f];
    if (count != 0 && count != 2 * mesh.size(FaceId(f))) return false;
  }
  return true;
}

/// Two numbers by their bits, so that what is no number has its place too.
std::pair<std::uint64_t, std::uint64_t> bits_of(const double* pair) {
  return {std::bit_cast<std::uint64_t>(pair[0]), std::bit_cast<std::uint64_t>(pair[1])};
}

IndexedAttribute lifted(const Mesh& mesh, const Property& list) {
  std::vector<const double*> pair_of(mesh.halfedge_count(), nullptr);
  std::vector<HalfedgeId> corners;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (list.list_starts[f] == list.list_starts[f + 1]) continue;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) {
      pair_of[h.value] = list.values.data() + list.list_starts[f] + std::size_t{2} * mesh.corner(h);
      corners.push_back(h);
    }
  }
  const auto key = [&](HalfedgeId h) { return std::tuple(mesh.origin(h), bits_of(pair_of[h.value])); };
  std::stable_sort(corners.begin(), corners.end(), [&](HalfedgeId a, HalfedgeId b) { return key(a) < key(b); });
  std::vector<HalfedgeId> first_like(mesh.halfedge_count());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const bool again = k > 0 && key(corners[k - 1]) == key(corners[k]);
    first_like[corners[k].value] = again ? first_like[corners[k - 1].value] : corners[k];
  }
  IndexedAttribute pool{2, {}, std::vector<std::uint32_t>(mesh.halfedge_count(), kNoIndex)};
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    if (pair_of[h] == nullptr) continue;
    if (first_like[h].value == h) {
      pool.corner_index[h] = static_cast<std::uint32_t>(pool.values.size() / 2);
      pool.values.insert(pool.values.end(), pair_of[h], pair_of[h] + 2);
    } else {
      pool.corner_index[h] = pool.corner_index[first_like[h].value];
    }
  }
  return pool;
}

}  // namespace

const Property* find_texture_list(const MeshFile& file) {
  for (const Property& property : file.properties) {
    const bool named = property.domain == Domain::Face && property.name == "texcoord" && property.count_type;
    if (named && fits_corners(file.mesh, property)) return &property;
  }
  return nullptr;
}

std::optional<IndexedAttribute> texture_coordinates_of(const MeshFile& file) {
  if (file.texture_coordinates) return file.texture_coordinates;
  const Property* const list = find_texture_list(file);
  if (list == nullptr) return std::nullopt;
  return lifted(file.mesh, *list);
}

Property texture_list_of(const Mesh& mesh, const IndexedAttribute& pool, const Property& like) {
  Property list{like.name, like.domain, like.type, like.count_type, {0}, {}};
  std::uint32_t longest = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const HalfedgeRange corners = mesh.halfedges(FaceId(f));
    const bool any = std::any_of(corners.begin(), corners.end(),
                                 [&](HalfedgeId h) { return pool.corner_index[h.value] != kNoIndex; });
    for (const HalfedgeId h : corners) {
      for (std::uint32_t c = 0; any && c < 2; ++c) {
        const std::uint32_t index = pool.corner_index[h.value];
        const bool has = index != kNoIndex && c < pool.components;
        list.values.push_back(has ? pool.values[std::size_t{index} * pool.components + c] : 0.0);
      }
    }
    longest = std::max(longest, any ? 2 * mesh.size(FaceId(f)) : 0);
    list.list_starts.push_back(static_cast<std::uint32_t>(list.values.size()));
  }
  const bool counted_in_bytes = like.count_type == ScalarType::UInt8 || like.count_type == ScalarType::Int8;
  if (counted_in_bytes && longest > 127) list.count_type = ScalarType::UInt32;
  return list;
}

}  // namespace quadmatch::use
