#pragma once
/// Lengths of a mesh.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::regions {

/// Logarithms of the lengths of edges and diagonals of one mesh, measured face by face when they are first asked for:
/// where little was edited few are.
class Lengths {
 public:
  /// Of one corner, side by side: they are asked for together.
  struct Pair {
    float edge = 0;      ///< from the corner to the next
    float diagonal = 0;  ///< from the corner to the one after the next
  };

  /// @pre the mesh has positions and outlives the lengths
  explicit Lengths(const Mesh& mesh);

  /// Those of a face, corner by corner. Good until another face is asked for.
  [[nodiscard]] std::span<const Pair> of(FaceId face) const {
    if (first_[face] == kUnknown) measure(face);
    return {pairs_.data() + first_[face], mesh_->size(face)};
  }
  [[nodiscard]] float edge(HalfedgeId h) const { return of(mesh_->face(h))[mesh_->corner(h)].edge; }
  /// The same, but if its face was not measured yet it is not now either.
  [[nodiscard]] float single_edge(HalfedgeId h) const;
  [[nodiscard]] float diagonal(HalfedgeId h) const { return of(mesh_->face(h))[mesh_->corner(h)].diagonal; }
  /// The median over all half-edges. @pre there are some
  [[nodiscard]] float median_edge() const;

  /// The same lengths, each larger by what stretch(h) says, a Pair, of its half-edge h.
  template <class Stretch>
  [[nodiscard]] Lengths stretched(Stretch stretch) const {
    measure_all();
    Lengths result = *this;
    for (std::uint32_t f = 0; f < mesh_->face_count(); ++f) {
      Pair* pair = result.pairs_.data() + first_[FaceId(f)];
      for (const HalfedgeId h : mesh_->halfedges(FaceId(f))) {
        const Pair by = stretch(h);
        pair->edge += by.edge;
        pair->diagonal += by.diagonal;
        ++pair;
      }
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kUnknown = 0xffffffff;

  void measure(FaceId face) const;
  void measure_all() const;

  const Mesh* mesh_;
  mutable PerFace<std::uint32_t> first_;  // of each face that was measured, its place in pairs_
  mutable std::vector<Pair> pairs_;
};

}  // namespace quadmatch::regions
