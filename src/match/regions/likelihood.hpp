#pragma once
/// Could chance agree so often? What speaks for a handful of pairs, as a logarithm of likelihoods.

#include <array>
#include <span>
#include <vector>

#include "mending.hpp"

namespace quadmatch::regions {

class Likelihood {
 public:
  /// When it is first asked it learns how often chance agrees: how frequent each vertex code is in both meshes, and how
  /// often faces picked at random have lengths that fit. Where there is nothing to try nobody asks.
  /// @param judges  what is matched is judged: what it says itself of how the source is stretched is no evidence.
  explicit Likelihood(const Workbench& bench, bool judges = false);

  /// The logarithm of how much likelier it is that these pairs are true than that they came together by chance: rare
  /// codes that agree speak for them, codes that do not and lengths that do not fit against.
  /// @param pairs  of one region.
  /// @par Cost     O(#pairs)
  [[nodiscard]] double of(std::span<const Candidate> pairs);

  /// The same for as many of them from the first on as speak for themselves most: a trial that has run on into what an
  /// edit changed is not the worse for how it began.
  [[nodiscard]] double of_best_start(std::span<const Candidate> pairs);

  /// What of() can say at most, told by codes and places, before lengths have been learnt.
  [[nodiscard]] double at_most(std::span<const Candidate> pairs);

  /// The same of one vertex on another.
  [[nodiscard]] double of_vertex(VertexId v, VertexId w) {
    if (!knows_codes_) learn_codes();
    const VertexCode code = bench_.sides.source.code(v);
    return code == bench_.sides.target.code(w) ? agrees_[code.value] : disagrees_;
  }

  /// What chance has to beat: as many places as there are to begin in.
  [[nodiscard]] double needed_for_trial() const {
    return bench_.misfit.trusts_lengths() ? log_places_ + 2 : 3.2 * log_places_;
  }
  [[nodiscard]] double log_places() const { return log_places_; }

 private:
  const Workbench& bench_;
  bool judges_;
  // Each once, when it is first needed.
  void learn_codes();
  void learn_lengths();
  [[nodiscard]] double error_of(const Candidate& pair) const;
  [[nodiscard]] double least_error_of(const Candidate& pair) const;
  [[nodiscard]] static std::size_t error_class(double error);
  /// What one more pair says by its lengths; and in all, after those since now_ changed.
  [[nodiscard]] double by_lengths(const Candidate& pair) const;
  [[nodiscard]] double of_next(const Candidate& pair, double by_lengths);

  std::vector<double> agrees_;  // by code: what a vertex of this code on another of this code says
  bool knows_codes_ = false, knows_lengths_ = false;
  double disagrees_ = 0;              // what a vertex on one of another code says
  std::array<double, 4> by_error_{};  // what a face says whose lengths fit within one, two, three sigma, or do not
  PerVertex<std::uint32_t> seen_;
  std::uint32_t now_ = 0;
  double log_places_ = 0;  // log of the number of half-edges, the mean of both meshes
};

}  // namespace quadmatch::regions
