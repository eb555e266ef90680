#pragma once
/// The state every matcher grows: the map mu of §4.5.1 on faces, and the vertex map that comes with it.

#include <cstdint>
#include <functional>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch {

/// Called now and then with the faces matched so far; false cancels.
using GrowthProgress = std::function<bool(std::size_t matched)>;

/// A possible pair (q, r) of §4.5.1, named by half-edges that lie on each other: q = face(source), r = face(target).
using Candidate = Anchor;

/// One region under growth, orientation preserving: S, mu and the vertex map. Only sound pairs get in, so whatever
/// order they come in, the region satisfies §3.
class Growth {
 public:
  Growth(const Mesh& source, const PerFan<VertexCode>& source_codes, const Mesh& target,
         const PerFan<VertexCode>& target_codes);

  [[nodiscard]] const Mesh& source() const { return source_; }
  [[nodiscard]] const Mesh& target() const { return target_; }

  [[nodiscard]] bool is_matched(FaceId source_face) const { return matched_[source_face.value]; }
  [[nodiscard]] bool is_taken(FaceId target_face) const { return taken_[target_face.value]; }
  /// mu, on half-edges. @pre the face of h is matched.
  [[nodiscard]] HalfedgeId image(HalfedgeId h) const;

  /// May this pair join the region? Both faces are free, have equal corner counts, agree with the vertex map at every
  /// corner, and are adjacent to matched faces across corresponding edges only.
  [[nodiscard]] bool fits(Candidate candidate) const;
  /// Corners of the matched faces that are extraordinary in the source.
  [[nodiscard]] std::size_t extraordinary_corners() const;
  /// Corners beyond the edge of the candidate whose codes, the colours of round 0, differ.
  [[nodiscard]] std::uint32_t disagreeing_corners(Candidate candidate) const;

  /// Hints that fits() and disagreeing_corners() will be asked soon: first for the faces, and when those have had time
  /// to arrive, for what is known of their vertices.
  void prefetch_faces(Candidate candidate) const {
    source_.prefetch(candidate.source);
    target_.prefetch(candidate.target);
  }
  void prefetch_vertices(Candidate candidate) const;

  /// Extend mu. @pre fits(candidate), and an edge joins it to the region unless it is the seed.
  void accept(Candidate candidate);
  /// Take every pair out again, at the cost of putting them in.
  void clear();
  /// The faces matched since the last call form a wave.
  void end_wave() { waves_.push_back(static_cast<std::uint32_t>(order_.size())); }

  [[nodiscard]] std::size_t matched_faces() const { return order_.size(); }
  /// The seed first, then in the order of acceptance; each by the half-edge it was accepted with.
  [[nodiscard]] const std::vector<Candidate>& order() const { return order_; }

  /// The region grown so far, with rotations for the target as it was given.
  [[nodiscard]] Region region(Orientation orientation, bool with_waves) const;
  /// The vertex map, ascending by source.
  [[nodiscard]] std::vector<VertexPair> vertex_pairs() const;

 private:
  /// A vertex with its partner in the other mesh, if it has one. A vertex of several fans has the code of its first.
  struct VertexState {
    VertexId partner;
    VertexCode code;
  };
  [[nodiscard]] static PerVertex<VertexState> unpaired(const Mesh& mesh, const PerFan<VertexCode>& codes);

  [[nodiscard]] static bool has_folded_face(const Mesh& mesh);
  [[nodiscard]] bool corners_agree(Candidate candidate, std::uint32_t size) const;
  [[nodiscard]] bool revisits_agree(Candidate candidate, std::uint32_t size) const;
  [[nodiscard]] bool neighbours_agree(Candidate candidate, std::uint32_t size) const;

  const Mesh& source_;
  const Mesh& target_;
  std::vector<bool> matched_;  // bits: the wavefront asks for little else
  std::vector<bool> taken_;
  bool folded_;                         // some face visits a vertex twice
  PerFace<HalfedgeId> image_of_first_;  // image of each matched source face's first half-edge
  PerVertex<VertexState> source_vertices_;
  PerVertex<VertexState> target_vertices_;
  std::vector<Candidate> order_;
  std::vector<std::uint32_t> waves_;
};

/// §4.4: accept every quad that fits, wave by wave. False if cancelled.
bool grow_greedily(Growth& growth, const GrowthProgress& progress);

/// §4.5: accept the largest component of the compatibility graph, again and again. False if cancelled.
bool grow_lazily(Growth& growth, const GrowthProgress& progress);

/// §4.1, "then look for matching neighbours": the anchor from which a fire spreads farthest before it meets a corner
/// that disagrees; among nearly equal ones the first. Not valid if none can be laid.
/// @param growth  empty, and empty again afterwards.
[[nodiscard]] Anchor choose_seed(Growth& growth, const std::vector<Anchor>& anchors);

/// Count what speaks for a vertex map: extraordinary vertices touched on either side, and those that agree.
[[nodiscard]] Evidence weigh(const std::vector<VertexPair>& vertices, const PerFan<VertexCode>& source_codes,
                             const PerFan<VertexCode>& target_codes);

}  // namespace quadmatch
