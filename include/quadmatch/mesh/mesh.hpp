#pragma once
/// The connectivity of a polygon mesh (§2.1): half-edges, their twins, and the fans of faces around each vertex.
///
/// Built once from a `PolygonSoup`, never changed: analysis and matching have no failure path and share it
/// across threads without locks. In an all-quad mesh `next`, `prev` and `face` are arithmetic on 4f + k.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/ids.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch {

/// Why faces that share an edge are not adjacent across it.
enum class SeamKind : std::uint8_t {
  NonManifold,  ///< more than two half-edges
  Winding,      ///< two half-edges that run the same way
  SelfGlued,    ///< two half-edges of one face
  Degenerate,   ///< the edge joins a vertex to itself
};

/// An edge that is cut. All its half-edges lose their twins, whatever the order of the faces: pairing the
/// first two that come would make a renumbered copy of a dirty mesh a different mesh.
struct Seam {
  VertexId from, to;  ///< the ends, from <= to
  SeamKind kind;
  std::uint32_t uses;  ///< half-edges along it
};

/// Consecutive half-edges: `for (HalfedgeId h : mesh.halfedges(face))`.
class HalfedgeRange {
 public:
  class Iterator {
   public:
    using value_type = HalfedgeId;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    explicit Iterator(HalfedgeId here) : here_(here) {}
    [[nodiscard]] HalfedgeId operator*() const { return here_; }
    Iterator& operator++() {
      ++here_.value;
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++here_.value;
      return before;
    }
    bool operator==(const Iterator&) const = default;

   private:
    HalfedgeId here_;
  };

  HalfedgeRange(HalfedgeId first, std::uint32_t count) : first_(first), count_(count) {}
  [[nodiscard]] Iterator begin() const { return Iterator(first_); }
  [[nodiscard]] Iterator end() const { return Iterator(HalfedgeId(first_.value + count_)); }

 private:
  HalfedgeId first_;
  std::uint32_t count_;
};

class OutgoingRange;

class Mesh {
 public:
  /// Build the connectivity of a soup.
  ///
  /// @param soup  moved in; its positions (#V or 0) and corners stay in the mesh.
  /// @return      the mesh; degenerate, duplicate, wrongly wound and non-manifold faces are kept (see `seams`).
  /// @par Errors  BadIndex for a corner beyond vertex_count, TooFewCorners, TooLarge beyond 2^31 - 1 corners;
  ///              the message names the face.
  /// @par Cost    O(#V + #corners) time and memory, O(d log d) at a vertex of d edges.
  static Expected<Mesh> build(PolygonSoup soup);

  [[nodiscard]] std::uint32_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] std::uint32_t halfedge_count() const { return static_cast<std::uint32_t>(origin_.size()); }
  [[nodiscard]] std::uint32_t face_count() const { return face_count_; }
  /// Edges after cutting the seams: a non-manifold edge of three faces counts three times.
  [[nodiscard]] std::uint32_t edge_count() const { return edge_count_; }
  /// At least vertex_count(): a vertex of k fans owns the fan of its own number and k - 1 further ones.
  [[nodiscard]] std::uint32_t fan_count() const { return static_cast<std::uint32_t>(fan_start_.size()); }
  [[nodiscard]] bool all_quads() const { return face_starts_.empty(); }

  // Faces and half-edges.
  [[nodiscard]] HalfedgeId first(FaceId f) const {
    return HalfedgeId(all_quads() ? 4 * f.value : face_starts_[f.value]);
  }
  /// Number of corners.
  [[nodiscard]] std::uint32_t size(FaceId f) const {
    return all_quads() ? 4 : face_starts_[f.value + 1] - face_starts_[f.value];
  }
  [[nodiscard]] FaceId face(HalfedgeId h) const { return FaceId(all_quads() ? h.value / 4 : face_of_[h.value]); }
  /// Position of the half-edge in its face, 0 ... size - 1.
  [[nodiscard]] std::uint32_t corner(HalfedgeId h) const {
    return all_quads() ? h.value % 4 : h.value - face_starts_[face_of_[h.value]];
  }
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const {
    if (all_quads()) return HalfedgeId((h.value & ~3U) | ((h.value + 1) & 3U));
    // Which corner is the last nobody can guess, so there is no branch: below nothing unsigned numbers are the largest.
    const std::uint32_t f = face_of_[h.value], start = face_starts_[f], end = face_starts_[f + 1];
    return HalfedgeId(start + std::min(h.value + 1 - start, h.value + 1 - end));
  }
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const {
    if (all_quads()) return HalfedgeId((h.value & ~3U) | ((h.value + 3) & 3U));
    const std::uint32_t f = face_of_[h.value], start = face_starts_[f], end = face_starts_[f + 1];
    return HalfedgeId(start + std::min(h.value - start - 1, end - start - 1));
  }
  /// The opposite half-edge in the adjacent face; not valid on the boundary and at seams.
  [[nodiscard]] HalfedgeId twin(HalfedgeId h) const { return twin_[h.value]; }
  [[nodiscard]] VertexId origin(HalfedgeId h) const { return origin_[h.value]; }
  [[nodiscard]] VertexId tip(HalfedgeId h) const { return origin(next(h)); }
  [[nodiscard]] EdgeId edge(HalfedgeId h) const {
    const HalfedgeId other = twin(h);
    return EdgeId(other < h ? other.value : h.value);
  }
  /// The half-edges of a face, in order.
  [[nodiscard]] HalfedgeRange halfedges(FaceId f) const { return {first(f), size(f)}; }

  // Fans.
  /// The fan of the corner a half-edge leaves from.
  [[nodiscard]] FanId fan(HalfedgeId h) const {
    return FanId(fan_of_.empty() ? origin_[h.value].value : fan_of_[h.value]);
  }
  [[nodiscard]] VertexId vertex(FanId p) const {
    return p.value < vertex_count_ ? VertexId(p.value) : further_fan_vertex_[p.value - vertex_count_];
  }
  /// An outgoing half-edge: the clockwise-most one on the boundary; not valid where no face uses the vertex.
  [[nodiscard]] HalfedgeId halfedge(FanId p) const { return fan_start_[p.value]; }
  [[nodiscard]] bool is_boundary(FanId p) const { return halfedge(p).valid() && !twin(halfedge(p)).valid(); }
  /// The next outgoing half-edge counter-clockwise; not valid where the fan ends.
  [[nodiscard]] HalfedgeId rotate_ccw(HalfedgeId h) const { return twin(prev(h)); }
  /// The next outgoing half-edge clockwise; not valid where the fan ends.
  [[nodiscard]] HalfedgeId rotate_cw(HalfedgeId h) const {
    const HalfedgeId other = twin(h);
    return other.valid() ? next(other) : other;
  }
  /// The outgoing half-edges of a fan, counter-clockwise from halfedge(p): one per face.
  [[nodiscard]] OutgoingRange outgoing(FanId p) const;
  /// Number of edges of a fan, the paper's degree. O(valence).
  [[nodiscard]] std::uint32_t valence(FanId p) const;

  /// A hint that the half-edges of a face will be read soon. Growth jumps about in meshes far larger than any cache;
  /// asked for early, the answers of many faces travel at the same time.
  void prefetch(HalfedgeId h) const {
    prefetch_corners(h);
    prefetch_twins(h);
  }
  /// The same where only the neighbours of the face will be asked for.
  void prefetch_twins(HalfedgeId h) const { __builtin_prefetch(&twin_[h.value]); }
  /// The same where only its corners will be.
  void prefetch_corners(HalfedgeId h) const { __builtin_prefetch(&origin_[h.value]); }

  // Geometry, secondary always.
  /// #V points, or none.
  [[nodiscard]] std::span<const Point> positions() const { return positions_; }

  /// The vertices of all corners, face after face.
  [[nodiscard]] std::span<const VertexId> corners() const { return origin_; }

  // Departures found while building; `check` names the rest.
  /// Every cut edge, by its ends.
  [[nodiscard]] std::span<const Seam> seams() const { return seams_; }
  /// Vertices whose faces form several fans, ascending.
  [[nodiscard]] std::span<const VertexId> split_vertices() const { return split_vertices_; }

  /// The same mesh seen in a mirror: every face turned over. Face, vertex and fan ids stay; corner k of a face of
  /// n corners becomes corner n - 1 - k. O(#corners).
  [[nodiscard]] Mesh mirrored() const;

 private:
  Mesh() = default;
  void pair_twins();
  void gather_fans();

  std::uint32_t vertex_count_ = 0;
  std::uint32_t face_count_ = 0;
  std::uint32_t edge_count_ = 0;
  std::vector<VertexId> origin_;
  std::vector<HalfedgeId> twin_;
  std::vector<HalfedgeId> fan_start_;
  std::vector<std::uint32_t> face_starts_;  // empty where every face is a quad
  std::vector<std::uint32_t> face_of_;      // likewise
  std::vector<std::uint32_t> fan_of_;       // empty where every vertex has at most one fan
  std::vector<VertexId> further_fan_vertex_;
  std::vector<Point> positions_;
  std::vector<Seam> seams_;
  std::vector<VertexId> split_vertices_;
};

/// The outgoing half-edges of a fan, counter-clockwise: `for (HalfedgeId h : mesh.outgoing(fan))`.
class OutgoingRange {
 public:
  class Iterator {
   public:
    using value_type = HalfedgeId;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    Iterator(const Mesh* mesh, HalfedgeId start) : mesh_(mesh), start_(start), here_(start) {}
    [[nodiscard]] HalfedgeId operator*() const { return here_; }
    Iterator& operator++() {
      here_ = mesh_->rotate_ccw(here_);
      if (here_ == start_) here_ = HalfedgeId();
      return *this;
    }
    void operator++(int) { ++*this; }
    [[nodiscard]] bool operator==(std::default_sentinel_t) const { return !here_.valid(); }

   private:
    const Mesh* mesh_ = nullptr;
    HalfedgeId start_, here_;
  };

  OutgoingRange(const Mesh& mesh, HalfedgeId start) : mesh_(&mesh), start_(start) {}
  [[nodiscard]] Iterator begin() const { return {mesh_, start_}; }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }

 private:
  const Mesh* mesh_;
  HalfedgeId start_;
};

inline OutgoingRange Mesh::outgoing(FanId p) const { return {*this, halfedge(p)}; }

}  // namespace quadmatch
