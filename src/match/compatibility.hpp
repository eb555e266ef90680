#pragma once
/// The compatibility graph L of §4.5.2, kept up to date as the region grows instead of being rebuilt.

#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

#include "growth.hpp"

namespace quadmatch {

/// L, as runs along the wavefront S'.
///
/// A vertex of L is a candidate (q, r) across an edge of the wavefront. Two of them are adjacent in L where the
/// wavefront turns about a common vertex: between the two lies a *gap*, the unmatched faces around that vertex, and
/// they are compatible when the gap has equally many faces on both sides, so that the stars of the vertex agree. The
/// faces in the middle of a gap touch S' at the vertex only; they are the candidates across vertices, and come in with
/// the link. So a candidate has at most two neighbours in L, one about each end of its edge, and the components of L
/// are paths and cycles, here called *runs*.
///
/// Runs are doubly linked lists with their sizes. Joining two relabels the smaller, cutting one walks from the cut to
/// the nearer end, which keeps all updates together close to linear time in practice. (n joins alone or n cuts alone
/// take O(n log n); cutting and joining in turn in the middle of one run could take more, which growth does not do.)
///
/// Reading: the candidates across vertices come in with the links between those across edges. One that touches S' at a
/// vertex where the wavefront ends at the boundary becomes a candidate across an edge a wave later.
class CompatibilityGraph {
 public:
  explicit CompatibilityGraph(const Growth& growth);

  /// The region has grown by the pairs growth.order()[from ...]: take them off the wavefront and link what is new.
  void extend(std::size_t from);

  /// A candidate of a component; one across a vertex can be accepted only after the one before it was.
  struct Member {
    Candidate candidate;
    bool across_vertex = false;
  };

  /// A largest component of L, in the order of the wavefront, taken off it. Among equally large ones that whose colours
  /// (vertex codes at the far corners) disagree at fewer places, then the one whose oldest part has burned longest:
  /// ages count from the seed, so the order does not depend on the numbering of the meshes. Empty when L is.
  [[nodiscard]] std::vector<Member> take_largest();

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A vertex of L.
  struct Node {
    Candidate candidate;             // the half-edges across the wavefront, in the unmatched faces
    std::uint32_t next = kNone;      // about the origin of candidate.source
    std::uint32_t previous = kNone;  // about its tip
    std::uint32_t gap = 0;           // faces in the gap towards `next`
    std::uint32_t run = kNone;
    std::uint32_t disagreeing = 0;  // corners whose codes differ
  };

  /// A component of L.
  struct Run {
    std::uint32_t some_node = kNone;
    std::uint32_t nodes = 0;
    std::int64_t faces = 0;  // distinct faces: nodes + sum over links of (gap - 2)
    std::uint64_t disagreeing = 0;
    std::uint64_t birth = 0;
    std::uint64_t stamp = 0;  // of its latest queue entry; 0 where it has none that holds
    bool cyclic = false;
  };

  /// What lies about a vertex, from one candidate to the next wavefront edge.
  struct Gap {
    HalfedgeId source_end;  // the wavefront edge there, from the unmatched side; not valid at the boundary
    std::uint32_t faces = 0;
    bool agrees = false;
  };

  struct Entry {
    std::int64_t faces;
    std::uint64_t disagreeing;
    std::uint64_t birth;
    std::uint64_t stamp;
    std::uint32_t run;
    /// Less urgent than.
    bool operator<(const Entry& other) const {
      if (faces != other.faces) return faces < other.faces;
      if (disagreeing != other.disagreeing) return disagreeing > other.disagreeing;
      return birth > other.birth;
    }
  };

  void add_candidates(std::size_t from);
  void add_node(Candidate candidate);
  void remove_node(std::uint32_t node);
  void link_about_origin(std::uint32_t node);
  void link_about_tip(std::uint32_t node);
  void link(std::uint32_t node, std::uint32_t next, std::uint32_t gap);
  void unlink_next(std::uint32_t node);

  template <class Turn>
  [[nodiscard]] Gap walk_gap(Candidate candidate, Turn turn) const;
  template <class Visit>
  void for_each_in_middle(std::uint32_t node, Visit visit) const;

  [[nodiscard]] std::uint32_t new_run();
  void free_run(std::uint32_t run);
  void split(std::uint32_t left_end, std::uint32_t right_end);
  void move_part(std::uint32_t end, std::uint32_t Node::*onward, std::uint32_t from, std::uint32_t to);
  void touch(std::uint32_t run);
  void push_touched();

  [[nodiscard]] std::vector<std::uint32_t> nodes_of(std::uint32_t run) const;
  bool drop_misfits(std::uint32_t run);

  const Growth& growth_;
  const Mesh& source_;
  const Mesh& target_;
  PerHalfedge<std::uint32_t> node_at_;  // by candidate.source
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_nodes_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> free_runs_;
  std::vector<std::uint32_t> touched_;
  std::vector<Candidate> beyond_;  // scratch of add_candidates
  std::vector<std::uint32_t> new_nodes_;
  std::uint64_t clock_ = 0;
  std::priority_queue<Entry> queue_;
};

}  // namespace quadmatch
