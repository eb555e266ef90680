#pragma once
/// How badly a face lies on another: corners that disagree, and edge lengths, which survive posing.

#include <optional>
#include <utility>
#include <vector>

#include "lengths.hpp"
#include "patchwork.hpp"
#include "similarity.hpp"
#include "strain.hpp"

namespace quadmatch::regions {

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

  /// Take lengths as they come, where nothing is matched yet to learn from: both models of one size, but for a scale.
  /// @param sigma  how far lengths may usually differ.
  void assume(double sigma = 0.1);
  /// Learn from what is matched how far lengths differ where faces are the same; they are used only where that says
  /// something.
  void calibrate(const Patchwork& patchwork);

  /// What the user said: these pairs cost nothing, and any other for the same faces more than can be gained.
  void pin(std::vector<Candidate> pairs);
  [[nodiscard]] const std::vector<Candidate>& pins() const { return pins_; }
  /// Let distance decide between equals.
  /// @param placement  of the source in the space of the target; nothing: distances mean nothing.
  /// @param edge       the length of a target edge, the unit of distance.
  void place(const std::optional<Similarity>& placement, double edge);
  [[nodiscard]] bool is_placed() const { return placement_.has_value(); }
  [[nodiscard]] const std::optional<Similarity>& placement() const { return placement_; }
  [[nodiscard]] double edge() const { return edge_; }
  /// Are there positions, and may they be looked at?
  [[nodiscard]] bool may_use_positions() const { return with_positions_; }
  /// How far the middle of a face is from that of its image, in edges. @pre is_placed()
  [[nodiscard]] double distance(Candidate pair) const;

  [[nodiscard]] bool uses_lengths() const { return uses_lengths_; }
  /// Were they learnt from what is matched, and not only assumed?
  [[nodiscard]] bool trusts_lengths() const { return uses_lengths_ && learnt_; }
  /// Is the source posed, and are its lengths stretched accordingly?
  [[nodiscard]] bool is_stretched() const { return stretched_.has_value(); }
  /// The root mean square of the differences of log lengths over edges and diagonals, in units of what is usual
  /// (sigma): below 1 is good, above 3 bad. @pre uses_lengths().
  [[nodiscard]] double length_error(Candidate pair) const;
  /// The same in units of what is usual in the whole model, even where a stretched one fits worse all around: wrong
  /// pairs side by side must not excuse each other. @pre uses_lengths().
  [[nodiscard]] double strict_error(Candidate pair) const;
  /// The same, but of lengths as they are, and not in units of anything. @pre uses_lengths().
  [[nodiscard]] double plain_error(Candidate pair) const { return raw_error(pair, lengths_[0]); }
  /// The root mean square by which the logarithms of the ratios of opposite edges differ, which bending and sculpting
  /// change less than lengths; 0 for all faces but quads. @pre uses_lengths().
  [[nodiscard]] double taper_error(Candidate pair) const;
  /// What neither error is less than: told by one edge, which costs far less where the faces were not measured yet.
  [[nodiscard]] double least_length_error(Candidate pair) const;
  [[nodiscard]] double least_strict_error(Candidate pair) const;
  [[nodiscard]] std::uint32_t disagreeing_corners(Candidate pair) const;
  /// Corners where both meshes have an extraordinary vertex of the same code.
  [[nodiscard]] std::uint32_t telling_corners(Candidate pair) const;
  /// 0 for a perfect pair, less for a telling one; above kUnmatched it is better to leave the face unmatched.
  [[nodiscard]] double cost(Candidate pair) const;
  /// What a source face costs as it lies now. Kept until the face or the costs change.
  [[nodiscard]] double present_cost(const Patchwork& patchwork, FaceId source_face);

 private:
  /// A cost, and the state of face and costs for which it holds.
  struct Kept {
    std::uint32_t changed_at = 0;
    std::uint32_t costs = 0;
    double cost = 0;
  };
  /// Errors below which a quarter and half of the pairs are.
  struct Spread {
    double lower, middle;
  };
  [[nodiscard]] static double sigma_of(const Spread& spread);
  [[nodiscard]] Spread spread_of(const std::vector<Candidate>& sample) const;
  template <class Visit>
  std::size_t for_each_corner(Candidate pair, const Lengths& source_lengths, Visit visit) const;
  [[nodiscard]] const Lengths& source_lengths() const { return stretched_ ? stretched_->lengths : lengths_[0]; }
  [[nodiscard]] double raw_error(Candidate pair, const Lengths& ours) const;
  [[nodiscard]] double least_raw_error(Candidate pair) const;
  [[nodiscard]] double sigma_at(FaceId source_face) const;
  [[nodiscard]] double strict_sigma_at(FaceId source_face) const;
  [[nodiscard]] bool load_lengths();
  [[nodiscard]] double cost_by_pins(Candidate pair) const;

  const Sides& sides_;
  bool with_positions_;
  std::vector<Lengths> lengths_;        // source and target, once they are asked for
  std::optional<Stretched> stretched_;  // the source, if it was posed
  bool uses_lengths_ = false;
  bool learnt_ = false;
  double scale_ = 0.0;      // log of target size by source size
  double sigma_ = 1.0;      // what errors are usual
  double sigma_far_ = 1.0;  // the same where nobody knows the stretch
  std::vector<Candidate> pins_;
  std::optional<Similarity> placement_;
  PerFace<Point> placed_middles_, target_middles_;  // of faces, where the source is placed
  double edge_ = 1.0;
  PerFace<Kept> kept_;             // of source faces
  std::uint32_t costs_known_ = 0;  // how often what a pair costs has changed
};

}  // namespace quadmatch::regions
