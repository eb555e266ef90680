#include "element_data.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "../data/harmonic.hpp"
#include "../data/scalar_types.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = ElementMap::kNone;

/// Neighbouring elements of a domain, each pair as often as they meet.
std::vector<WeightedEdge> neighbours(const Mesh& mesh, Domain domain) {
  std::vector<WeightedEdge> edges;
  const std::vector<double> weights = domain == Domain::Vertex ? edge_weights(mesh) : std::vector<double>();
  for (std::uint32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (domain == Domain::Vertex) {
      edges.push_back({mesh.origin(h).value, mesh.tip(h).value, weights[i]});
    } else if (mesh.twin(h).valid() && h < mesh.twin(h)) {
      edges.push_back({mesh.face(h).value, mesh.face(mesh.twin(h)).value, 1.0});
    }
  }
  return edges;
}

/// Every element's nearest one that has an origin, ring by ring; among equals the first reached.
std::vector<std::uint32_t> nearest_origins(std::vector<std::uint32_t> from, const std::vector<WeightedEdge>& edges) {
  std::vector<std::uint32_t> starts(from.size() + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++starts[edge.one + 1];
    ++starts[edge.other + 1];
  }
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<std::uint32_t> others(starts.back());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (const WeightedEdge& edge : edges) {
    others[next[edge.one]++] = edge.other;
    others[next[edge.other]++] = edge.one;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t element = 0; element < from.size(); ++element) {
    if (from[element] != kNone) order.push_back(element);
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::uint32_t i = starts[order[k]]; i < starts[order[k] + 1]; ++i) {
      if (from[others[i]] != kNone) continue;
      from[others[i]] = from[order[k]];
      order.push_back(others[i]);
    }
  }
  return from;
}

template <class Ids>
ElementMap map_of(const Ids& ids, const Mesh& target, Domain domain, Fill fill) {
  ElementMap map;
  for (const auto id : ids) map.from.push_back(id.valid() ? id.value : kNone);
  if (fill == Fill::Smooth) map.nearest = nearest_origins(map.from, neighbours(target, domain));
  return map;
}

/// Which element of which file the values of an element come from.
struct Origin {
  const Property* property = nullptr;
  std::uint32_t element = 0;
};

/// The values of one element.
std::span<const double> values_of(const Property& property, std::uint32_t element) {
  if (!property.count_type) return {property.values.data() + element, 1};
  const std::uint32_t begin = property.list_starts[element];
  return {property.values.data() + begin, property.list_starts[element + 1] - begin};
}

/// What values of the target's own are multiplied by so that colours mean the same.
double own_scale(const Property& source, const Property& own) {
  if (!is_colour(source) || is_whole(source.type) == is_whole(own.type)) return 1;
  return is_whole(source.type) ? 255.0 : 1.0 / 255.0;
}

/// An element without a value: an empty list or 0.
void append(Property& property, const Origin& origin, double scale, bool rounded) {
  if (origin.property != nullptr) {
    for (const double value : values_of(*origin.property, origin.element)) {
      property.values.push_back(rounded ? std::round(value * scale) : value * scale);
    }
  } else if (!property.count_type) {
    property.values.push_back(0);
  }
  if (property.count_type) property.list_starts.push_back(static_cast<std::uint32_t>(property.values.size()));
}

/// The type of both, with a remark where it is not the source's.
void widen(Property& property, const Property& own, TransferredAttribute& report) {
  if (property.count_type) property.count_type = holding_both(*property.count_type, *own.count_type);
  if (property.type == own.type) return;
  if (own_scale(property, own) != 1) {
    report.remarks.push_back(fmt::format("the target's colours were turned from {} to {}, as the source has them",
                                         name_of(own.type), name_of(property.type)));
    return;
  }
  const ScalarType both = holding_both(property.type, own.type);
  report.remarks.push_back(fmt::format("the source stores {} and the target {}; the result stores {}",
                                       name_of(property.type), name_of(own.type), name_of(both)));
  property.type = both;
}

/// May values be mixed? Numbers of things may not.
bool has_means(const Property& property) {
  return !property.count_type && (!is_whole(property.type) || is_colour(property));
}

void smooth(const Mesh& target, const ElementMap& map, Property& property) {
  GraphValues graph{1, {}, property.values};
  for (const std::uint32_t origin : map.from) graph.known.push_back(origin == kNone ? 0 : 1);
  interpolate(neighbours(target, property.domain), graph);
  for (std::size_t element = 0; element < map.from.size(); ++element) {
    if (map.from[element] != kNone || map.nearest[element] == kNone) continue;
    const double value = graph.values[element];
    property.values[element] = is_whole(property.type) ? std::round(value) : value;
  }
}

}  // namespace

ElementMap vertex_map(const Mesh& target, const Correspondence& from, Fill fill) {
  return map_of(from.vertices, target, Domain::Vertex, fill);
}

ElementMap face_map(const Mesh& target, const Correspondence& from, Fill fill) {
  return map_of(from.faces, target, Domain::Face, fill);
}

ElementMap corner_map(const Mesh& target, const Correspondence& from, Fill fill) {
  ElementMap map = map_of(from.corners, target, Domain::Corner, Fill::Keep);
  if (fill == Fill::Smooth) map.nearest = map.from;  // corners have no neighbours: nothing is filled
  return map;
}

bool is_colour(const Property& property) {
  const auto named = [&](const char* name) { return property.name == name; };
  const bool type_fits = property.type == ScalarType::UInt8 || !is_whole(property.type);
  return type_fits && !property.count_type && (named("red") || named("green") || named("blue") || named("alpha"));
}

Property carry_property(const Mesh& target, const Property& source, const Property* own, const ElementMap& map,
                        Fill fill, TransferredAttribute& report) {
  Property property{source.name, source.domain, source.type, source.count_type, {}, {}};
  if (property.count_type) property.list_starts = {0};
  if (own != nullptr && own->count_type.has_value() != source.count_type.has_value()) {
    report.remarks.push_back(
        "it is a list in one mesh and a number in the other; the target's own values are given up");
    own = nullptr;
  }
  if (fill == Fill::None) own = nullptr;
  if (own != nullptr) widen(property, *own, report);
  const double scale = own == nullptr ? 1 : own_scale(source, *own);
  const bool rounded = scale != 1 && is_whole(property.type);
  for (std::uint32_t element = 0; element < map.from.size(); ++element) {
    if (map.from[element] != kNone) {
      append(property, {&source, map.from[element]}, 1, false);
      ++report.carried;
    } else if (fill == Fill::Smooth && map.nearest[element] != kNone) {
      append(property, {&source, map.nearest[element]}, 1, false);
      ++report.filled;
    } else if (own != nullptr) {
      append(property, {own, element}, scale, rounded);
      ++report.kept;
    } else {
      append(property, {}, 1, false);
      ++report.without;
    }
  }
  if (report.filled > 0 && has_means(property)) smooth(target, map, property);
  if (report.filled > 0 && !has_means(property)) {
    report.remarks.push_back("its values have no mean; what is not matched takes that of the nearest that is");
  }
  return property;
}

std::vector<Point> carry_positions(const Mesh& source, const Mesh& target, const ElementMap& map, Fill fill,
                                   TransferredAttribute& report) {
  std::vector<Point> positions(target.positions().begin(), target.positions().end());
  positions.resize(target.vertex_count(), Point{});
  GraphValues moves{3, std::vector<std::uint8_t>(positions.size(), 0), std::vector<double>(3 * positions.size(), 0.0)};
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (map.from[v] == kNone) continue;
    moves.known[v] = 1;
    for (std::size_t c = 0; c < 3; ++c) moves.values[3 * v + c] = source.positions()[map.from[v]][c] - positions[v][c];
  }
  if (fill == Fill::Smooth) interpolate(neighbours(target, Domain::Vertex), moves);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (map.from[v] != kNone) {
      positions[v] = source.positions()[map.from[v]];  // and not moved there, which would round
      ++report.carried;
    } else if (moves.known[v] != 0) {
      for (std::size_t c = 0; c < 3; ++c) positions[v][c] += moves.values[3 * v + c];
      ++report.filled;
    } else {
      ++(target.positions().empty() ? report.without : report.kept);
    }
  }
  return positions;
}

}  // namespace quadmatch::use
