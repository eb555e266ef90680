// Connected areas of faces without a partner.

#include <algorithm>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/report/report.hpp>

namespace quadmatch {
namespace {

/// The area of free faces around `start`, ascending; takes them all.
std::vector<FaceId> take_area(const Mesh& mesh, FaceId start, PerFace<std::uint8_t>& taken) {
  std::vector<FaceId> area(1, start);
  taken[start] = 1;
  for (std::size_t next = 0; next < area.size(); ++next) {
    for (const HalfedgeId h : mesh.halfedges(area[next])) {
      const HalfedgeId other = mesh.twin(h);
      if (!other.valid() || taken[mesh.face(other)] != 0) continue;
      taken[mesh.face(other)] = 1;
      area.push_back(mesh.face(other));
    }
  }
  std::sort(area.begin(), area.end());
  return area;
}

/// From the largest, ties by lowest face.
std::vector<std::vector<FaceId>> areas_of(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  PerFace<std::uint8_t> taken(mesh.face_count(), 0);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) taken[pair.*side] = 1;
  }
  std::vector<std::vector<FaceId>> areas;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (taken[FaceId(f)] == 0) areas.push_back(take_area(mesh, FaceId(f), taken));
  }
  std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return areas;
}

std::string sentence_of(const std::vector<FaceId>& area) {
  if (area.size() == 1) return fmt::format("{} has no partner", to_string(area.front()));
  return fmt::format("{} faces around {} have no partner", area.size(), to_string(area.front()));
}

}  // namespace

std::vector<ReportChange> unmatched_areas(const Mesh& source, const Mesh& target, const Match& match) {
  std::vector<ReportChange> changes;
  for (std::vector<FaceId>& area : areas_of(source, match, &FacePair::source)) {
    std::string sentence = sentence_of(area);
    changes.push_back({"only in source", std::move(area), {}, std::move(sentence)});
  }
  for (std::vector<FaceId>& area : areas_of(target, match, &FacePair::target)) {
    std::string sentence = sentence_of(area);
    changes.push_back({"only in target", {}, std::move(area), std::move(sentence)});
  }
  return changes;
}

}  // namespace quadmatch
