#include "match_regions.hpp"

#include <algorithm>
#include <utility>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/components.hpp>

#include "mirror.hpp"
#include "regions/assemble.hpp"
#include "regions/engine.hpp"

namespace quadmatch {
namespace {

/// What the engine needs to know of a mesh.
struct Analysis {
  const Mesh& mesh;
  PerFan<VertexCode> codes;
  ArcGraph separatrices;

  explicit Analysis(const Mesh& analysed)
      : mesh(analysed), codes(vertex_codes(analysed)), separatrices(trace_separatrices(analysed, codes)) {}
  [[nodiscard]] regions::Side side() const { return {mesh, codes, separatrices}; }
};

Match match_laid(const Analysis& source, const Analysis& target, const MatchOptions& options,
                 Orientation orientation) {
  const regions::Sides sides{source.side(), target.side()};
  regions::EngineProgress progress;
  if (options.progress) {
    const std::size_t most = std::min(source.mesh.face_count(), target.mesh.face_count());
    progress = [&options, most](std::size_t matched) { return options.progress(matched, most); };
  }
  regions::Outcome outcome = regions::match_regions(sides, options, options.anchors, progress);
  Match match = regions::assemble(sides, std::move(outcome.pieces), orientation, options.waves);
  match.complete = outcome.complete;
  return match;
}

Match match_mirrored(const Analysis& source, const Mesh& target, MatchOptions options) {
  const Mesh mirror = target.mirrored();
  for (UserAnchor& anchor : options.anchors) anchor.target = in_mirror(target, anchor.target);
  return match_laid(source, Analysis(mirror), options, Orientation::Reversing);
}

/// The faces of one mesh, by component: which components have no face in a match.
PerFace<bool> in_free_components(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  const Components components = connected_components(mesh);
  std::vector<bool> touched(components.face_count.size(), false);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) touched[components.of_face[pair.*side]] = true;
  }
  PerFace<bool> free(mesh.face_count(), false);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) free[FaceId(f)] = !touched[components.of_face[FaceId(f)]];
  return free;
}

bool has_free_component(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  const PerFace<bool> free = in_free_components(mesh, match, side);
  return std::find(free.begin(), free.end(), true) != free.end();
}

/// Is the mirror worth a look: is a quarter left unmatched, or a whole component of each mesh?
bool leaves_much_unmatched(const Match& match, const Mesh& source, const Mesh& target) {
  const std::size_t most = std::min(source.face_count(), target.face_count());
  return 4 * match.matched_faces() < 3 * most || (has_free_component(source, match, &FacePair::source) &&
                                                  has_free_component(target, match, &FacePair::target));
}

/// Take those regions of another match into components that this one left wholly free.
void fill_free_components(Match& match, const Match& other, const Mesh& source, const Mesh& target) {
  const PerFace<bool> source_free = in_free_components(source, match, &FacePair::source);
  const PerFace<bool> target_free = in_free_components(target, match, &FacePair::target);
  for (const Region& region : other.regions) {
    const bool fits = std::all_of(region.faces.begin(), region.faces.end(), [&](const FacePair& pair) {
      return source_free[pair.source] && target_free[pair.target];
    });
    if (fits) match.regions.push_back(region);
  }
}

/// Leave out what the user thinks too small or too doubtful, and say which vertices lie on which.
Match finished(Match match, const Mesh& source, const Mesh& target, const MatchOptions& options) {
  std::erase_if(match.regions, [&](const Region& region) {
    return region.faces.size() < options.least_region || region.evidence.confidence() < options.least_confidence;
  });
  std::stable_sort(match.regions.begin(), match.regions.end(),
                   [](const Region& a, const Region& b) { return a.faces.size() > b.faces.size(); });
  match.vertices = regions::combined_vertices(source, target, match.regions);
  return match;
}

}  // namespace

Match match_regions(const Mesh& source, const Mesh& target, const MatchOptions& options) {
  const Analysis left(source);
  if (options.orientation == OrientationChoice::Reversing) {
    return finished(match_mirrored(left, target, options), source, target, options);
  }
  Match match = match_laid(left, Analysis(target), options, Orientation::Preserving);
  if (options.orientation == OrientationChoice::Auto && match.complete &&
      leaves_much_unmatched(match, source, target)) {
    Match mirrored = match_mirrored(left, target, options);
    if (mirrored.matched_faces() > match.matched_faces()) std::swap(match, mirrored);
    fill_free_components(match, mirrored, source, target);
    match.complete = match.complete && mirrored.complete;
  }
  return finished(std::move(match), source, target, options);
}

}  // namespace quadmatch
