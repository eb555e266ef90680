#pragma once
/// Components that share vertices, as plain arrays: what the search over tied components works on.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::canonical {

/// H half-edges and V vertices, numbered as elements 0 ... H - 1 and H ... H + V - 1. Vertices that are told apart from
/// all others already are no elements.
struct Tangle {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<HalfedgeId> halfedges;
  std::vector<VertexId> vertices;

  // By half-edge.
  std::vector<std::uint32_t> prev;
  std::vector<std::uint32_t> twin;    ///< kNone where there is none
  std::vector<std::uint32_t> origin;  ///< the element; kNone where the vertex is none
  std::vector<std::uint32_t> piece;   ///< its component across edges, 0 ... pieces - 1
  std::uint32_t pieces = 0;

  /// Half-edges that leave each vertex, those of vertex element H + v from leaving_first[v] on.
  std::vector<std::uint32_t> leaving, leaving_first;

  [[nodiscard]] std::uint32_t halfedge_count() const { return static_cast<std::uint32_t>(halfedges.size()); }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(halfedges.size() + vertices.size()); }
  [[nodiscard]] bool is_vertex(std::uint32_t element) const { return element >= halfedges.size(); }
  [[nodiscard]] std::span<const std::uint32_t> leaving_of(std::uint32_t vertex_element) const {
    const std::size_t v = vertex_element - halfedges.size();
    return std::span(leaving).subspan(leaving_first[v], leaving_first[v + 1] - leaving_first[v]);
  }
};

/// The tangle of some faces of a mesh, whole components of it; every vertex is an element.
[[nodiscard]] Tangle tangle_of(const Mesh& mesh, std::span<const FaceId> faces);

/// A part of a tangle: whole pieces, and of their vertices those that are kept as elements.
/// @param halfedges    elements of the tangle, whole pieces.
/// @param keeps_vertex by element.
/// @param elements     filled with the element of the tangle that each element of the part was.
[[nodiscard]] Tangle part_of(const Tangle& tangle, std::span<const std::uint32_t> halfedges,
                             const std::vector<bool>& keeps_vertex, std::vector<std::uint32_t>& elements);

}  // namespace quadmatch::canonical
