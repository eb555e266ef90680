#pragma once
/// A soup being written anew, face by face, with a record of which faces it keeps.

#include <initializer_list>
#include <span>
#include <vector>

#include <quadmatch/shapes/edit.hpp>

namespace quadmatch::shapes {

class Redraft {
 public:
  explicit Redraft(const PolygonSoup& source);

  /// A new vertex midway between the given ones.
  VertexId add_vertex(std::initializer_list<VertexId> around);
  void move_vertex(VertexId vertex, const Point& by);
  void move_halfway(VertexId vertex, VertexId towards);

  /// Keep a face of the source, with its corners, or with these instead.
  void keep(FaceId face);
  void keep(FaceId face, std::span<const VertexId> corners);
  /// A new face. @pre all faces to be kept have been kept.
  void add(std::initializer_list<VertexId> corners) { append({corners.begin(), corners.size()}); }
  void add(const std::vector<VertexId>& corners) { append(corners); }

  /// The result, without the vertices that no face uses.
  [[nodiscard]] Edit finish();

 private:
  void append(std::span<const VertexId> corners);

  const PolygonSoup& source_;
  PolygonSoup draft_;
  std::vector<FacePair> truth_;
};

}  // namespace quadmatch::shapes
