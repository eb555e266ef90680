// Algorithm 1 (ColorGraph) of §4.1, with hashes in place of the normalised labels 1 ... n: equal neighbourhoods get
// equal colours in every mesh, so the two meshes need no common table.

#include <quadmatch/analysis/colouring.hpp>

#include <algorithm>
#include <span>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace quadmatch {
namespace {

/// What a node sees beyond a spoke that ran into the boundary.
constexpr Colour kBeyondBoundary = 0;

Colour hash(std::span<const Colour> string) { return XXH3_64bits(string.data(), string.size_bytes()); }

/// The neighbours' colours in counter-clockwise order, each with the length of its arc where that counts.
void read_neighbours(const ArcGraph& graph, const std::vector<Colour>& colours, std::uint32_t node,
                     const ColouringOptions& options, std::vector<Colour>& string) {
  string.clear();
  for (const Spoke& spoke : graph.spokes_of(node)) {
    const Colour beyond = spoke.to_node == Spoke::kNone ? kBeyondBoundary : colours[spoke.to_node];
    if (options.arc_lengths) {
      const Colour pair[] = {beyond, spoke.length};
      string.push_back(hash(pair));
    } else {
      string.push_back(beyond);
    }
  }
}

/// Where the lexicographically least rotation of a cyclic string begins, in linear time: of two rival beginnings the
/// one that loses a comparison of k letters takes its next k rivals with it.
std::uint32_t least_rotation(std::span<const Colour> string) {
  const auto length = static_cast<std::uint32_t>(string.size());
  std::uint32_t one = 0, other = 1, same = 0;
  while (one < length && other < length && same < length) {
    const Colour left = string[(one + same) % length];
    const Colour right = string[(other + same) % length];
    if (left == right) {
      ++same;
      continue;
    }
    (left > right ? one : other) += same + 1;
    if (one == other) ++other;
    same = 0;
  }
  return std::min(one, other);
}

/// The least turn that maps a cyclic string onto itself.
std::uint32_t least_period(std::span<const Colour> string) {
  const auto length = static_cast<std::uint32_t>(string.size());
  for (std::uint32_t period = 1; period < length; ++period) {
    if (length % period != 0) continue;
    bool repeats = true;
    for (std::uint32_t place = period; repeats && place < length; ++place) {
      repeats = string[place] == string[place - period];
    }
    if (repeats) return period;
  }
  return length;
}

}  // namespace

std::vector<Colour> initial_colours(const ArcGraph& graph, const PerFan<VertexCode>& codes) {
  std::vector<Colour> colours;
  colours.reserve(graph.nodes.size());
  for (const FanId node : graph.nodes) {
    const Colour code[] = {codes[node].value};
    colours.push_back(hash(code));
  }
  return colours;
}

std::vector<Colour> refine_colours(const ArcGraph& graph, const PerFan<VertexCode>& codes,
                                   const std::vector<Colour>& colours, const ColouringOptions& options) {
  std::vector<Colour> refined(colours.size());
  std::vector<Colour> neighbours, string;
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    read_neighbours(graph, colours, node, options, neighbours);
    const bool cyclic = !codes[graph.nodes[node]].on_boundary();
    const std::uint32_t start = cyclic && !neighbours.empty() ? least_rotation(neighbours) : 0;
    string.assign(1, colours[node]);
    string.insert(string.end(), neighbours.begin() + start, neighbours.end());
    string.insert(string.end(), neighbours.begin(), neighbours.begin() + start);
    refined[node] = hash(string);
  }
  return refined;
}

std::vector<std::uint32_t> least_rotations(const ArcGraph& graph, const PerFan<VertexCode>& codes,
                                           const std::vector<Colour>& colours, std::uint32_t node,
                                           const ColouringOptions& options) {
  std::vector<Colour> neighbours;
  read_neighbours(graph, colours, node, options, neighbours);
  if (codes[graph.nodes[node]].on_boundary() || neighbours.empty()) return {0};
  std::vector<std::uint32_t> starts;
  const auto count = static_cast<std::uint32_t>(neighbours.size());
  const std::uint32_t period = least_period(neighbours);
  for (std::uint32_t start = least_rotation(neighbours) % period; start < count; start += period) {
    starts.push_back(start);
  }
  return starts;
}

}  // namespace quadmatch
