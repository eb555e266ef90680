// Read from top to bottom: the match of a mesh with its mirror image, made one mirror that is its own inverse; where
// that has a choice, all mirrors of the component and the best of them; then the line, and what is left.

#include <quadmatch/use/symmetry.hpp>

#include <algorithm>
#include <utility>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/components.hpp>

#include "image_match.hpp"
#include "left_over.hpp"
#include "mirror_map.hpp"
#include "mirror_plane.hpp"
#include "mirror_regions.hpp"
#include "mirror_search.hpp"
#include "one_sided.hpp"

namespace quadmatch {
namespace use {
namespace {

/// Of the faces a match pairs in a component, how many must lie on each other both ways for it to be one mirror.
constexpr double kOneMirror = 0.9;
/// Of the faces a mirror lays, how many must lie so in the match for the two to be one.
constexpr double kSameMirror = 0.98;
/// How much farther than the largest region of the match another mirror must reach to be believed instead.
constexpr double kFarther = 1.05;
/// Places on the line of which growth is tried.
constexpr std::size_t kMostGerms = 5;
/// Rows of faces about an edit whose corners look different though they are opposite each other.
constexpr int kRimLayers = 2;
/// What a match with the mirror image says of one component.
struct Tally {
  std::uint32_t faces = 0;
  std::uint32_t matched = 0;
  std::uint32_t onto_itself = 0;  ///< matched with a face of the component
  std::uint32_t mutual = 0;       ///< and that one with it, in the same place
  std::uint32_t taken = 0;        ///< partners of any face
  std::uint32_t largest = 0;      ///< faces of its largest region
  std::uint32_t ways = 1;         ///< of that one
  bool has_line = false;
  std::vector<Germ> germs = {};  ///< some on the line

  /// Does it lie opposite itself, but not all of it?
  [[nodiscard]] bool is_edited() const { return 2 * onto_itself >= matched && matched < faces && has_line; }
  /// Might the match have taken a bit of this mirror and a bit of that one?
  [[nodiscard]] bool is_patchwork() const { return largest < kOneMirror * faces; }
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
        settled_(components_.face_count.size(), false),
        is_overruled_(mesh.face_count(), 0),
        map_(mesh, codes_) {}

  Symmetry run() {
    Symmetry symmetry;
    const Match match =
        match_with_image(mesh_, mesh_, edge_ > 0 ? likely_plane(mesh_, edge_) : MirrorPlane(), image_options());
    symmetry.complete = match.complete;
    const PerHalfedge<HalfedgeId> images = images_of(mesh_, mesh_, match.regions);
    const std::vector<Tally> tallies = tallied(match, images);
    const std::uint32_t largest = largest_component();
    for (std::uint32_t c = 0; c < tallies.size() && symmetry.complete; ++c) {
      if (tallies[c].is_in_doubt()) {
        settle(c, c == largest, symmetry, tallies[c], images);
      } else if (tallies[c].is_edited() &&
                 !(tallies[c].is_patchwork() && settle(c, c == largest, symmetry, tallies[c], images))) {
        overrule(tallies[c], images);
      }
    }
    lay_believed(match, images);
    if (symmetry.complete) LeftOver(mesh_, codes_, components_, settled_, image_options(), map_).lay();
    drop_one_sided();
    if (symmetry.mirrors == 0 && !components_.face_count.empty()) {
      symmetry.mirrors = laid_in(largest) > 0 ? 1 : 0;
      symmetry.maybe_more = laid_in(largest) < components_.face_count[largest];
    }
    finish(symmetry);
    return symmetry;
  }

 private:
  [[nodiscard]] ImageOptions image_options() const { return {edge_ > 0, options_.progress}; }

  [[nodiscard]] std::uint32_t largest_component() const {
    const auto& counts = components_.face_count;
    return static_cast<std::uint32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  }

  [[nodiscard]] std::vector<Tally> tallied(const Match& match, const PerHalfedge<HalfedgeId>& images) const {
    std::vector<Tally> tallies(components_.face_count.size());
    for (std::size_t c = 0; c < tallies.size(); ++c) tallies[c].faces = components_.face_count[c];
    for (const Region& region : match.regions) {
      Tally& of_region = tallies[components_.of_face[region.faces.front().source]];
      if (region.faces.size() > of_region.largest) {
        of_region.largest = static_cast<std::uint32_t>(region.faces.size());
        of_region.ways = region.ways;
      }
      for (const FacePair& pair : region.faces) {
        Tally& tally = tallies[components_.of_face[pair.source]];
        const HalfedgeId first = mesh_.first(pair.source);
        const bool mutual = images[images[first]] == first;
        ++tally.matched;
        ++tallies[components_.of_face[pair.target]].taken;
        tally.onto_itself += components_.of_face[pair.target] == components_.of_face[pair.source];
        tally.mutual += mutual;
        if (mutual && tally.germs.size() < kMostGerms) look_for_line(pair, images, tally);
      }
    }
    return tallies;
  }

  void look_for_line(const FacePair& pair, const PerHalfedge<HalfedgeId>& images, Tally& tally) const {
    for (const HalfedgeId h : mesh_.halfedges(pair.source)) {
      const bool is_along = mesh_.twin(h).valid() && images[h] == mesh_.twin(h);
      if (!is_along && pair.source != pair.target) continue;
      tally.has_line = true;
      tally.germs.push_back({h, images[h]});
      return;
    }
  }

  /// Look through all mirrors of a component, and lay the best.
  /// @return  false where what was matched already goes as far, or goes the same way
  bool settle(std::uint32_t component, bool is_largest, Symmetry& symmetry, const Tally& matched,
              const PerHalfedge<HalfedgeId>& images) {
    if (!search_) search_.emplace(mesh_, codes_, components_, edge_);
    const MirrorsOfComponent found = search_->mirrors_of(component);
    if (found.mirrors.empty()) return false;
    const Mirror& best = found.mirrors.front();
    if (!matched.is_in_doubt() && (best.faces < kFarther * matched.largest || agrees(best, images))) return false;
    if (is_largest) {
      for (const Mirror& mirror : found.mirrors) symmetry.mirrors += mirror.line_length > 0 ? 1 : 0;
      symmetry.mirrors = std::max(symmetry.mirrors, 1U);
      symmetry.maybe_more = found.maybe_more;
    }
    map_.lay(best.germ, Fit::Looks);
    map_.grow(Fit::Looks);
    settled_[component] = true;
    return true;
  }

  /// Does the match lay both ways what grows by this mirror? Then they are one, and the match knows better what was
  /// lifted.
  [[nodiscard]] bool agrees(const Mirror& mirror, const PerHalfedge<HalfedgeId>& images) const {
    MirrorMap grown(mesh_, codes_);
    grown.lay(mirror.germ, Fit::Looks);
    grown.grow(Fit::Looks);
    std::uint32_t same = 0;
    for (const Germ& germ : grown.laid()) {
      if (images[germ.from] != germ.to || images[germ.to] != germ.from) continue;
      same += mesh_.face(germ.from) == mesh_.face(germ.to) ? 1 : 2;
    }
    return same >= kSameMirror * grown.faces();
  }

  /// A component with one mirror that was edited. What grows from its line, and sees that extraordinary vertices agree,
  /// is believed before the match: a thumb is nearly its own mirror image, and in a pose its lengths may fit that
  /// better.
  void overrule(const Tally& tally, const PerHalfedge<HalfedgeId>& images) {
    MirrorMap grown(mesh_, codes_);
    Germ best;
    std::uint32_t most = 0;
    for (const Germ& germ : tally.germs) {
      grown.clear();
      if (!grown.lay(germ, Fit::Looks)) continue;
      grown.grow(Fit::Looks);
      if (grown.faces() <= most) continue;
      most = grown.faces();
      best = germ;
      if (most >= kOneMirror * tally.faces) break;
    }
    if (most == 0) return;
    if (grown.faces() != most) {
      grown.clear();
      grown.lay(best, Fit::Looks);
      grown.grow(Fit::Looks);
    }
    const auto differs = [&](FaceId f) {
      const HalfedgeId first = mesh_.first(f);
      return grown.image(first).valid() && images[first].valid() && grown.image(first) != images[first];
    };
    PerFace<std::uint8_t> seen(mesh_.face_count(), 0);
    for (const Germ& germ : grown.laid()) {
      for (const FaceId seed : {mesh_.face(germ.from), mesh_.face(germ.to)}) {
        if (seen[seed] != 0 || !differs(seed)) continue;
        std::vector<FaceId> area{seed};
        seen[seed] = 1;
        for (std::size_t here = 0; here < area.size(); ++here) {
          for (const HalfedgeId h : mesh_.halfedges(area[here])) {
            const HalfedgeId beside = mesh_.twin(h);
            if (!beside.valid() || seen[mesh_.face(beside)] != 0 || !differs(mesh_.face(beside))) continue;
            seen[mesh_.face(beside)] = 1;
            area.push_back(mesh_.face(beside));
          }
        }
        if (speaks_for(grown, images, area)) overruled_.insert(overruled_.end(), area.begin(), area.end());
      }
    }
    for (const FaceId face : overruled_) is_overruled_[face] = 1;
    for (const Germ& germ : grown.laid()) {
      if (is_overruled_[mesh_.face(germ.from)] != 0 && is_overruled_[mesh_.face(germ.to)] != 0)
        map_.lay(germ, Fit::Free);
    }
    others_.insert(others_.end(), grown.laid().begin(), grown.laid().end());
  }

  /// Do more corners of an area agree at extraordinary vertices by what was grown, or as many, than by the match?
  [[nodiscard]] bool speaks_for(const MirrorMap& grown, const PerHalfedge<HalfedgeId>& images,
                                const std::vector<FaceId>& area) const {
    std::uint32_t by_growth = 0, by_match = 0;
    for (const FaceId face : area) {
      for (const HalfedgeId h : mesh_.halfedges(face)) {
        const VertexCode code = codes_[mesh_.fan(h)];
        if (!code.extraordinary()) continue;
        by_growth += codes_[mesh_.fan(mesh_.next(grown.image(h)))] == code;
        by_match += codes_[mesh_.fan(mesh_.next(images[h]))] == code;
      }
    }
    return by_growth > 0 && by_growth >= by_match;
  }

  [[nodiscard]] bool is_believed(const FacePair& pair) const {
    return !settled_[components_.of_face[pair.source]] && is_overruled_[pair.source] == 0 &&
           is_overruled_[pair.target] == 0;
  }

  /// What lies on each other both ways is certain; where the match says two things of a face, the larger region is
  /// believed.
  void lay_believed(const Match& match, const PerHalfedge<HalfedgeId>& images) {
    for (const bool both_ways : {true, false}) {
      for (const Region& region : match.regions) {
        for (const FacePair& pair : region.faces) {
          const HalfedgeId first = mesh_.first(pair.source);
          if (!is_believed(pair) || (both_ways && images[images[first]] != first)) continue;
          map_.lay({first, images[first]}, both_ways ? Fit::Free : Fit::Vertices);
        }
      }
      drop_one_sided();
      for (const Germ& germ : others_) map_.lay(germ, Fit::Vertices);
    }
    map_.grow(Fit::Looks);
    for (int layer = 0; layer < kRimLayers; ++layer) map_.cover_rim();
  }

  /// Give up what lies on its own side.
  void drop_one_sided() {
    const std::vector<Region> regions = regions_of(mesh_, codes_, map_, [](FaceId) { return true; });
    const std::vector<bool> drops = one_sided(sides_of(mesh_, components_, regions), regions);
    if (std::find(drops.begin(), drops.end(), true) == drops.end()) return;
    PerFace<std::uint8_t> is_dropped(mesh_.face_count(), 0);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      for (const FacePair& pair : regions[r].faces) {
        if (drops[r]) is_dropped[pair.source] = is_dropped[pair.target] = 1;
      }
    }
    const std::vector<Germ> laid = map_.laid();
    map_.clear();
    for (const Germ& germ : laid) {
      if (is_dropped[mesh_.face(germ.from)] == 0) map_.lay(germ, Fit::Free);
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
      const VertexId from = mesh_.origin(half), to = mesh_.tip(half);
      const std::pair<VertexId, VertexId> ends(std::min(from, to), std::max(from, to));
      if (map_.image(half) == mesh_.twin(half) && half < mesh_.twin(half)) line.edges.push_back(ends);
      const bool is_first = !mesh_.twin(half).valid() || half < mesh_.twin(half);
      if (map_.image(half) == half && is_first) line.crossed_edges.push_back(ends);
    }
    std::sort(line.edges.begin(), line.edges.end());
    std::sort(line.crossed_edges.begin(), line.crossed_edges.end());
  }

  const Mesh& mesh_;
  const SymmetryOptions& options_;
  const double edge_;
  const PerFan<VertexCode> codes_;
  const Components components_;
  std::vector<bool> settled_;           // components of which all mirrors were looked through
  PerFace<std::uint8_t> is_overruled_;  // what the match says of them is not believed
  std::vector<FaceId> overruled_;
  std::vector<Germ> others_;  // grown from lines, to be laid where there is room
  MirrorMap map_;
  std::optional<MirrorSearch> search_;
};

}  // namespace
}  // namespace use

Symmetry find_symmetry(const Mesh& mesh, const SymmetryOptions& options) {
  return use::SymmetryFinder(mesh, options).run();
}

}  // namespace quadmatch
