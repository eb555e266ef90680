// The one source file of this layer that includes Boost.Graph.

#include <vector>

#include <quadmatch/shapes/cubic_graph.hpp>

// Without exceptions Boost asks its user what to do instead; no path here throws.
#include <boost/config.hpp>
#ifdef BOOST_NO_EXCEPTIONS
#include <cstdlib>
#include <exception>
namespace boost {
struct source_location;
[[noreturn]] void throw_exception(const std::exception& /*unused*/) { std::abort(); }
[[noreturn]] void throw_exception(const std::exception& /*unused*/, const source_location& /*unused*/) { std::abort(); }
}  // namespace boost
#endif
// Its drawing has an iterator that is set in a loop which always runs; g++ does not see that it does.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/chrobak_payne_drawing.hpp>
#include <boost/graph/make_biconnected_planar.hpp>
#include <boost/graph/make_maximal_planar.hpp>
#include <boost/graph/planar_canonical_ordering.hpp>

namespace quadmatch::shapes {
namespace {

using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::property<boost::vertex_index_t, int>,
                          boost::property<boost::edge_index_t, int>>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;
/// The edges around each vertex, in order.
using Embedding = std::vector<std::vector<Edge>>;

void number_edges(Graph& graph) {
  int index = 0;
  for (auto [edge, end] = boost::edges(graph); edge != end; ++edge)
    boost::put(boost::edge_index, graph, *edge, index++);
}

auto by_vertex(Embedding& embedding, const Graph& graph) {
  return boost::make_iterator_property_map(embedding.begin(), boost::get(boost::vertex_index, graph));
}

/// False where the graph is not planar.
bool embed(Graph& graph, Embedding& embedding) {
  number_edges(graph);
  embedding.assign(boost::num_vertices(graph), {});
  return boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                             boost::boyer_myrvold_params::embedding = by_vertex(embedding, graph));
}

struct Place {
  std::size_t x = 0, y = 0;
};

}  // namespace

Expected<std::vector<GridPoint>> planar_drawing(const CubicGraph& graph) {
  if (const Expected<void> cubic = check_cubic(graph); !cubic) return Unexpected(cubic.error());
  Graph drawn(graph.vertex_count);
  for (const auto& [from, to] : graph.edges) boost::add_edge(from, to, drawn);

  // The drawing is one of a triangulation: edges are added, and after each step the order about vertices is found anew.
  Embedding embedding;
  if (!embed(drawn, embedding)) {
    return Unexpected(Error{ErrorCode::BadArgument, "the graph is not planar: it cannot be drawn without crossings"});
  }
  boost::make_biconnected_planar(drawn, by_vertex(embedding, drawn));
  embed(drawn, embedding);
  boost::make_maximal_planar(drawn, by_vertex(embedding, drawn));
  embed(drawn, embedding);

  std::vector<boost::graph_traits<Graph>::vertex_descriptor> order;
  boost::planar_canonical_ordering(drawn, by_vertex(embedding, drawn), std::back_inserter(order));
  std::vector<Place> places(graph.vertex_count);
  boost::chrobak_payne_straight_line_drawing(
      drawn, by_vertex(embedding, drawn), order.begin(), order.end(),
      boost::make_iterator_property_map(places.begin(), boost::get(boost::vertex_index, drawn)));

  std::vector<GridPoint> points;
  for (const Place& place : places) {
    points.push_back({static_cast<std::int64_t>(place.x), static_cast<std::int64_t>(place.y)});
  }
  return points;
}

}  // namespace quadmatch::shapes
