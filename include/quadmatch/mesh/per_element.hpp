#pragma once
/// Data beside the mesh: one value for each vertex, fan or face, indexed only by an id of its own kind.

#include <cstddef>
#include <span>
#include <vector>

#include <quadmatch/mesh/ids.hpp>
#include <quadmatch/mesh/large_pages.hpp>

namespace quadmatch {

template <class IdType, class T>
class PerElement {
 public:
  PerElement() = default;
  explicit PerElement(std::size_t count, T value = {}) { assign_on_large_pages(values_, count, value); }

  [[nodiscard]] decltype(auto) operator[](IdType id) { return values_[id.value]; }
  [[nodiscard]] decltype(auto) operator[](IdType id) const { return values_[id.value]; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }

 private:
  std::vector<T> values_;
};

template <class T>
using PerVertex = PerElement<VertexId, T>;
template <class T>
using PerFan = PerElement<FanId, T>;
template <class T>
using PerHalfedge = PerElement<HalfedgeId, T>;
template <class T>
using PerFace = PerElement<FaceId, T>;

}  // namespace quadmatch
