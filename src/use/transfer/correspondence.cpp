#include "correspondence.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "certain_rows.hpp"
#include "in_place.hpp"

namespace quadmatch::use {
namespace {

/// Which pairs are carried, and which are not and why.
class Choice {
 public:
  Choice(const Mesh& source, const Mesh& target, const Match& match, const TransferOptions& options,
         TransferReport& report)
      : options_(options), report_(report), match_(match), certain_(source.face_count(), 0) {
    const auto is_doubtful = [](const Region& region) { return region.ambiguous; };
    if (options.allow_ambiguous || std::none_of(match.regions.begin(), match.regions.end(), is_doubtful)) return;
    look_for_certain(source, target);
    mark_certain_rows(source, match, certain_);
  }

  /// The pairs of a region that are carried; the others are entered in the report.
  std::vector<FacePair> carried(std::size_t r) {
    const Region& region = match_.regions[r];
    if (region.evidence.confidence() < options_.least_confidence) {
      leave_out(LeftOutRegion::Reason::LowConfidence, region, r, region.faces);
      return {};
    }
    if (!region.ambiguous || options_.allow_ambiguous) return region.faces;
    const auto is_certain = [&](const FacePair& pair) { return certain_[pair.source] != 0; };
    std::vector<FacePair> faces = region.faces;
    const auto doubtful = std::stable_partition(faces.begin(), faces.end(), is_certain);
    leave_out(LeftOutRegion::Reason::Ambiguous, region, r, {doubtful, faces.end()});
    faces.erase(doubtful, faces.end());
    return faces;
  }

 private:
  /// Faces of regions that are not ambiguous; and a match can leave a choice that positions do not: it was made without
  /// them, or does not ask them for single rows.
  void look_for_certain(const Mesh& source, const Mesh& target) {
    std::optional<InPlace> in_place;
    if (options_.positions) in_place.emplace(source, target);
    for (const Region& region : match_.regions) {
      const bool is_believed = region.evidence.confidence() >= options_.least_confidence;
      for (const FacePair& pair : region.faces) {
        if (region.ambiguous ? in_place && in_place->holds(pair, region.orientation) : is_believed)
          certain_[pair.source] = 1;
      }
    }
  }

  void leave_out(LeftOutRegion::Reason reason, const Region& region, std::size_t r,
                 const std::vector<FacePair>& faces) {
    if (faces.empty()) return;
    report_.left_out.push_back({reason, r, static_cast<std::uint32_t>(faces.size()), faces.front().source,
                                faces.front().target, region.ways, region.evidence.confidence()});
  }

  const TransferOptions& options_;
  TransferReport& report_;
  const Match& match_;
  PerFace<std::uint8_t> certain_;  // of the source; looked for when something is in doubt
};

/// Pairs of one region, which comes after others.
void lay(const Mesh& source, const Mesh& target, const std::vector<FacePair>& faces, Orientation orientation,
         const PerVertex<VertexId>& image_of, Correspondence& from) {
  for (const FacePair& pair : faces) {
    from.faces[pair.target] = pair.source;
    const std::uint32_t size = source.size(pair.source);
    for (std::uint32_t i = 0; i < size; ++i) {
      const HalfedgeId there(source.first(pair.source).value + i);
      const HalfedgeId here(target.first(pair.target).value + image_corner(orientation, pair.rotation, i, size));
      from.corners[here] = there;
      const VertexId vertex = source.origin(there);
      const VertexId image = target.origin(here);
      if (image_of[vertex] == image) {
        from.vertices[image] = from.partners[image] = vertex;
      } else if (!from.vertices[image].valid()) {
        from.vertices[image] = vertex;
      }
    }
  }
}

void count(const Mesh& target, const Correspondence& from, TransferReport& report) {
  PerVertex<std::uint8_t> used(target.vertex_count(), 0);
  for (const VertexId v : target.corners()) used[v] = 1;
  report.faces = target.face_count();
  for (std::uint32_t v = 0; v < target.vertex_count(); ++v) {
    report.vertices += used[VertexId(v)];
    report.matched_vertices += from.vertices[VertexId(v)].valid() ? 1 : 0;
  }
  for (const FaceId f : from.faces) report.matched_faces += f.valid() ? 1 : 0;
}

}  // namespace

Correspondence correspond(const Mesh& source, const Mesh& target, const Match& match, const TransferOptions& options,
                          TransferReport& report) {
  Correspondence from{PerFace<FaceId>(target.face_count()), PerHalfedge<HalfedgeId>(target.halfedge_count()),
                      PerVertex<VertexId>(target.vertex_count()), PerVertex<VertexId>(target.vertex_count())};
  PerVertex<VertexId> image_of(source.vertex_count());
  for (const VertexPair& pair : match.vertices) image_of[pair.source] = pair.target;
  Choice choice(source, target, match, options, report);
  for (std::size_t r = 0; r < match.regions.size(); ++r) {
    const Orientation orientation = match.regions[r].orientation;
    const std::vector<FacePair> faces = choice.carried(r);
    lay(source, target, faces, orientation, image_of, from);
    report.reversing = report.reversing || (orientation == Orientation::Reversing && !faces.empty());
  }
  count(target, from, report);
  return from;
}

}  // namespace quadmatch::use
