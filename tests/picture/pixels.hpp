#pragma once
/// Looking at pictures, and where the faces of a flat grid must be in them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include <doctest/doctest.h>
#include <quadmatch/picture/picture.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch::test {

using Pixel = std::array<int, 3>;

inline Pixel pixel(const Raster& raster, std::uint32_t x, std::uint32_t y) {
  const std::size_t at = 3 * (std::size_t{y} * raster.width + x);
  return {raster.rgb[at], raster.rgb[at + 1], raster.rgb[at + 2]};
}

inline bool is_red(const Pixel& p) { return p[0] > 90 && p[0] > 2.4 * p[1] && p[0] > 2.4 * p[2]; }
inline bool is_white(const Pixel& p) { return p == Pixel{255, 255, 255}; }
/// Of the fire front: bright yellow.
inline bool is_front(const Pixel& p) { return p[0] > 150 && p[1] > 0.9 * p[0] && p[2] < 0.4 * p[0]; }
/// Grey, of faces that wait.
inline bool is_grey(const Pixel& p) { return std::abs(p[0] - p[1]) < 4 && std::abs(p[1] - p[2]) < 10 && p[0] < 250; }

inline MeshFile file_of(PolygonSoup soup, std::string path = "a.obj") {
  return MeshFile{.mesh = build(std::move(soup)), .path = std::move(path)};
}

/// All faces of a mesh on themselves, but for some; in one region, as they are numbered, each wave one face.
inline Match on_itself(const Mesh& mesh, const std::vector<std::uint32_t>& but = {}) {
  Match match;
  match.regions.emplace_back();
  Region& region = match.regions.front();
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (std::find(but.begin(), but.end(), f) != but.end()) continue;
    region.faces.push_back({FaceId(f), FaceId(f), 0});
    region.waves.push_back(static_cast<std::uint32_t>(region.faces.size()));
  }
  return match;
}

/// Where a grid of n by n squares is seen from the front, in a pane `size` pixels wide and high.
class SeenGrid {
 public:
  static constexpr int kBeside = -1;
  static constexpr int kAtEdge = -2;

  SeenGrid(std::uint32_t n, std::uint32_t size) : n_(n), size_(size) {}

  /// The square a pixel shows, row by row from below; or none, or that it is too near to an edge to say.
  [[nodiscard]] int square_at(std::uint32_t x, std::uint32_t y) const {
    const double column = place(x + 0.5), row = place(size_ - (y + 0.5));
    const double near = 2.5 / pixels_of_square();
    if (std::abs(column - std::round(column)) < near || std::abs(row - std::round(row)) < near) return kAtEdge;
    if (column < 0 || column > n_ || row < 0 || row > n_) return kBeside;
    return static_cast<int>(row) * static_cast<int>(n_) + static_cast<int>(column);
  }

 private:
  /// The circle around the grid fills the pane, but for a margin of a twentieth of the sphere's distance.
  [[nodiscard]] double pixels_of_square() const {
    const double angle = 15 * std::acos(-1.0) / 180;
    const double pixels_of_radius = size_ / 2.0 / std::tan(angle) * std::sin(angle) / 1.05;
    return pixels_of_radius * std::sqrt(2.0) / n_;
  }
  [[nodiscard]] double place(double pixels) const { return (pixels - size_ / 2.0) / pixels_of_square() + n_ / 2.0; }

  std::uint32_t n_, size_;
};

/// A name in the folder for temporary files, gone at the end.
class TemporaryName {
 public:
  explicit TemporaryName(const std::string& ending)
      : name_((std::filesystem::temp_directory_path() / ("quadmatch-picture-" + std::to_string(::getpid()) + ending))
                  .string()) {}
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName() { std::filesystem::remove(name_); }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

}  // namespace quadmatch::test
