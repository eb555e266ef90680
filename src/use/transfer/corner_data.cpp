#include "corner_data.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "corner_fill.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;

/// Append the used entries of a pool to another of at least as many components, with zeros for those it lacks.
/// @return where each entry went, or kNoIndex
std::vector<std::uint32_t> append_used(const IndexedAttribute& pool, const std::vector<std::uint8_t>& used,
                                       IndexedAttribute& to) {
  std::vector<std::uint32_t> place(used.size(), kNoIndex);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(to.values.size() / to.components);
    for (std::uint32_t c = 0; c < to.components; ++c) {
      to.values.push_back(c < pool.components ? pool.values[i * pool.components + c] : 0.0);
    }
  }
  return place;
}

std::size_t entry_count(const IndexedAttribute& pool) {
  return pool.components == 0 ? 0 : pool.values.size() / pool.components;
}

/// As many components as both need, since a pool has one number of them.
std::uint32_t common_components(const IndexedAttribute& source, const IndexedAttribute* own,
                                TransferredAttribute& report) {
  if (own == nullptr || own->components == source.components) return source.components;
  report.remarks.push_back(fmt::format("the source has {} numbers each and the target {}; those missing became 0",
                                       source.components, own->components));
  return std::max(source.components, own->components);
}

/// Give the corners that have nothing yet the target's own.
std::vector<std::uint32_t> keep_own(const IndexedAttribute& own, const Correspondence& from,
                                    IndexedAttribute& attribute, TransferredAttribute& report) {
  const auto keeps = [&](std::uint32_t h) {
    return !from.corners[HalfedgeId(h)].valid() && attribute.corner_index[h] == kNoIndex &&
           own.corner_index[h] != kNoIndex;
  };
  std::vector<std::uint8_t> used(entry_count(own), 0);
  for (std::uint32_t h = 0; h < own.corner_index.size(); ++h) {
    if (keeps(h)) used[own.corner_index[h]] = 1;
  }
  std::vector<std::uint32_t> place = append_used(own, used, attribute);
  for (std::uint32_t h = 0; h < own.corner_index.size(); ++h) {
    if (!keeps(h)) continue;
    attribute.corner_index[h] = place[own.corner_index[h]];
    ++report.kept;
  }
  return place;
}

}  // namespace

CarriedCorners carry_corners(const Mesh& target, const IndexedAttribute& source, const IndexedAttribute* own,
                             const Correspondence& from, Fill fill, TransferredAttribute& report) {
  if (fill == Fill::None) own = nullptr;
  IndexedAttribute attribute{common_components(source, own, report), {}, {}};
  std::vector<std::uint8_t> used(entry_count(source), 0);
  attribute.corner_index.reserve(target.halfedge_count());
  for (const HalfedgeId there : from.corners) {
    attribute.corner_index.push_back(there.valid() ? source.corner_index[there.value] : kNoIndex);
    if (attribute.corner_index.back() != kNoIndex) used[attribute.corner_index.back()] = 1;
  }
  const std::vector<std::uint32_t> place = append_used(source, used, attribute);
  for (std::uint32_t& index : attribute.corner_index) {
    if (index == kNoIndex) continue;
    index = place[index];
    ++report.carried;
  }
  if (fill == Fill::Smooth) {
    fill_corners(target, from.faces, attribute);
    const auto with_value = std::count_if(attribute.corner_index.begin(), attribute.corner_index.end(),
                                          [](std::uint32_t index) { return index != kNoIndex; });
    report.filled = static_cast<std::uint32_t>(with_value) - report.carried;
  }
  std::vector<std::uint32_t> own_entries;
  if (own != nullptr) own_entries = keep_own(*own, from, attribute, report);
  report.without = target.halfedge_count() - report.carried - report.filled - report.kept;
  return {std::move(attribute), std::move(own_entries)};
}

}  // namespace quadmatch::use
