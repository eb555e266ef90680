#pragma once
/// How shapes are put together: point by point and face by face.

#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

class SoupBuilder {
 public:
  VertexId vertex(double x, double y, double z) { return vertex(Point{x, y, z}); }
  VertexId vertex(const Point& point) {
    soup_.positions.push_back(point);
    return VertexId(soup_.vertex_count++);
  }

  void quad(VertexId a, VertexId b, VertexId c, VertexId d) { face(std::initializer_list<VertexId>{a, b, c, d}); }
  void face(std::span<const VertexId> corners) {
    starts_.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    all_quads_ = all_quads_ && corners.size() == 4;
    soup_.corners.insert(soup_.corners.end(), corners.begin(), corners.end());
  }
  void face(std::initializer_list<VertexId> corners) { face(std::span(corners.begin(), corners.size())); }
  /// A face by vertex numbers.
  void face_of(std::initializer_list<std::uint32_t> numbers) {
    std::vector<VertexId> corners;
    for (const std::uint32_t number : numbers) corners.push_back(VertexId(number));
    face(corners);
  }

  [[nodiscard]] PolygonSoup take() {
    if (!all_quads_) {
      starts_.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
      soup_.face_starts = std::move(starts_);
    }
    return std::move(soup_);
  }

 private:
  PolygonSoup soup_;
  std::vector<std::uint32_t> starts_;
  bool all_quads_ = true;
};

}  // namespace quadmatch::shapes
