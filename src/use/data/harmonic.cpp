// The one source of this layer that includes Eigen.

#include "harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A number for each unknown node that a known one reaches, in order of nodes; kNone for all others.
std::vector<std::uint32_t> number_unknowns(const std::vector<WeightedEdge>& edges, const GraphValues& graph) {
  std::vector<std::uint32_t> starts(graph.known.size() + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++starts[edge.one + 1];
    ++starts[edge.other + 1];
  }
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<std::uint32_t> neighbours(starts.back());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (const WeightedEdge& edge : edges) {
    neighbours[next[edge.one]++] = edge.other;
    neighbours[next[edge.other]++] = edge.one;
  }
  std::vector<std::uint8_t> reached = graph.known;
  std::vector<std::uint32_t> to_visit;
  for (std::uint32_t node = 0; node < reached.size(); ++node) {
    if (graph.known[node] != 0) to_visit.push_back(node);
  }
  while (!to_visit.empty()) {
    const std::uint32_t node = to_visit.back();
    to_visit.pop_back();
    for (std::uint32_t k = starts[node]; k < starts[node + 1]; ++k) {
      if (reached[neighbours[k]] != 0) continue;
      reached[neighbours[k]] = 1;
      to_visit.push_back(neighbours[k]);
    }
  }
  std::vector<std::uint32_t> numbers(reached.size(), kNone);
  std::uint32_t count = 0;
  for (std::size_t node = 0; node < numbers.size(); ++node) {
    if (reached[node] != 0 && graph.known[node] == 0) numbers[node] = count++;
  }
  return numbers;
}

}  // namespace

void interpolate(const std::vector<WeightedEdge>& edges, GraphValues& graph) {
  const std::vector<std::uint32_t> numbers = number_unknowns(edges, graph);
  const auto count = static_cast<Eigen::Index>(
      std::count_if(numbers.begin(), numbers.end(), [](std::uint32_t number) { return number != kNone; }));
  if (count == 0) return;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, graph.components);
  const auto add = [&](std::uint32_t node, std::uint32_t neighbour, double weight) {
    const std::uint32_t row = numbers[node];
    if (row == kNone) return;
    entries.emplace_back(row, row, weight);
    if (numbers[neighbour] != kNone) {
      entries.emplace_back(row, numbers[neighbour], -weight);
    } else {
      for (std::uint32_t c = 0; c < graph.components; ++c) {
        right(row, c) += weight * graph.values[std::size_t{neighbour} * graph.components + c];
      }
    }
  };
  for (const WeightedEdge& edge : edges) {
    if (edge.one == edge.other) continue;
    add(edge.one, edge.other, edge.weight);
    add(edge.other, edge.one, edge.weight);
  }
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  // Positive definite, since every unknown node hangs together with a known one.
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(laplacian);
  if (factors.info() != Eigen::Success) return;
  const Eigen::MatrixXd solution = factors.solve(right);
  for (std::size_t node = 0; node < numbers.size(); ++node) {
    if (numbers[node] == kNone) continue;
    graph.known[node] = 1;
    for (std::uint32_t c = 0; c < graph.components; ++c) {
      graph.values[node * graph.components + c] = solution(numbers[node], c);
    }
  }
}

std::vector<double> edge_weights(const Mesh& mesh) {
  std::vector<double> weights(mesh.halfedge_count(), 1.0);
  const std::span<const Point> positions = mesh.positions();
  if (positions.empty()) return weights;
  double sum = 0;
  for (std::uint32_t h = 0; h < weights.size(); ++h) {
    const Point& from = positions[mesh.origin(HalfedgeId(h)).value];
    const Point& to = positions[mesh.tip(HalfedgeId(h)).value];
    weights[h] = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    sum += weights[h];
  }
  const double mean = weights.empty() ? 0 : sum / static_cast<double>(weights.size());
  constexpr double kShortest = 1e-3;  // of the mean: vertices in one place are close, not the same
  for (double& weight : weights) weight = mean > 0 ? mean / std::max(weight, kShortest * mean) : 1.0;
  return weights;
}

}  // namespace quadmatch::use
