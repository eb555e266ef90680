#pragma once
/// The edges across which no two faces are adjacent: the boundary, and the seams where a mesh is not manifold or not
/// consistently wound.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// One half-edge along an open edge.
struct OpenUse {
  VertexId low, high;  ///< the ends of its edge, low < high
  HalfedgeId halfedge;

  /// Do both run the same way? @pre both belong to one edge.
  [[nodiscard]] static bool same_direction(const Mesh& mesh, const OpenUse& one, const OpenUse& other) {
    return mesh.origin(one.halfedge) == mesh.origin(other.halfedge);
  }
};

/// Every half-edge without a twin, grouped by edge, for `for (std::span<const OpenUse> uses : OpenEdges(mesh))`.
/// Half-edges that join a vertex to itself belong to no edge and are left out.
class OpenEdges {
 public:
  /// O(#corners + k log k) for k half-edges without a twin.
  explicit OpenEdges(const Mesh& mesh);

  class Iterator {
   public:
    Iterator(const OpenUse* here, const OpenUse* end) : here_(here), end_(end) { find_next(); }
    [[nodiscard]] std::span<const OpenUse> operator*() const { return {here_, next_}; }
    Iterator& operator++() {
      here_ = next_;
      find_next();
      return *this;
    }
    bool operator==(const Iterator& other) const { return here_ == other.here_; }

   private:
    void find_next() {
      next_ = here_;
      while (next_ != end_ && next_->low == here_->low && next_->high == here_->high) ++next_;
    }

    const OpenUse* here_;
    const OpenUse* end_;
    const OpenUse* next_ = nullptr;
  };

  /// By lower, then by higher end; within an edge by half-edge.
  [[nodiscard]] Iterator begin() const { return {uses_.data(), uses_.data() + uses_.size()}; }
  [[nodiscard]] Iterator end() const { return {uses_.data() + uses_.size(), uses_.data() + uses_.size()}; }

 private:
  std::vector<OpenUse> uses_;
};

}  // namespace quadmatch
