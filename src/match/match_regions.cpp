#include "match_regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/vertex_code.hpp>

#include "mirror.hpp"
#include "regions/assemble.hpp"
#include "regions/engine.hpp"
#include "regions/nth_smallest.hpp"

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

Match match_laid(const Analysis& source, const Analysis& target, const MatchOptions& options, Orientation orientation) {
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

/// The faces of those components of a mesh that have no face in a match.
std::vector<FaceId> in_free_components(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  PerFace<bool> seen(mesh.face_count(), false), matched(mesh.face_count(), false);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) seen[pair.*side] = matched[pair.*side] = true;
  }
  std::vector<FaceId> faces;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (seen[FaceId(f)]) continue;
    // Flood what is free from here on: a component of its own, unless it meets what is matched.
    bool meets_match = false;
    const std::size_t first = faces.size();
    faces.push_back(FaceId(f));
    seen[FaceId(f)] = true;
    for (std::size_t here = first; here < faces.size(); ++here) {
      for (const HalfedgeId h : mesh.halfedges(faces[here])) {
        const HalfedgeId beside = mesh.twin(h);
        if (!beside.valid()) continue;
        const FaceId other = mesh.face(beside);
        meets_match = meets_match || matched[other];
        if (seen[other]) continue;
        seen[other] = true;
        faces.push_back(other);
      }
    }
    if (meets_match) faces.resize(first);
  }
  return faces;
}

bool has_free_component(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  return !in_free_components(mesh, match, side).empty();
}

/// Is the mirror worth a look: is a quarter left unmatched, or a whole component of each mesh, or anything at all where
/// the meshes have so much in common that one may be the mirror image of the other?
bool leaves_much_unmatched(const Match& match, const Mesh& source, const Mesh& target) {
  const std::size_t most = std::min(source.face_count(), target.face_count());
  if (match.matched_faces() == most) return false;
  if (source.face_count() == target.face_count() && match.matched_faces() < most) return true;
  return 4 * match.matched_faces() < 3 * most ||
         (has_free_component(source, match, &FacePair::source) && has_free_component(target, match, &FacePair::target));
}

/// How far matched quads differ in shape: in the middle of a sample, as logarithms; 0 where positions are not to be
/// looked at.
struct Misshape {
  /// Ratios of opposite edges. Posing and sculpting change lengths at will, but those of opposite edges alike.
  double tapers = 0;
  /// Lengths of edges, but for the scale of the models.
  double lengths = 0;

  /// A shoe lies on its mirror image either way round as connectivity goes, but only one way as its shape goes.
  [[nodiscard]] bool clearly_below(const Misshape& other) const {
    if (tapers < 0.8 * other.tapers - 0.002) return true;
    return lengths < 0.5 * other.lengths - 0.01 && !(other.tapers < 0.8 * tapers - 0.002);
  }
  /// These may be the shapes of a mirror image; or of a posed model, so both are tried.
  [[nodiscard]] bool is_doubtful() const { return tapers > 0.01 || lengths > 0.03; }
};

/// The middle one, 0 if there are none. Reorders them.
double median(std::vector<double>& numbers) {
  return numbers.empty() ? 0 : regions::nth_smallest(numbers, numbers.size() / 2);
}

Misshape misshape(const Mesh& source, const Mesh& target, const Match& match, const MatchOptions& options) {
  constexpr std::size_t kSamples = 500;
  if (!options.positions || source.positions().empty() || target.positions().empty()) return {};
  const auto log_length = [](const Mesh& mesh, FaceId face, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t first = mesh.first(face).value;
    const Point& a = mesh.positions()[mesh.corners()[first + from].value];
    const Point& b = mesh.positions()[mesh.corners()[first + to].value];
    return std::log(std::max(1e-30, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])));
  };
  std::vector<double> tapers, stretches;
  const std::size_t step = match.matched_faces() / kSamples + 1;
  std::size_t count = 0;
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) {
      if (count++ % step != 0) continue;
      const std::uint32_t size = source.size(pair.source);
      const std::size_t first = stretches.size();
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const auto image = [&](std::uint32_t c) { return image_corner(region.orientation, pair.rotation, c, size); };
        const std::uint32_t next = (corner + 1) % size;
        stretches.push_back(log_length(target, pair.target, image(corner), image(next)) -
                            log_length(source, pair.source, corner, next));
      }
      if (size != 4) continue;
      for (std::size_t k = first; k < first + 2; ++k) tapers.push_back(std::abs(stretches[k] - stretches[k + 2]));
    }
  }
  const double scale = median(stretches);
  for (double& stretch : stretches) stretch = std::abs(stretch - scale);
  return {median(tapers), median(stretches)};
}

/// Does the one mesh lie on the other whole, with every corner agreeing?
bool is_whole(const Match& match, const Mesh& source, const Mesh& target) {
  return match.matched_faces() == std::max(source.face_count(), target.face_count()) &&
         std::all_of(match.regions.begin(), match.regions.end(), [](const Region& region) {
           return region.evidence.agreeing == region.evidence.source_extraordinary &&
                  region.evidence.agreeing == region.evidence.target_extraordinary;
         });
}

/// Is the match of the mirror image the better one? The shapes say so, or it is whole and the other is not, or it is
/// clearly larger. A model whose left is its right has two maps that differ by a few faces at most, and of these the
/// one that keeps the orientation is meant.
bool mirror_is_better(const Match& mirrored, const Misshape& mirrored_off, const Match& match, const Misshape& off,
                      const Mesh& source, const Mesh& target) {
  const auto faces = static_cast<double>(match.matched_faces());
  const auto mirrored_faces = static_cast<double>(mirrored.matched_faces());
  if (mirrored_faces > 0.9 * faces && mirrored_off.clearly_below(off)) return true;
  if (faces > 0.9 * mirrored_faces && off.clearly_below(mirrored_off)) return false;
  if (is_whole(mirrored, source, target)) return !is_whole(match, source, target);
  return mirrored_faces > 1.25 * faces;
}

/// Take those regions of another match into components that this one left wholly free.
void fill_free_components(Match& match, const Match& other, const Mesh& source, const Mesh& target) {
  const auto is_in_free = [&](const Mesh& mesh, FaceId FacePair::*side) {
    PerFace<bool> is_in(mesh.face_count(), false);
    for (const FaceId face : in_free_components(mesh, match, side)) is_in[face] = true;
    return is_in;
  };
  const PerFace<bool> source_free = is_in_free(source, &FacePair::source);
  const PerFace<bool> target_free = is_in_free(target, &FacePair::target);
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
  if (options.orientation == OrientationChoice::Auto && match.complete) {
    const Misshape off = misshape(source, target, match, options);
    if (off.is_doubtful() || leaves_much_unmatched(match, source, target)) {
      Match mirrored = match_mirrored(left, target, options);
      const Misshape mirrored_off = misshape(source, target, mirrored, options);
      if (mirror_is_better(mirrored, mirrored_off, match, off, source, target)) std::swap(match, mirrored);
      fill_free_components(match, mirrored, source, target);
      match.complete = match.complete && mirrored.complete;
    }
  }
  return finished(std::move(match), source, target, options);
}

}  // namespace quadmatch
