#pragma once
/// Growth from many anchors at once (§4.4 from every anchor): each burns as a region of its own; regions that meet and
/// agree become one, those that meet and disagree leave a seam between them.

#include <cstdint>
#include <functional>
#include <vector>

#include "patchwork.hpp"

namespace quadmatch::regions {

/// An anchor to burn from. A weaker one waits, as if it were `handicap` faces away, and burns only if its faces are
/// still free by then.
struct Spark {
  Candidate place;
  std::uint32_t handicap = 0;
};

/// What a region met on its way, counted as it grows.
struct Account {
  std::uint32_t faces = 0;
  std::uint32_t agreeing = 0;              ///< extraordinary vertices on one of the same code
  std::uint32_t source_extraordinary = 0;  ///< extraordinary vertices touched
  std::uint32_t target_extraordinary = 0;
  std::uint32_t disagreeing = 0;  ///< vertices on one of another code

  void add(const Account& other);
  /// The share of extraordinary vertices touched that agree, in the mesh where it is larger; 1 where there are none.
  [[nodiscard]] double confidence() const;
};

/// Is what a region met such that it can be believed (DESIGN: below 0.6 it is almost always garbage)?
[[nodiscard]] bool believable(const Account& account, double least_confidence);

class Fire {
 public:
  /// @param patchwork  what is matched already stays, and burns on where it can.
  Fire(const Sides& sides, Patchwork& patchwork);
  /// Never drop this region.
  void protect(std::uint32_t region) { protected_.push_back(region); }

  /// Light these when their time comes. @param sparks  by handicap, ascending; ties burn in this order.
  void light(std::vector<Spark> sparks);
  /// Burn across faces whose corners all agree, nearest to evidence first, until none is left.
  void burn();
  /// Then match those with disagreeing corners too, the fewest first. Nothing grows from these.
  void burn_disagreeing();
  /// Drop the regions that cannot be believed. @return faces dropped.
  std::size_t drop_unbelievable(double least_confidence);
  /// Light the rim of all that is matched once more, after something was dropped.
  void rekindle();

  /// Write every face's final region into the patchwork, and return what each region met.
  std::vector<Account> settle();

 private:
  /// A vertex and the first partner it was given. At a seam it has several, and is contested.
  struct VertexState {
    VertexId partner;
    VertexCode code;
    bool contested = false;
  };
  /// Candidates at one distance, first come, first served.
  struct Bucket {
    std::vector<Candidate> candidates;
    std::size_t head = 0;
  };
  struct Deferred {
    Candidate candidate;
    std::uint32_t distance;
    std::uint32_t disagreeing;
  };

  /// May a candidate join a region, and if so, at how many corners do the codes disagree?
  struct Fit {
    bool fits = false;
    std::uint32_t disagreeing = 0;
  };

  [[nodiscard]] std::uint32_t find(std::uint32_t region);
  [[nodiscard]] bool belongs(FaceId source_face, std::uint32_t root) {
    return patchwork_.is_matched(source_face) && find(patchwork_.region(source_face)) == root;
  }
  void push(Candidate candidate, std::uint32_t distance);
  void prefetch(const Bucket& bucket) const;
  void light_due(std::uint32_t distance);
  [[nodiscard]] bool is_free(Candidate candidate) const {
    return !patchwork_.is_matched(source_.face(candidate.source)) &&
           !patchwork_.is_taken(target_.face(candidate.target));
  }
  void consider(Candidate candidate, std::uint32_t distance);
  /// The region that a candidate would join.
  [[nodiscard]] std::uint32_t root_beside(Candidate candidate);
  [[nodiscard]] Fit fit_of(Candidate candidate, std::uint32_t root);
  [[nodiscard]] bool corner_fits(VertexId v, VertexId w, HalfedgeId s, HalfedgeId t, std::uint32_t root);
  [[nodiscard]] bool edge_fits(HalfedgeId s, HalfedgeId t, std::uint32_t root);
  void accept(Candidate candidate, std::uint32_t root, std::uint32_t distance, bool leaf);
  /// Has neither vertex met a partner?
  [[nodiscard]] static bool is_new(const VertexState& left, const VertexState& right) {
    return (left.partner.value & right.partner.value) == VertexId::kNone;
  }
  bool note_vertices(Candidate candidate, std::uint32_t root);
  void unite(Candidate candidate, std::uint32_t region, Candidate beyond);
  void push_neighbours(Candidate candidate, std::uint32_t distance);
  void recount();

  const Mesh& source_;
  const Mesh& target_;
  Patchwork& patchwork_;
  PerVertex<VertexState> source_vertices_, target_vertices_;
  PerFace<std::uint32_t> distance_;  // of each matched source face; kLeaf: not grown from
  std::vector<std::uint32_t> parent_;
  std::vector<Account> accounts_;
  std::vector<Bucket> buckets_;
  std::uint32_t current_ = 0;
  std::vector<Deferred> deferred_;
  std::vector<std::uint32_t> protected_;
  std::vector<Spark> sparks_;
  std::size_t next_spark_ = 0;
};

}  // namespace quadmatch::regions
