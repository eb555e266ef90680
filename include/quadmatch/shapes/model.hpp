#pragma once
/// A model as an artist would deliver it: a mesh with named parts and texture coordinates.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>
#include <quadmatch/shapes/catmull_clark.hpp>

namespace quadmatch::shapes {

/// Faces from `first_face` on, to where the next part begins.
struct ModelPart {
  std::string name;
  std::string material;
  std::uint32_t first_face = 0;
};

struct Model {
  PolygonSoup soup;
  /// Ascending by first_face; the first begins at 0.
  std::vector<ModelPart> parts;
  /// One per corner, all within the unit square and no two faces on the same place.
  std::vector<TextureCoordinate> coordinates;
};

}  // namespace quadmatch::shapes
