#include <quadmatch/shapes/cubic_graph.hpp>

#include <algorithm>
#include <set>

namespace quadmatch::shapes {
namespace {

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours neighbours_of(const CubicGraph& graph) {
  Neighbours neighbours(graph.vertex_count);
  for (const auto& [from, to] : graph.edges) {
    neighbours[from].push_back(to);
    neighbours[to].push_back(from);
  }
  for (std::vector<std::uint32_t>& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}

Unexpected<Error> not_so(std::string message) { return Unexpected(Error{ErrorCode::BadArgument, std::move(message)}); }

bool connected(const Neighbours& neighbours) {
  std::vector<bool> seen(neighbours.size());
  std::vector<std::uint32_t> stack = {0};
  std::size_t count = 0;
  while (!stack.empty()) {
    const std::uint32_t v = stack.back();
    stack.pop_back();
    if (seen[v]) continue;
    seen[v] = true;
    ++count;
    stack.insert(stack.end(), neighbours[v].begin(), neighbours[v].end());
  }
  return count == neighbours.size();
}

/// A path from vertex 0 that is made longer edge by edge, and taken back where it leads nowhere.
class CycleSearch {
 public:
  explicit CycleSearch(const CubicGraph& graph)
      : neighbours_(neighbours_of(graph)), on_path_(graph.vertex_count, false) {
    push(0);
  }

  bool run() {
    const std::uint32_t end = path_.back();
    const std::vector<std::uint32_t>& around = neighbours_[end];
    if (path_.size() == neighbours_.size()) return std::binary_search(around.begin(), around.end(), 0U);
    for (const std::uint32_t next : around) {
      if (on_path_[next]) continue;
      push(next);
      if (can_be_passed(end) && run()) return true;
      on_path_[next] = false;
      path_.pop_back();
    }
    return false;
  }
  std::vector<std::uint32_t> take() { return std::move(path_); }

 private:
  void push(std::uint32_t v) {
    path_.push_back(v);
    on_path_[v] = true;
  }
  /// Now that the path has gone on from `left`: can it still pass through each of that vertex's other neighbours? A
  /// vertex off the path needs two edges to where the path can come from or go to.
  [[nodiscard]] bool can_be_passed(std::uint32_t left) const {
    return std::all_of(neighbours_[left].begin(), neighbours_[left].end(), [&](std::uint32_t v) {
      if (on_path_[v]) return true;
      const auto open = std::count_if(neighbours_[v].begin(), neighbours_[v].end(), [&](std::uint32_t w) {
        return !on_path_[w] || w == path_.back() || w == path_.front();
      });
      return open >= 2;
    });
  }

  Neighbours neighbours_;
  std::vector<bool> on_path_;
  std::vector<std::uint32_t> path_;
};

/// A Hamiltonian cycle 0, 1, 2, ... and chords of it: vertex v has one to v + jumps[v mod #jumps] (Lederberg, Coxeter
/// and Frucht's notation).
CubicGraph from_jumps(std::uint32_t vertex_count, const std::vector<int>& jumps) {
  CubicGraph graph{.vertex_count = vertex_count};
  const int count = static_cast<int>(vertex_count);
  for (int v = 0; v < count; ++v) {
    const auto at = static_cast<std::uint32_t>(v);
    graph.edges.push_back({at, (at + 1) % vertex_count});
    const int other = (v + jumps[at % jumps.size()] + count) % count;
    if (v < other) graph.edges.push_back({at, static_cast<std::uint32_t>(other)});
  }
  return graph;
}

/// The complete graph on four vertices, one of whose edges is cut open by a fifth: it alone has an edge to spare.
void add_half(CubicGraph& graph) {
  const std::uint32_t v = graph.vertex_count;
  for (const auto& [from, to] : {std::array{0U, 1U}, {0U, 2U}, {0U, 3U}, {1U, 2U}, {1U, 3U}, {2U, 4U}, {3U, 4U}}) {
    graph.edges.push_back({v + from, v + to});
  }
  graph.vertex_count += 5;
}

CubicGraph bridged() {
  CubicGraph graph;
  add_half(graph);
  add_half(graph);
  graph.edges.push_back({4, 9});
  return graph;
}

/// Vertices 0 and 1, joined by three diamonds: four vertices with all edges but one, by whose ends they are strung.
CubicGraph three_branches() {
  CubicGraph graph{.vertex_count = 2};
  for (std::uint32_t v = 2; v < 14; v += 4) {
    for (const auto& [from, to] : {std::array{0U, 1U}, {0U, 2U}, {1U, 2U}, {1U, 3U}, {2U, 3U}}) {
      graph.edges.push_back({v + from, v + to});
    }
    graph.edges.push_back({0, v});
    graph.edges.push_back({1, v + 3});
    graph.vertex_count += 4;
  }
  return graph;
}

/// W. T. Tutte, On Hamiltonian circuits, 1946: the first 3-connected cubic planar graph found to have none.
CubicGraph tutte() {
  return {.vertex_count = 46,
          .edges = {{0, 1},   {0, 2},   {0, 3},   {1, 4},   {1, 26},  {2, 10},  {2, 11},  {3, 18},  {3, 19},  {4, 5},
                    {4, 33},  {5, 6},   {5, 29},  {6, 7},   {6, 27},  {7, 8},   {7, 14},  {8, 9},   {8, 38},  {9, 10},
                    {9, 37},  {10, 39}, {11, 12}, {11, 39}, {12, 13}, {12, 35}, {13, 14}, {13, 15}, {14, 34}, {15, 16},
                    {15, 22}, {16, 17}, {16, 44}, {17, 18}, {17, 43}, {18, 45}, {19, 20}, {19, 45}, {20, 21}, {20, 41},
                    {21, 22}, {21, 23}, {22, 40}, {23, 24}, {23, 27}, {24, 25}, {24, 32}, {25, 26}, {25, 31}, {26, 33},
                    {27, 28}, {28, 29}, {28, 32}, {29, 30}, {30, 31}, {30, 33}, {31, 32}, {34, 35}, {34, 38}, {35, 36},
                    {36, 37}, {36, 39}, {37, 38}, {40, 41}, {40, 44}, {41, 42}, {42, 43}, {42, 45}, {43, 44}}};
}

}  // namespace

std::vector<NamedGraph> named_cubic_graphs() {
  return {{"k4", from_jumps(4, {2})},
          {"prism", from_jumps(6, {-3, -2, 2})},
          {"cube", from_jumps(8, {3, -3})},
          {"bridged", bridged()},
          {"truncated-tetrahedron", from_jumps(12, {2, 6, -2})},
          {"three-branches", three_branches()},
          {"dodecahedron", from_jumps(20, {10, 7, 4, -4, -7, 10, -4, 7, -7, 4})},
          {"tutte", tutte()}};
}

Expected<CubicGraph> named_cubic_graph(const std::string& name) {
  std::string known;
  for (NamedGraph& named : named_cubic_graphs()) {
    if (named.name == name) return std::move(named.graph);
    known += (known.empty() ? "" : ", ") + named.name;
  }
  return not_so("there is no graph called " + name + "; there are " + known);
}

Expected<void> check_cubic(const CubicGraph& graph) {
  std::vector<std::uint32_t> valence(graph.vertex_count, 0);
  std::set<std::array<std::uint32_t, 2>> seen;
  for (const auto& [from, to] : graph.edges) {
    const std::string edge = "the edge between " + std::to_string(from) + " and " + std::to_string(to);
    if (std::max(from, to) >= graph.vertex_count) return not_so(edge + " names a vertex that does not exist");
    if (from == to) return not_so(edge + " is a loop");
    if (!seen.insert({std::min(from, to), std::max(from, to)}).second) return not_so(edge + " is there twice");
    ++valence[from];
    ++valence[to];
  }
  for (std::uint32_t v = 0; v < graph.vertex_count; ++v) {
    if (valence[v] != 3) {
      return not_so("vertex " + std::to_string(v) + " has " + std::to_string(valence[v]) + " edges, not three");
    }
  }
  if (graph.vertex_count == 0 || !connected(neighbours_of(graph))) return not_so("the graph is not connected");
  return {};
}

std::optional<std::vector<std::uint32_t>> hamiltonian_cycle(const CubicGraph& graph) {
  CycleSearch search(graph);
  if (!search.run()) return std::nullopt;
  return search.take();
}

}  // namespace quadmatch::shapes
