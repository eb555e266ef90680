// Read from top to bottom: the match of a mesh with its mirror image, made one mirror that is its own inverse; where
// that has a choice, all mirrors of the component and the best of them; then the line, and what is left.

#include <quadmatch/use/symmetry.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/components.hpp>

#include "mirror_map.hpp"
#include "mirror_plane.hpp"
#include "mirror_regions.hpp"
#include "mirror_search.hpp"
#include "part_mesh.hpp"

namespace quadmatch {
namespace use {
namespace {

/// Of the faces a match pairs in a component, how many must lie on each other both ways for it to be one mirror.
constexpr double kOneMirror = 0.9;

/// What a match with the mirror image says of one component.
struct Tally {
  std::uint32_t faces = 0;
  std::uint32_t matched = 0;
  std::uint32_t onto_itself = 0;  ///< matched with a face of the component
  std::uint32_t mutual = 0;       ///< and that one with it, in the same place
  std::uint32_t taken = 0;        ///< partners of any face
  std::uint32_t ways = 1;
  bool has_line = false;

  /// Does it have to be asked for its mirrors?
  [[nodiscard]] bool is_in_doubt() const {
    if (matched == 0) return taken == 0;
    if (2 * onto_itself < matched) return false;  // it lies opposite another one
    return ways > 1 || !has_line || mutual < kOneMirror * matched;
  }
};

class SymmetryFinder {
 public:
  SymmetryFinder(const Mesh& mesh, const SymmetryOptions& options)
      : mesh_(mesh),
        options_(options),
        edge_(options.positions ? mean_edge(mesh) : 0),
        codes_(vertex_codes(mesh)),
        components_(connected_components(mesh)),
        map_(mesh, codes_) {}

  Symmetry run() {
    Symmetry symmetry;
    const Match match = match_with_image(mesh_, {});
    symmetry.complete = match.complete;
    const std::vector<Tally> tallies = tallied(match);
    const std::uint32_t largest = largest_component();
    for (std::uint32_t c = 0; c < tallies.size() && symmetry.complete; ++c) {
      if (tallies[c].is_in_doubt()) settle(c, c == largest, symmetry);
    }
    lay_mutual(match);
    lay_rest(match);
    map_.grow(Fit::Looks);
    if (symmetry.mirrors == 0 && components_.face_count.size() > 0) {
      symmetry.mirrors = laid_in(largest) > 0 ? 1 : 0;
      symmetry.maybe_more = laid_in(largest) < components_.face_count[largest];
    }
    finish(symmetry);
    return symmetry;
  }

 private:
  /// The mesh on itself in a mirror: its faces turned over, and its positions mirrored too, so that a model at rest
  /// lies on its image by a motion.
  [[nodiscard]] Match match_with_image(const Mesh& mesh, std::vector<UserAnchor> anchors) const {
    MatchOptions options;
    options.orientation = OrientationChoice::Reversing;
    options.positions = edge_ > 0;
    options.anchors = std::move(anchors);
    options.progress = options_.progress;
    if (edge_ <= 0) return match_regions_of(mesh, mesh, options);
    return match_regions_of(mesh, moved(mesh, likely_plane(mesh, edge_)), options);
  }
  [[nodiscard]] static Match match_regions_of(const Mesh& source, const Mesh& target, const MatchOptions& options) {
    return quadmatch::match(source, target, options).match;
  }

  [[nodiscard]] std::uint32_t largest_component() const {
    const auto& counts = components_.face_count;
    return static_cast<std::uint32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  }

  [[nodiscard]] std::vector<Tally> tallied(const Match& match) const {
    std::vector<Tally> tallies(components_.face_count.size());
    const PerHalfedge<HalfedgeId> images = images_of(mesh_, match);
    for (const Region& region : match.regions) {
      for (const FacePair& pair : region.faces) {
        Tally& tally = tallies[components_.of_face[pair.source]];
        const HalfedgeId first = mesh_.first(pair.source);
        const bool mutual = images[images[first]] == first;
        ++tally.matched;
        ++tallies[components_.of_face[pair.target]].taken;
        tally.onto_itself += components_.of_face[pair.target] == components_.of_face[pair.source];
        tally.mutual += mutual;
        tally.ways = std::max(tally.ways, region.ways);
        if (!mutual || tally.has_line) continue;
        tally.has_line = pair.source == pair.target;
        for (const HalfedgeId h : mesh_.halfedges(pair.source)) {
          tally.has_line = tally.has_line || (mesh_.twin(h).valid() && images[h] == mesh_.twin(h));
        }
      }
    }
    return tallies;
  }

  /// Look through all mirrors of a component, and lay the best.
  void settle(std::uint32_t component, bool is_largest, Symmetry& symmetry) {
    if (!search_) search_.emplace(mesh_, codes_, components_, edge_);
    const MirrorsOfComponent found = search_->mirrors_of(component);
    if (found.mirrors.empty()) return;
    if (is_largest) {
      for (const Mirror& mirror : found.mirrors) symmetry.mirrors += mirror.line_length > 0 ? 1 : 0;
      symmetry.mirrors = std::max(symmetry.mirrors, 1U);
      symmetry.maybe_more = found.maybe_more;
    }
    const Mirror& best = found.mirrors.front();
    if (best.whole) {
      map_.lay(best.germ, Fit::Looks);
      map_.grow(Fit::Looks);
    } else {
      settle_edited(component, best);
    }
  }

  /// An edited component: match it with its image once more, from the germ of the mirror on.
  void settle_edited(std::uint32_t component, const Mirror& mirror) {
    const PartMesh part(mesh_, components_, component);
    const auto anchor = [&](HalfedgeId from, HalfedgeId to) {  // what the first leaves lies on what the second reaches
      return UserAnchor{part.from_whole(from), part.from_whole(mesh_.next(to))};
    };
    const Match match = match_with_image(
        part.mesh(), {anchor(mirror.germ.from, mirror.germ.to), anchor(mirror.germ.to, mirror.germ.from)});
    const PerHalfedge<HalfedgeId> images = images_of(part.mesh(), match);
    std::uint32_t mutual = 0;
    for (std::uint32_t f = 0; f < part.mesh().face_count(); ++f) {
      const HalfedgeId first = part.mesh().first(FaceId(f));
      mutual += images[first].valid() && images[images[first]] == first;
    }
    if (mutual < mirror.faces) {  // then growth by itself came farther
      map_.lay(mirror.germ, Fit::Looks);
      map_.grow(Fit::Looks);
    }
    for (const bool both_ways : {true, false}) {
      for (const Region& region : match.regions) {
        for (const FacePair& pair : region.faces) {
          const HalfedgeId first = part.mesh().first(pair.source);
          if (both_ways && images[images[first]] != first) continue;
          map_.lay({part.to_whole(first), part.to_whole(images[first])}, both_ways ? Fit::Free : Fit::Vertices);
        }
      }
    }
  }

  /// What lies on each other both ways is certain.
  void lay_mutual(const Match& match) {
    const PerHalfedge<HalfedgeId> images = images_of(mesh_, match);
    for (const Region& region : match.regions) {
      for (const FacePair& pair : region.faces) {
        const HalfedgeId first = mesh_.first(pair.source);
        if (images[images[first]] == first) map_.lay({first, images[first]}, Fit::Free);
      }
    }
  }

  /// Where the match says two things of a face, the larger region is believed.
  void lay_rest(const Match& match) {
    const PerHalfedge<HalfedgeId> images = images_of(mesh_, match);
    for (const Region& region : match.regions) {
      for (const FacePair& pair : region.faces) {
        const HalfedgeId first = mesh_.first(pair.source);
        map_.lay({first, images[first]}, Fit::Vertices);
      }
    }
  }

  [[nodiscard]] std::uint32_t laid_in(std::uint32_t component) const {
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      count += components_.of_face[FaceId(f)] == component && map_.image(FaceId(f)).valid();
    }
    return count;
  }

  void finish(Symmetry& symmetry) const {
    symmetry.match.regions = regions_of(mesh_, codes_, map_, [](FaceId) { return true; });
    symmetry.match.vertices = vertices_of(mesh_, symmetry.match.regions, true);
    symmetry.match.complete = symmetry.complete;
    list_faces(symmetry);
    list_vertices(symmetry);
    symmetry.plane = fit_plane(mesh_, symmetry.match.vertices);
  }

  void list_faces(Symmetry& symmetry) const {
    symmetry.faces = mesh_.face_count();
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      const FaceId face(f), partner = map_.image(face);
      if (!partner.valid()) symmetry.unpaired_faces.push_back(face);
      if (partner == face) symmetry.line.faces.push_back(face);
      if (partner.valid() && face < partner) ++symmetry.face_pairs;
    }
  }

  void list_vertices(Symmetry& symmetry) const {
    PerVertex<VertexId> image(mesh_.vertex_count());
    for (const VertexPair& pair : symmetry.match.vertices) image[pair.source] = pair.target;
    PerVertex<std::uint8_t> used(mesh_.vertex_count(), 0);
    for (const VertexId v : mesh_.corners()) used[v] = 1;
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      const VertexId vertex(v), partner = image[vertex];
      symmetry.vertices += used[vertex];
      if (used[vertex] != 0 && !partner.valid()) symmetry.unpaired_vertices.push_back(vertex);
      if (partner == vertex) symmetry.line.vertices.push_back(vertex);
      if (partner.valid() && vertex < partner) ++symmetry.vertex_pairs;
    }
    CentreLine& line = symmetry.line;
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      const HalfedgeId half(h);
      if (!map_.image(half).valid()) continue;
      const auto ends = std::minmax(mesh_.origin(half), mesh_.tip(half));
      if (map_.image(half) == mesh_.twin(half) && half < mesh_.twin(half)) line.edges.emplace_back(ends);
      const bool is_first = !mesh_.twin(half).valid() || half < mesh_.twin(half);
      if (map_.image(half) == half && is_first) line.crossed_edges.emplace_back(ends);
    }
    std::sort(line.edges.begin(), line.edges.end());
    std::sort(line.crossed_edges.begin(), line.crossed_edges.end());
  }

  const Mesh& mesh_;
  const SymmetryOptions& options_;
  const double edge_;
  const PerFan<VertexCode> codes_;
  const Components components_;
  MirrorMap map_;
  std::optional<MirrorSearch> search_;
};

}  // namespace
}  // namespace use

Symmetry find_symmetry(const Mesh& mesh, const SymmetryOptions& options) {
  return use::SymmetryFinder(mesh, options).run();
}

}  // namespace quadmatch
