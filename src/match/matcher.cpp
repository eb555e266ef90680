// Read from top to bottom, this is §4: colour the skeletons, find an anchor, lay the seed, let it grow.

#include <quadmatch/match/matcher.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/match/exact.hpp>

#include "growth.hpp"
#include "match_regions.hpp"
#include "mirror.hpp"

namespace quadmatch {
namespace {

/// What is computed once for a mesh.
struct Analysis {
  const Mesh& mesh;
  PerFan<VertexCode> codes;
  Tracing tracing;

  Analysis(const Mesh& analysed, bool with_skeleton) : mesh(analysed), codes(vertex_codes(analysed)) {
    if (with_skeleton) tracing = trace_skeleton(mesh, codes);
  }
};

/// The anchors to try, best first.
AnchorSearch anchors_for(const Analysis& source, const Analysis& target, const MatchOptions& options) {
  if (!options.anchors.empty()) return {.anchors = options.anchors};
  return find_anchors(source.mesh, source.tracing.skeleton, source.codes, target.mesh, target.tracing.skeleton,
                      target.codes, options.anchor_search);
}

Anchor first_that_fits(const Growth& growth, const std::vector<UserAnchor>& anchors) {
  const auto fits = [&](const UserAnchor& anchor) { return growth.fits(anchor); };
  const auto first = std::find_if(anchors.begin(), anchors.end(), fits);
  return first == anchors.end() ? Anchor() : *first;
}

/// Match with the target as it is laid: the rotation systems agree.
MatchResult match_laid(const Analysis& source, const Analysis& target, const MatchOptions& options,
                       Orientation orientation) {
  MatchResult result;
  result.search = anchors_for(source, target, options);
  Growth growth(source.mesh, source.codes, target.mesh, target.codes);
  result.seed =
      options.anchors.empty() ? choose_seed(growth, result.search.anchors) : first_that_fits(growth, options.anchors);
  if (!result.seed.source.valid()) return result;

  growth.accept(result.seed);
  growth.end_wave();
  GrowthProgress progress;
  if (options.progress) {
    const std::size_t most = std::min(source.mesh.face_count(), target.mesh.face_count());
    progress = [&, most](std::size_t matched) { return options.progress(matched, most); };
  }
  result.match.complete =
      options.algorithm == Algorithm::Greedy ? grow_greedily(growth, progress) : grow_lazily(growth, progress);
  result.match.vertices = growth.vertex_pairs();
  result.match.regions.push_back(growth.region(orientation, options.waves));
  result.match.regions.front().evidence = weigh(result.match.vertices, source.codes, target.codes);
  return result;
}

/// Match with the target turned over: reverse all its faces and nothing else.
MatchResult match_mirrored(const Analysis& source, const Mesh& target, MatchOptions options) {
  const Mesh mirror = target.mirrored();
  const Analysis mirrored(mirror, options.anchors.empty());
  for (UserAnchor& anchor : options.anchors) anchor.target = in_mirror(target, anchor.target);
  MatchResult result = match_laid(source, mirrored, options, Orientation::Reversing);
  if (result.seed.target.valid()) result.seed.target = in_mirror(target, result.seed.target);
  for (Anchor& anchor : result.search.anchors) anchor.target = in_mirror(target, anchor.target);
  return result;
}

/// The first of the user's anchors that is in a match.
Anchor first_matched(const Match& match, const Mesh& source, const Mesh& target,
                     const std::vector<UserAnchor>& anchors) {
  for (const UserAnchor& anchor : anchors) {
    const FaceId q = source.face(anchor.source), r = target.face(anchor.target);
    for (const Region& region : match.regions) {
      const auto lies_so = [&](const FacePair& pair) {
        return pair.source == q && pair.target == r &&
               image_corner(region.orientation, pair.rotation, source.corner(anchor.source), source.size(q)) ==
                   target.corner(anchor.target);
      };
      if (std::any_of(region.faces.begin(), region.faces.end(), lies_so)) return anchor;
    }
  }
  return {};
}

/// `Auto` looks in the mirror when most of both meshes stayed unmatched...
bool leaves_most_unmatched(const Match& match, const Mesh& source, const Mesh& target) {
  return 2 * match.matched_faces() < std::min(source.face_count(), target.face_count());
}

/// ...and believes it only if it is far larger: garbage grows to some size both ways round.
bool is_far_larger(const Match& match, const Match& other) { return match.matched_faces() > 2 * other.matched_faces(); }

MatchResult match_exactly(const Mesh& source, const Mesh& target, const MatchOptions& options) {
  ExactOptions exact{.orientation = options.orientation, .at_least = options.at_least};
  if (options.progress) {
    exact.progress = [&](const ExactProgress& progress) { return options.progress(progress.faces, progress.bound); };
  }
  LargestRegion largest = largest_region(source, target, exact);
  return {.match = std::move(largest.match), .search = {}, .seed = {}, .optimality = largest.optimality};
}

}  // namespace

MatchResult match(const Mesh& source, const Mesh& target, const MatchOptions& options) {
  if (options.algorithm == Algorithm::Regions) {
    MatchResult result{.match = match_regions(source, target, options), .search = {}, .seed = {}, .optimality = {}};
    result.seed = first_matched(result.match, source, target, options.anchors);
    return result;
  }
  if (options.algorithm == Algorithm::Exact) return match_exactly(source, target, options);
  const Analysis left(source, options.anchors.empty());
  if (options.orientation == OrientationChoice::Reversing) return match_mirrored(left, target, options);

  const Analysis right(target, options.anchors.empty());
  MatchResult result = match_laid(left, right, options, Orientation::Preserving);
  if (options.orientation == OrientationChoice::Auto && result.match.complete &&
      leaves_most_unmatched(result.match, source, target)) {
    MatchResult mirrored = match_mirrored(left, target, options);
    if (is_far_larger(mirrored.match, result.match)) return mirrored;
  }
  return result;
}

Expected<void> check_anchor(const Mesh& source, const Mesh& target, const UserAnchor& anchor) {
  const auto refuse = [](std::string message) { return Unexpected(Error{ErrorCode::BadArgument, std::move(message)}); };
  if (anchor.source.value >= source.halfedge_count()) return refuse("the anchor names no face corner of the source");
  if (anchor.target.value >= target.halfedge_count()) return refuse("the anchor names no face corner of the target");
  const FaceId q = source.face(anchor.source);
  const FaceId r = target.face(anchor.target);
  if (source.size(q) != target.size(r)) {
    return refuse(fmt::format("the anchor lays face f{} of {} corners on face f{} of {}; choose faces that fit",
                              q.value, source.size(q), r.value, target.size(r)));
  }
  return {};
}

}  // namespace quadmatch
