#include <quadmatch/analysis/spoke_colours.hpp>

#include <utility>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace quadmatch {
namespace {

/// What a spoke sees where there is none: beyond a boundary, or beside the outermost edge of a boundary vertex.
constexpr Colour kNothing = 0;

template <std::size_t kCount>
Colour hash(const Colour (&string)[kCount]) {
  return XXH3_64bits(string, sizeof string);
}

}  // namespace

std::vector<Colour> initial_spoke_colours(const ArcGraph& separatrices, const PerFan<VertexCode>& codes) {
  std::vector<Colour> initial;
  initial.reserve(separatrices.spokes.size());
  for (std::uint32_t node = 0; node < separatrices.node_count(); ++node) {
    initial.insert(initial.end(), separatrices.spokes_of(node).size(),
                   hash({Colour{codes[separatrices.nodes[node]].value}}));
  }
  return initial;
}

std::vector<Colour> refine_spoke_colours(const ArcGraph& graph, const PerFan<VertexCode>& codes,
                                         const std::vector<Colour>& colours, const ColouringOptions& options) {
  std::vector<Colour> refined(colours.size());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    const std::uint32_t first = graph.first_spoke[node];
    const std::uint32_t last = graph.first_spoke[node + 1] - 1;
    const bool cyclic = !codes[graph.nodes[node]].on_boundary();
    for (std::uint32_t spoke = first; spoke <= last; ++spoke) {
      const Spoke& arc = graph.spokes[spoke];
      const Colour opposite = arc.to_spoke == Spoke::kNone ? kNothing : colours[arc.to_spoke];
      const Colour ccw = spoke < last ? colours[spoke + 1] : cyclic ? colours[first] : kNothing;
      const Colour cw = spoke > first ? colours[spoke - 1] : cyclic ? colours[last] : kNothing;
      refined[spoke] = hash({colours[spoke], opposite, options.arc_lengths ? arc.length : 0, ccw, cw});
    }
  }
  return refined;
}

SpokeColours colour_spokes(const ArcGraph& separatrices, const PerFan<VertexCode>& codes, std::uint32_t rounds,
                           const ColouringOptions& options) {
  SpokeColours colours;
  colours.rounds.push_back(initial_spoke_colours(separatrices, codes));
  for (std::uint32_t round = 1; round <= rounds; ++round) {
    colours.rounds.push_back(refine_spoke_colours(separatrices, codes, colours.rounds.back(), options));
  }
  return colours;
}

}  // namespace quadmatch
