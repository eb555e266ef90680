#pragma once
/// What leaving out a pair costs where all labels agree: a slit of lost faces that ends only where they no longer do.

#include <array>
#include <cstdint>
#include <vector>

#include "development.hpp"
#include "faces_at.hpp"
#include "partial.hpp"

namespace quadmatch::exact {

/// Let D be the partial region M with faces around it whose labels agree, so that M and these labels are a region. Let
/// R be a region that holds M, and u a pair beyond the rim with its label, left out of R though it fits it. Something
/// in R clashes with u at a vertex (witnesses.hpp) and reached it from outside D, since inside R has the labels of D.
/// So along the part of R that hangs together with M in D, faces are lost from u to the edge of D to its left, and to
/// its right: a slit. They are lost in both meshes. docs/design/011-exact.md has the argument.
class Slits {
 public:
  Slits(Partial& partial, const FacesAt& faces_at);

  /// Do the meshes allow the argument? It needs surfaces on which every closed curve parts the inside from the outside.
  [[nodiscard]] bool allowed() const { return allowed_; }

  /// Take in what would cost more to leave out than a better region can lose.
  /// @param labels  from Development::spread, of the side that has the levels.
  /// @param spare   faces that a better region loses at most beside those that are out, anywhere.
  /// @return        true if anything was taken in.
  /// @pre allowed()
  bool take_in(const std::vector<Pair>& labels, Rim& rim, std::uint32_t spare);

 private:
  void mark(const std::vector<Pair>& labels);
  [[nodiscard]] bool take_in_level(std::uint32_t level, std::uint32_t spare, Rim& rim);
  void find_shallow(std::uint32_t level, std::uint32_t depth);
  [[nodiscard]] bool is_within(FaceId face, std::uint32_t level) const;
  [[nodiscard]] bool is_at_end(FaceId face, std::uint32_t level) const;

  Partial& partial_;
  const FacesAt& faces_at_;
  bool allowed_;
  Side side_ = kSource;
  std::uint32_t stamp_ = 0, shallow_ = 0;
  PerFace<std::uint32_t> labelled_, shallow_stamp_;  // of either side, so as many as the larger has faces
  PerVertex<std::uint8_t> inner_;                    // all faces around it are in D, on the side of the levels
  std::vector<FaceId> disc_, queue_;
};

}  // namespace quadmatch::exact
