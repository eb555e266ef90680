// Connected areas of faces without a partner.

#include <algorithm>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/report/report.hpp>

namespace quadmatch {
namespace {

/// The area of wanted faces around `start`, ascending; takes them all.
std::vector<FaceId> take_area(const Mesh& mesh, FaceId start, PerFace<std::uint8_t>& wanted) {
  std::vector<FaceId> area(1, start);
  wanted[start] = 0;
  for (std::size_t next = 0; next < area.size(); ++next) {
    for (const HalfedgeId h : mesh.halfedges(area[next])) {
      const HalfedgeId other = mesh.twin(h);
      if (!other.valid() || wanted[mesh.face(other)] == 0) continue;
      wanted[mesh.face(other)] = 0;
      area.push_back(mesh.face(other));
    }
  }
  std::sort(area.begin(), area.end());
  return area;
}

std::vector<FaceId> without_partner(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  PerFace<std::uint8_t> matched(mesh.face_count(), 0);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) matched[pair.*side] = 1;
  }
  std::vector<FaceId> faces;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (matched[FaceId(f)] == 0) faces.emplace_back(f);
  }
  return faces;
}

std::string sentence_of(const std::vector<FaceId>& area) {
  if (area.size() == 1) return fmt::format("{} has no partner", to_string(area.front()));
  return fmt::format("{} faces around {} have no partner", area.size(), to_string(area.front()));
}

}  // namespace

std::vector<std::vector<FaceId>> connected_areas(const Mesh& mesh, std::span<const FaceId> faces) {
  PerFace<std::uint8_t> wanted(mesh.face_count(), 0);
  for (const FaceId face : faces) wanted[face] = 1;
  std::vector<std::vector<FaceId>> areas;
  for (const FaceId face : faces) {
    if (wanted[face] != 0) areas.push_back(take_area(mesh, face, wanted));
  }
  std::sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return areas;
}

std::vector<ReportChange> unmatched_areas(const Mesh& source, const Mesh& target, const Match& match) {
  std::vector<ReportChange> changes;
  for (std::vector<FaceId>& area : connected_areas(source, without_partner(source, match, &FacePair::source))) {
    std::string sentence = sentence_of(area);
    changes.push_back({"only in source", std::move(area), {}, std::move(sentence)});
  }
  for (std::vector<FaceId>& area : connected_areas(target, without_partner(target, match, &FacePair::target))) {
    std::string sentence = sentence_of(area);
    changes.push_back({"only in target", {}, std::move(area), std::move(sentence)});
  }
  return changes;
}

}  // namespace quadmatch
