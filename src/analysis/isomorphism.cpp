// An isomorphism from two canonical forms: where they are equal, the n-th face of one lies on the n-th of the other.

#include <quadmatch/analysis/isomorphism.hpp>

#include <algorithm>
#include <compare>
#include <limits>
#include <utility>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/components.hpp>

#include "canonical/canonical_form.hpp"
#include "differences.hpp"

namespace quadmatch {
namespace {

using canonical::CanonicalForm;

/// The half-edge that leaves the same corner in the mirror, and back again (Mesh::mirrored).
HalfedgeId in_mirror(const Mesh& mesh, HalfedgeId h) {
  const FaceId f = mesh.face(h);
  return HalfedgeId(mesh.first(f).value + mesh.size(f) - 1 - mesh.corner(h));
}

/// @param target_half  in the target itself, also where the orientation is reversed.
FacePair pair_of(const Mesh& source, const Mesh& target, HalfedgeId source_half, HalfedgeId target_half,
                 Orientation orientation) {
  const FaceId face = source.face(source_half);
  const std::uint32_t size = source.size(face);
  const std::uint32_t corner = source.corner(source_half), other = target.corner(target_half);
  const std::uint32_t rotation = orientation == Orientation::Preserving ? other + size - corner : other + corner;
  return {face, target.face(target_half), rotation % size};
}

/// How many places the faces of each cluster can take: its symmetries, times the clusters like it.
std::vector<std::uint32_t> ways_of_clusters(const CanonicalForm& form) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> ways;
  for (std::size_t first = 0, last = 0; first < form.clusters.size(); first = last) {
    const CanonicalForm::Cluster& cluster = form.clusters[first];
    while (last < form.clusters.size() && std::is_eq(compare(form, cluster, form, form.clusters[last]))) ++last;
    GroupOrder order = cluster.symmetries;
    order.multiply(last - first);
    ways.insert(ways.end(), last - first, static_cast<std::uint32_t>(std::min(order.value().value_or(kMost), kMost)));
  }
  return ways;
}

/// Makes the match from two equal forms.
class MatchMaker {
 public:
  MatchMaker(const Mesh& source, const Mesh& target, Orientation orientation)
      : source_(source),
        target_(target),
        orientation_(orientation),
        codes_(vertex_codes(source)),
        components_(connected_components(source)),
        image_(source.vertex_count()),
        region_at_(source.vertex_count(), Region::kNone) {}

  Match make(const CanonicalForm& left, const CanonicalForm& right) {
    const std::vector<std::uint32_t> ways = ways_of_clusters(left);
    for (std::size_t k = 0; k < left.clusters.size(); ++k) {
      lay(left.faces_of(left.clusters[k]), right.faces_of(right.clusters[k]), ways[k]);
    }
    return finish();
  }

 private:
  /// A region, and the component of the source it covers.
  struct Region {
    static constexpr std::uint32_t kNone = 0xffffffff;
    quadmatch::Region region;
    std::uint32_t component;
  };

  /// Faces come component by component.
  void lay(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images, std::uint32_t ways) {
    std::uint32_t component = Region::kNone;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const HalfedgeId image = orientation_ == Orientation::Preserving ? images[i] : in_mirror(target_, images[i]);
      const FacePair pair = pair_of(source_, target_, faces[i], image, orientation_);
      if (components_.of_face[pair.source] != component) {
        component = components_.of_face[pair.source];
        regions_.push_back({{.orientation = orientation_, .ways = ways, .ambiguous = ways > 1}, component});
      }
      regions_.back().region.faces.push_back(pair);
      map_corners(pair);
    }
  }

  void map_corners(const FacePair& pair) {
    const std::uint32_t size = source_.size(pair.source);
    const auto region = static_cast<std::uint32_t>(regions_.size() - 1);
    Evidence& evidence = regions_.back().region.evidence;
    for (std::uint32_t corner = 0; corner < size; ++corner) {
      const VertexId v = source_.origin(HalfedgeId(source_.first(pair.source).value + corner));
      const std::uint32_t other = image_corner(orientation_, pair.rotation, corner, size);
      image_[v] = target_.origin(HalfedgeId(target_.first(pair.target).value + other));
      if (region_at_[v] == region) continue;
      region_at_[v] = region;
      if (!codes_[FanId(v.value)].extraordinary()) continue;
      ++evidence.agreeing;  // the whole of both meshes agrees
      ++evidence.source_extraordinary;
      ++evidence.target_extraordinary;
    }
  }

  Match finish() {
    std::sort(regions_.begin(), regions_.end(), [](const Region& a, const Region& b) {
      return a.region.faces.size() != b.region.faces.size() ? a.region.faces.size() > b.region.faces.size()
                                                            : a.component < b.component;
    });
    Match match;
    for (Region& region : regions_) match.regions.push_back(std::move(region.region));
    for (std::uint32_t v = 0; v < source_.vertex_count(); ++v) {
      if (image_[VertexId(v)].valid()) match.vertices.push_back({VertexId(v), image_[VertexId(v)]});
    }
    return match;
  }

  const Mesh& source_;
  const Mesh& target_;
  const Orientation orientation_;
  PerFan<VertexCode> codes_;
  Components components_;
  std::vector<Region> regions_;
  PerVertex<VertexId> image_;
  PerVertex<std::uint32_t> region_at_;  // the last that touched a vertex
};

}  // namespace

IsomorphismResult find_isomorphism(const Mesh& source, const Mesh& target, IsomorphismKind kind) {
  IsomorphismResult result;
  result.differences = different_counts(source, target);
  if (!result.differences.empty()) return result;

  const CanonicalForm left = canonical::canonical_form(source);
  for (const Orientation orientation : {Orientation::Preserving, Orientation::Reversing}) {
    const bool preserving = orientation == Orientation::Preserving;
    if (kind == (preserving ? IsomorphismKind::Reversing : IsomorphismKind::Preserving)) continue;
    const CanonicalForm right = canonical::canonical_form(preserving ? target : target.mirrored());
    if (is_same(left, right)) {
      Match match = MatchMaker(source, target, orientation).make(left, right);
      result.differences.clear();
      result.isomorphism = Isomorphism{std::move(match), orientation, symmetries_of(left)};
      return result;
    }
    // What is different is told of the first way round that was tried.
    if (result.differences.empty()) result.differences = different_parts(source, left, target, right);
  }
  return result;
}

Automorphisms count_automorphisms(const Mesh& mesh) {
  const CanonicalForm form = canonical::canonical_form(mesh);
  Automorphisms automorphisms{symmetries_of(form), false, {}};
  automorphisms.has_reversing = mesh.face_count() > 0 && is_same(form, canonical::canonical_form(mesh.mirrored()));
  automorphisms.all = automorphisms.preserving;
  if (automorphisms.has_reversing) automorphisms.all.multiply(2);
  return automorphisms;
}

}  // namespace quadmatch
