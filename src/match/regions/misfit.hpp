#pragma once
/// How badly a face lies on another: corners that disagree, and edge lengths, which survive posing.

#include <optional>
#include <vector>

#include "patchwork.hpp"
#include "similarity.hpp"

namespace quadmatch::regions {

/// Logarithms of the lengths of edges and diagonals of one mesh.
class Lengths {
 public:
  explicit Lengths(const Mesh& mesh);

  /// From the corner that h leaves, along its edge.
  [[nodiscard]] float edge(HalfedgeId h) const { return edge_[h]; }
  /// From the corner that h leaves to the one after the next.
  [[nodiscard]] float diagonal(HalfedgeId h) const { return diagonal_[h]; }

 private:
  PerHalfedge<float> edge_, diagonal_;
};

/// What it costs to lay a face on another, to leave it unmatched, and to let two regions meet: the terms of the sum
/// that the later stages make small.
class Misfit {
 public:
  /// What an unmatched face costs.
  static constexpr double kUnmatched = 1.1;
  /// What an edge costs across which two matched faces are not each other's neighbours in the target.
  static constexpr double kSeam = 0.15;

  /// @param with_positions  false: lengths are never looked at.
  Misfit(const Sides& sides, bool with_positions);

  /// Learn from what is matched how far lengths differ where faces are the same; they are used only where that says
  /// something.
  void calibrate(const Patchwork& patchwork);

  /// Let distance decide between equals.
  /// @param placement  of the source in the space of the target; nothing: distances mean nothing.
  /// @param edge       the length of a target edge, the unit of distance.
  void place(const std::optional<Similarity>& placement, double edge) {
    placement_ = placement;
    edge_ = edge;
  }
  /// How far the middle of a face is from that of its image, in edges. @pre placed
  [[nodiscard]] double distance(Candidate pair) const;

  [[nodiscard]] bool uses_lengths() const { return uses_lengths_; }
  /// The root mean square of the differences of log lengths over edges and diagonals, in units of what is usual
  /// (sigma): below 1 is good, above 3 bad. @pre uses_lengths().
  [[nodiscard]] double length_error(Candidate pair) const;
  [[nodiscard]] std::uint32_t disagreeing_corners(Candidate pair) const;
  /// 0 for a perfect pair; above kUnmatched it is better to leave the face unmatched.
  [[nodiscard]] double cost(Candidate pair) const;

 private:
  [[nodiscard]] double raw_error(Candidate pair) const;

  const Sides& sides_;
  std::vector<Lengths> lengths_;  // source and target, or none
  bool uses_lengths_ = false;
  double scale_ = 0.0;  // log of target size by source size
  double sigma_ = 1.0;
  std::optional<Similarity> placement_;
  double edge_ = 1.0;
};

}  // namespace quadmatch::regions
