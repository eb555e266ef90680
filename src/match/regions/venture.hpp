#pragma once
/// A venture: growth over free faces that dares to go on past corners that disagree, and is cut back in the end to what
/// agrees beyond them. Where edits are dense half of all faces have a corner that an edit changed.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "likelihood.hpp"
#include "mending.hpp"

namespace quadmatch::regions {

class Venture {
 public:
  Venture(Workbench& bench, Likelihood& likelihood) : bench_(bench), likelihood_(likelihood) {}

  /// Carry a region's map on, in the bench's ghost.
  /// @return  the pairs worth keeping; together with the region they are sound.
  const std::vector<Candidate>& from_region(std::uint32_t region);
  /// Begin anew. @return the pairs worth keeping; none if the seed does not fit, or nothing speaks for it.
  const std::vector<Candidate>& from_seed(Candidate seed, std::size_t most_faces);
  /// What speaks for the pairs kept last, a logarithm of likelihoods.
  [[nodiscard]] double worth() const { return worth_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  /// A pair that may be next, and the face from which it was reached.
  struct Step {
    double belief;
    std::uint32_t number;  // earlier ones first among equals
    std::uint32_t parent;
    Candidate pair;

    bool operator<(const Step& other) const {
      return belief != other.belief ? belief < other.belief : number > other.number;
    }
  };
  /// A pair of the ghost: what it says by itself, and the pair from which it was reached.
  struct Node {
    std::uint32_t parent;
    double score;
  };

  [[nodiscard]] bool is_free(Candidate pair) const {
    return !bench_.patchwork.is_matched(source_.face(pair.source)) &&
           !bench_.patchwork.is_taken(target_.face(pair.target));
  }
  void begin(std::uint32_t base);
  void push_neighbours(Candidate pair, std::uint32_t parent, double belief);
  void grow(std::size_t most_faces);
  [[nodiscard]] double score(Candidate pair);
  void cut_back();

  Workbench& bench_;
  Likelihood& likelihood_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  std::vector<Step> queue_;  // a heap
  std::vector<Node> nodes_;  // in the order of the ghost's pairs
  std::vector<Candidate> kept_;
  std::uint32_t count_ = 0;
  double worth_ = 0;
};

}  // namespace quadmatch::regions
