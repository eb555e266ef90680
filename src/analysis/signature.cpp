// Broder's bottom-k sketch of the set of what lies around extraordinary vertices.

#include <quadmatch/analysis/signature.hpp>

#include <algorithm>
#include <bit>

#include <quadmatch/analysis/spoke_colours.hpp>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace quadmatch {
namespace {

constexpr std::uint32_t kRounds = 3;

/// What an element says, so that two kinds are never taken for each other.
enum class Kind : std::uint64_t { WithoutLengths = 1, WithLengths = 2, Size = 3 };

std::uint64_t hash(std::uint64_t one, std::uint64_t two, std::uint64_t three) {
  const std::uint64_t string[] = {one, two, three};
  return XXH3_64bits(string, sizeof string);
}

/// The place of a spoke in the mirrored graph: the same node, counted from the other end.
std::uint32_t mirrored_spoke(const ArcGraph& graph, std::uint32_t node, std::uint32_t spoke) {
  return graph.first_spoke[node] + graph.first_spoke[node + 1] - 1 - spoke;
}

/// The separatrix graph of the mirror image: the spokes of every node in the opposite order. Where they start is not
/// mirrored, since colours do not look at it.
ArcGraph mirrored(const ArcGraph& graph) {
  ArcGraph mirror = graph;
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    for (std::uint32_t spoke = graph.first_spoke[node]; spoke < graph.first_spoke[node + 1]; ++spoke) {
      Spoke& there = mirror.spokes[mirrored_spoke(graph, node, spoke)];
      there = graph.spokes[spoke];
      if (there.to_spoke != Spoke::kNone) there.to_spoke = mirrored_spoke(graph, there.to_node, there.to_spoke);
    }
  }
  return mirror;
}

/// The colours of a mesh and of its mirror image, round by round; of each spoke the lesser of its two.
void add_colours(const ArcGraph& graph, const ArcGraph& mirror, const PerFan<VertexCode>& codes, Kind kind,
                 std::vector<std::uint64_t>& found) {
  const ColouringOptions options{.arc_lengths = kind == Kind::WithLengths};
  const SpokeColours here = colour_spokes(graph, codes, kRounds, options);
  const SpokeColours there = colour_spokes(mirror, codes, kRounds, options);
  for (std::uint32_t round = 1; round <= kRounds; ++round) {
    for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
      for (std::uint32_t spoke = graph.first_spoke[node]; spoke < graph.first_spoke[node + 1]; ++spoke) {
        const Colour turned = there.rounds[round][mirrored_spoke(graph, node, spoke)];
        found.push_back(hash(static_cast<std::uint64_t>(kind), round, std::min(here.rounds[round][spoke], turned)));
      }
    }
  }
}

/// For each thing found n times: that there are one, two, four, ... of it, up to n.
std::vector<std::uint64_t> elements_of(std::vector<std::uint64_t> found) {
  std::sort(found.begin(), found.end());
  std::vector<std::uint64_t> elements;
  for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
    while (last < found.size() && found[last] == found[first]) ++last;
    for (std::size_t count = 1; count <= last - first; count *= 2) elements.push_back(hash(found[first], count, 0));
  }
  return elements;
}

/// Nothing but its size tells a mesh without extraordinary vertices from others: the number of faces, and two of
/// overlapping ranges it lies in, an eighth to a quarter of it wide.
std::vector<std::uint64_t> elements_of_size(std::uint32_t faces) {
  const auto range = [](std::uint64_t count) {
    const int below_leading_bits = std::max(0, static_cast<int>(std::bit_width(count)) - 3);
    return count >> below_leading_bits << below_leading_bits;
  };
  constexpr auto kKind = static_cast<std::uint64_t>(Kind::Size);
  return {hash(kKind, 0, faces), hash(kKind, 1, range(faces)), hash(kKind, 2, range(faces + faces / 8ULL))};
}

}  // namespace

Signature signature_of(const Mesh& mesh, std::uint32_t most) {
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  const ArcGraph graph = trace_separatrices(mesh, codes);
  std::vector<std::uint64_t> elements;
  if (graph.node_count() == 0) {
    elements = elements_of_size(mesh.face_count());
  } else {
    const ArcGraph mirror = mirrored(graph);
    std::vector<std::uint64_t> found;
    found.reserve(graph.spokes.size() * 2 * kRounds);
    add_colours(graph, mirror, codes, Kind::WithoutLengths, found);
    add_colours(graph, mirror, codes, Kind::WithLengths, found);
    elements = elements_of(std::move(found));
  }
  Signature signature{static_cast<std::uint32_t>(elements.size())};
  const auto kept = static_cast<std::ptrdiff_t>(std::min<std::size_t>(most, elements.size()));
  std::partial_sort(elements.begin(), elements.begin() + kept, elements.end());
  signature.values.reserve(static_cast<std::size_t>(kept));
  // All 64 bits order the elements, the lower half names them: names of the lowest are spread as evenly as all others.
  for (std::ptrdiff_t k = 0; k < kept; ++k) signature.values.push_back(static_cast<std::uint32_t>(elements[k]));
  return signature;
}

}  // namespace quadmatch
