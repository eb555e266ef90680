// The one source file that includes Boost.Graph.

#include "binary_cut.hpp"

#include <algorithm>
#include <cmath>

// Without exceptions Boost asks its user what to do instead; no path here throws.
#include <boost/config.hpp>
#ifdef BOOST_NO_EXCEPTIONS
#include <cstdlib>
#include <exception>
namespace boost {
struct source_location;
[[noreturn]] inline void throw_exception(const std::exception& /*unused*/) { std::abort(); }
[[noreturn]] inline void throw_exception(const std::exception& /*unused*/, const source_location& /*unused*/) {
  std::abort();
}
}  // namespace boost
#endif
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

namespace quadmatch::regions {
namespace {

constexpr double kUnit = 1 << 20;

std::int64_t fixed(double cost) { return std::llround(cost * kUnit); }

struct Arc {
  std::uint32_t from, to;
  std::int64_t capacity;
  std::size_t reverse;
};

using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                 boost::no_property, std::uint32_t, std::uint32_t>;

/// Arcs and their reverses, to be ordered by where they leave.
class Arcs {
 public:
  void add(std::uint32_t from, std::uint32_t to, std::int64_t capacity) {
    arcs_.push_back({from, to, capacity, arcs_.size() + 1});
    arcs_.push_back({to, from, 0, arcs_.size() - 1});
  }
  /// Order by `from`; reverses still point at each other.
  std::vector<Arc> ordered(std::uint32_t nodes) const {
    std::vector<std::size_t> start(nodes + 1, 0);
    for (const Arc& arc : arcs_) ++start[arc.from + 1];
    for (std::uint32_t node = 0; node < nodes; ++node) start[node + 1] += start[node];
    std::vector<std::size_t> place(arcs_.size());
    for (std::size_t k = 0; k < arcs_.size(); ++k) place[k] = start[arcs_[k].from]++;
    std::vector<Arc> sorted(arcs_.size());
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      sorted[place[k]] = arcs_[k];
      sorted[place[k]].reverse = place[arcs_[k].reverse];
    }
    return sorted;
  }

 private:
  std::vector<Arc> arcs_;
};

}  // namespace

void BinaryCut::add_cost(std::uint32_t i, double if_no, double if_yes) {
  no_[i] += fixed(if_no);
  yes_[i] += fixed(if_yes);
}

void BinaryCut::add_pair_cost(std::uint32_t i, std::uint32_t j, double no_no, double no_yes, double yes_no,
                              double yes_yes) {
  // Kolmogorov & Zabih, section 4: a constant, two costs of one thing each, and a link.
  no_no = std::min(no_no, no_yes + yes_no - std::min(yes_yes, no_yes + yes_no));
  add_cost(i, no_no, yes_no);
  add_cost(j, 0, yes_yes - yes_no);
  const std::int64_t capacity = fixed(no_yes + yes_no - no_no - yes_yes);
  if (capacity > 0) links_.push_back({j, i, capacity});  // paid where j is yes and i is no
}

double BinaryCut::gain(const std::vector<bool>& yes) const {
  std::int64_t gain = 0;
  for (std::size_t i = 0; i < yes.size(); ++i) {
    if (yes[i]) gain += no_[i] - yes_[i];
  }
  for (const Link& link : links_) {
    if (yes[link.from] && !yes[link.to]) gain -= link.capacity;
  }
  return static_cast<double>(gain) / kUnit;
}

std::vector<bool> BinaryCut::solve() const {
  const auto count = static_cast<std::uint32_t>(no_.size());
  const std::uint32_t source = count, sink = count + 1;
  Arcs arcs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int64_t gain = no_[i] - yes_[i];  // yes is on the side of the source
    if (gain > 0) arcs.add(source, i, gain);
    if (gain < 0) arcs.add(i, sink, -gain);
  }
  for (const Link& link : links_) arcs.add(link.from, link.to, link.capacity);
  const std::vector<Arc> sorted = arcs.ordered(count + 2);

  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  ends.reserve(sorted.size());
  for (const Arc& arc : sorted) ends.emplace_back(arc.from, arc.to);
  const Graph graph(boost::edges_are_sorted, ends.begin(), ends.end(), count + 2);
  const auto node_index = get(boost::vertex_index, graph);
  const auto arc_index = get(boost::edge_index, graph);
  std::vector<std::int64_t> capacity(sorted.size()), residual(sorted.size());
  std::vector<Graph::edge_descriptor> reverse(sorted.size()), by_index(sorted.size());
  for (auto [arc, end] = edges(graph); arc != end; ++arc) by_index[get(arc_index, *arc)] = *arc;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    capacity[k] = sorted[k].capacity;
    reverse[k] = by_index[sorted[k].reverse];
  }
  std::vector<Graph::edge_descriptor> predecessor(count + 2);
  std::vector<boost::default_color_type> colour(count + 2);
  std::vector<std::int64_t> distance(count + 2);
  const auto on_arcs = [&](auto& values) { return boost::make_iterator_property_map(values.begin(), arc_index); };
  const auto on_nodes = [&](auto& values) { return boost::make_iterator_property_map(values.begin(), node_index); };
  boost::boykov_kolmogorov_max_flow(graph, on_arcs(capacity), on_arcs(residual), on_arcs(reverse),
                                    on_nodes(predecessor), on_nodes(colour), on_nodes(distance), node_index, source,
                                    sink);
  std::vector<bool> yes(count);
  for (std::uint32_t i = 0; i < count; ++i) yes[i] = colour[i] == boost::black_color;
  return yes;
}

}  // namespace quadmatch::regions
