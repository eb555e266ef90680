#include "values.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "../data/scalar_types.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;

std::span<const double> values_of(const Property* property, std::uint32_t element) {
  if (property == nullptr) return {};
  if (!property->count_type) return {property->values.data() + element, 1};
  const std::uint32_t begin = property->list_starts[element];
  return {property->values.data() + begin, property->list_starts[element + 1] - begin};
}

bool equal(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// A property of the three files, null where a file has none like it.
using InFiles = std::array<const Property*, 3>;

const Property* at(const InFiles& properties, Side side) { return properties[static_cast<std::size_t>(side)]; }

const Property* find(const MeshFile& file, const Property& like) {
  const auto found = std::find_if(file.properties.begin(), file.properties.end(), [&](const Property& property) {
    return property.name == like.name && property.domain == like.domain;
  });
  return found == file.properties.end() ? nullptr : &*found;
}

/// The property with the values that were picked.
Property written(const InFiles& properties, const Picks& picks, const std::vector<Origin>& origins) {
  const Property* const ours = at(properties, Side::Ours);
  const Property* const theirs = at(properties, Side::Theirs);
  const Property& like = ours != nullptr ? *ours : *theirs;
  Property result{like.name, like.domain, like.type, like.count_type, {}, {}};
  if (ours != nullptr && theirs != nullptr && picks.any(Side::Theirs)) {
    result.type = holding_both(ours->type, theirs->type);
    if (result.count_type) result.count_type = holding_both(*ours->count_type, *theirs->count_type);
  }
  if (result.count_type) result.list_starts = {0};
  for (std::size_t k = 0; k < origins.size(); ++k) {
    const std::span<const double> values = values_of(at(properties, picks.sides[k]), origins[k][picks.sides[k]]);
    result.values.insert(result.values.end(), values.begin(), values.end());
    if (values.empty() && !result.count_type) result.values.push_back(0);
    if (result.count_type) result.list_starts.push_back(static_cast<std::uint32_t>(result.values.size()));
  }
  return result;
}

/// Where one side has a list and another a number, nothing can be compared: only those like the first are looked at.
void pass_over_other_kinds(InFiles& properties, MergedAttribute& report) {
  const Property* const ours = at(properties, Side::Ours);
  const bool list = (ours != nullptr ? ours : at(properties, Side::Theirs))->count_type.has_value();
  for (const Property*& property : properties) {
    if (property == nullptr || property->count_type.has_value() == list) continue;
    property = nullptr;
    report.remarks.emplace_back("it is a list in one mesh and a number in another; only those like OURS' were taken");
  }
}

std::optional<Property> merge_property(InFiles properties, const Origins& origins, Side preferred, ValueTally& tally) {
  const Property& like =
      at(properties, Side::Ours) != nullptr ? *at(properties, Side::Ours) : *at(properties, Side::Theirs);
  MergedAttribute kinds;
  pass_over_other_kinds(properties, kinds);
  const std::vector<Origin>& elements = origins.of(like.domain);
  Picks picks =
      pick(like.name, like.domain, elements, preferred, [&](Side a, std::uint32_t i, Side b, std::uint32_t j) {
        return equal(values_of(at(properties, a), i), values_of(at(properties, b), j));
      });
  picks.report.remarks = std::move(kinds.remarks);
  const bool ours = at(properties, Side::Ours) != nullptr, theirs = at(properties, Side::Theirs) != nullptr;
  const bool dropped = at(properties, Side::Base) != nullptr && ours != theirs;
  // A side that dropped it did not change each of its values; unless the other side did, it is gone.
  if (dropped && (ours ? picks.ours_changed : picks.theirs_changed) > 0) {
    const bool stays = (preferred == Side::Ours) == ours;
    picks.report.remarks.push_back(fmt::format("{} dropped it and {} changed it; it is {}", ours ? "THEIRS" : "OURS",
                                               ours ? "OURS" : "THEIRS", stays ? "kept" : "dropped"));
    for (std::size_t k = 0; stays && k < elements.size(); ++k) {
      if (elements[k].has(preferred)) picks.sides[k] = preferred;
    }
    tally.enter(picks);
    if (!stays) return std::nullopt;
    return written(properties, picks, elements);
  }
  if (dropped) {
    picks = {};
    tally.enter_remark(like.name, like.domain, fmt::format("{} dropped it", ours ? "THEIRS" : "OURS"));
    (ours ? tally.theirs_changed : tally.ours_changed) = true;
    return std::nullopt;
  }
  tally.enter(picks);
  return written(properties, picks, elements);
}

std::size_t entry_count(const IndexedAttribute* pool) {
  return pool == nullptr || pool->components == 0 ? 0 : pool->values.size() / pool->components;
}

std::uint32_t entry_at(const IndexedAttribute* pool, std::uint32_t corner) {
  return pool == nullptr ? kNoIndex : pool->corner_index[corner];
}

std::span<const double> tuple(const IndexedAttribute* pool, std::uint32_t entry) {
  if (entry == kNoIndex) return {};
  return {pool->values.data() + std::size_t{entry} * pool->components, pool->components};
}

/// Copies entries of pools into one, each once.
class PoolWriter {
 public:
  PoolWriter(const IndexedAttribute* ours, const IndexedAttribute* theirs) : pools_{nullptr, ours, theirs} {
    for (std::size_t side = 1; side < 3; ++side) {
      wanted_[side].assign(entry_count(pools_[side]), 0);
      merged_.places[side].assign(entry_count(pools_[side]), kNoIndex);
      if (pools_[side] == nullptr) continue;
      merged_.attribute.components = std::max(merged_.attribute.components, pools_[side]->components);
    }
    keep_unused();
  }

  void want(Side side, std::uint32_t entry) { wanted_[static_cast<std::size_t>(side)][entry] = 1; }

  void write() {
    for (std::size_t side = 1; side < 3; ++side) {
      for (std::uint32_t entry = 0; entry < wanted_[side].size(); ++entry) {
        if (wanted_[side][entry] != 0) append(side, entry);
      }
    }
  }

  [[nodiscard]] std::uint32_t place(Side side, std::uint32_t entry) const {
    return merged_.places[static_cast<std::size_t>(side)][entry];
  }

  MergedPool finish(std::vector<std::uint32_t> corner_index) {
    merged_.attribute.corner_index = std::move(corner_index);
    return std::move(merged_);
  }

 private:
  /// What no corner of OURS used before is not lost now.
  void keep_unused() {
    std::vector<std::uint8_t> used(wanted_[1].size(), 0);
    if (pools_[1] == nullptr) return;
    for (const std::uint32_t entry : pools_[1]->corner_index) {
      if (entry != kNoIndex) used[entry] = 1;
    }
    for (std::size_t entry = 0; entry < used.size(); ++entry) wanted_[1][entry] = used[entry] == 0 ? 1 : 0;
  }

  void append(std::size_t side, std::uint32_t entry) {
    IndexedAttribute& to = merged_.attribute;
    merged_.places[side][entry] = static_cast<std::uint32_t>(to.values.size() / to.components);
    const std::span<const double> values = tuple(pools_[side], entry);
    to.values.insert(to.values.end(), values.begin(), values.end());
    to.values.insert(to.values.end(), to.components - values.size(), 0.0);
  }

  std::array<const IndexedAttribute*, 3> pools_;
  std::array<std::vector<std::uint8_t>, 3> wanted_;
  MergedPool merged_;
};

}  // namespace

void ValueTally::enter(const Picks& picks) {
  ours_changed = ours_changed || picks.ours_changed > 0;
  theirs_changed = theirs_changed || picks.theirs_changed > 0;
  if (picks.conflict.count > 0) conflicts.push_back(picks.conflict);
  const MergedAttribute& report = picks.report;
  if (report.from_ours + report.from_theirs > 0 || !report.remarks.empty()) attributes.push_back(report);
}

void ValueTally::enter_remark(const std::string& name, Domain domain, std::string remark) {
  attributes.push_back({name, domain, 0, 0, {std::move(remark)}});
}

std::vector<Property> merge_properties(const ThreeFiles& files, const std::array<const Property*, 3>& passed_over,
                                       const Origins& origins, Side preferred, ValueTally& tally) {
  std::vector<Property> merged;
  const auto add = [&](const Property& property) {
    if (property.domain == Domain::Further) return;
    const InFiles all{find(*files[0], property), find(*files[1], property), find(*files[2], property)};
    for (const Property* const list : passed_over) {
      if (list != nullptr && std::find(all.begin(), all.end(), list) != all.end()) return;
    }
    if (std::optional<Property> result = merge_property(all, origins, preferred, tally)) {
      merged.push_back(*std::move(result));
    }
  };
  for (const Property& property : file_of(files, Side::Ours).properties) add(property);
  for (const Property& property : file_of(files, Side::Theirs).properties) {
    if (find(file_of(files, Side::Ours), property) == nullptr) add(property);
  }
  return merged;
}

MergedPool merge_pools(const std::string& name, const std::array<const IndexedAttribute*, 3>& pools,
                       const std::vector<Origin>& corners, Side preferred, ValueTally& tally) {
  const auto entry = [&](Side side, std::uint32_t corner) {
    return entry_at(pools[static_cast<std::size_t>(side)], corner);
  };
  const auto value = [&](Side side, std::uint32_t corner) {
    return tuple(pools[static_cast<std::size_t>(side)], entry(side, corner));
  };
  const Picks picks =
      pick(name, Domain::Corner, corners, preferred,
           [&](Side a, std::uint32_t i, Side b, std::uint32_t j) { return equal(value(a, i), value(b, j)); });
  tally.enter(picks);

  std::vector<std::uint32_t> as_ours(entry_count(pools[2]), kNoIndex);  // an entry of OURS that says the same
  for (const Origin& corner : corners) {
    if (!corner.has(Side::Ours) || !corner.has(Side::Theirs)) continue;
    const std::uint32_t own = entry(Side::Ours, corner[Side::Ours]);
    const std::uint32_t theirs = entry(Side::Theirs, corner[Side::Theirs]);
    if (own == kNoIndex || theirs == kNoIndex || as_ours[theirs] != kNoIndex) continue;
    if (equal(tuple(pools[1], own), tuple(pools[2], theirs))) as_ours[theirs] = own;
  }
  const auto source = [&](std::size_t k) {
    const Side side = picks.sides[k];
    const std::uint32_t index = entry(side, corners[k][side]);
    const bool shared = side == Side::Theirs && index != kNoIndex && as_ours[index] != kNoIndex;
    return shared ? std::pair(Side::Ours, as_ours[index]) : std::pair(side, index);
  };
  PoolWriter writer(pools[1], pools[2]);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (source(k).second != kNoIndex) writer.want(source(k).first, source(k).second);
  }
  writer.write();
  std::vector<std::uint32_t> corner_index;
  corner_index.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [side, index] = source(k);
    corner_index.push_back(index == kNoIndex ? kNoIndex : writer.place(side, index));
  }
  return writer.finish(std::move(corner_index));
}

}  // namespace quadmatch::use
