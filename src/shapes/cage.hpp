#pragma once
/// The coarse mesh that a box modeler works on: begin with a box, extrude, and let subdivision do the rest.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <quadmatch/shapes/model.hpp>

#include "geometry.hpp"

namespace quadmatch::shapes {

class Cage {
 public:
  using Vertex = std::uint32_t;
  using Face = std::uint32_t;
  /// Parts are numbered in the order in which their faces shall stand in the file.
  using Part = std::uint32_t;
  /// A rectangle of the texture in which faces are laid out, a unit square for each.
  using Chart = std::uint32_t;
  /// Where a vertex goes.
  using Motion = std::function<Point(const Point&)>;

  Vertex add_vertex(const Point& position);
  Chart add_chart();
  /// A quad at a column and row of a chart, its first corner lower left.
  Face add_face(Part part, Chart chart, std::uint32_t column, std::uint32_t row, const std::array<Vertex, 4>& corners);

  /// Pull faces out of the surface: they move as told, and a ring of quads joins them to their old rim.
  /// @param faces  they keep their numbers.
  /// @param part   of the new quads.
  /// @param chart  where the new quads are laid out, as one row above those it has.
  /// @return       the new quads, along the rim; the same order for the same faces.
  /// @pre          one rim, which passes no vertex twice and the lowest of the faces.
  std::vector<Face> extrude(std::span<const Face> faces, Part part, Chart chart, const Motion& motion);

  void set_part(Face face, Part part) { faces_[face].part = part; }
  [[nodiscard]] std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
  [[nodiscard]] const Point& position(Vertex vertex) const { return points_[vertex]; }
  [[nodiscard]] Point centre(std::span<const Face> faces) const;
  /// The one of the faces whose centre lies farthest in a direction.
  [[nodiscard]] Face farthest(std::span<const Face> faces, const Point& direction) const;

  /// Move every vertex that is used by faces of these parts and of no others.
  void move_parts(std::span<const Part> parts, const Motion& motion);
  void move_all(const Motion& motion);

  struct PartName {
    std::string name;
    std::string material;
  };

  /// Subdivide and deliver.
  /// @param names     one for each part; neighbouring parts of the same name become one.
  /// @param unit      of the charts, as a share of the texture's side.
  [[nodiscard]] Model finish(const std::vector<PartName>& names, unsigned steps, double unit) const;

 private:
  struct CageFace {
    std::array<Vertex, 4> corners;
    Part part;
    Chart chart;
    std::uint32_t column, row;
  };
  struct ChartSize {
    std::uint32_t columns = 0, rows = 0;
  };

  /// The rim of a set of faces as a loop: directed sides of faces, from the first one of the lowest face.
  [[nodiscard]] std::vector<std::array<Vertex, 2>> rim_of(std::span<const Face> faces) const;
  [[nodiscard]] std::vector<TextureCoordinate> place_charts() const;

  std::vector<Point> points_;
  std::vector<CageFace> faces_;
  std::vector<ChartSize> charts_;
};

/// Grow or shrink about a centre by a factor on each axis, then move.
[[nodiscard]] Cage::Motion scale_and_move(const Point& centre, const Point& factors, const Point& by);

/// Turn about an axis through a point, counter-clockwise when the axis points at the viewer.
/// @param axis   of unit length.
/// @param turns  1 is all the way round.
[[nodiscard]] Point turned(const Point& point, const Point& about, const Point& axis, double turns);

}  // namespace quadmatch::shapes
