#include "merge_view.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>

#include "html_report.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

/// Some of these vertices, for each of several groups: the faces around them, ascending.
std::vector<std::vector<FaceId>> faces_around(const Mesh& mesh, const std::vector<std::vector<VertexId>>& groups) {
  std::vector<std::pair<VertexId, std::size_t>> wanted;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (const VertexId vertex : groups[group]) wanted.emplace_back(vertex, group);
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::vector<FaceId>> faces(groups.size());
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const VertexId vertex = mesh.origin(HalfedgeId(h));
    auto place = std::lower_bound(wanted.begin(), wanted.end(), std::pair(vertex, std::size_t{0}));
    for (; place != wanted.end() && place->first == vertex; ++place) {
      faces[place->second].push_back(mesh.face(HalfedgeId(h)));
    }
  }
  for (std::vector<FaceId>& around : faces) around.erase(std::unique(around.begin(), around.end()), around.end());
  return faces;
}

void add_conflicts(std::vector<ReportChange>& changes, const MergeReport& report, const Mesh& base,
                   const Mesh& result) {
  std::vector<std::vector<VertexId>> in_base, in_result;
  for (const ConflictArea& area : report.areas) {
    in_base.push_back(area.base_vertices);
    in_result.push_back(area.merged_vertices);
  }
  const std::vector<std::vector<FaceId>> before = faces_around(base, in_base);
  const std::vector<std::vector<FaceId>> after = faces_around(result, in_result);
  for (std::size_t k = 0; k < report.areas.size(); ++k) {
    std::vector<FaceId> faces = before[k];
    faces.insert(faces.end(), report.areas[k].base_faces.begin(), report.areas[k].base_faces.end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    changes.push_back({"conflict", std::move(faces), after[k], describe(report.areas[k])});
  }
}

/// Elements of the result with two values.
void add_value_conflicts(std::vector<ReportChange>& changes, const MergeReport& report, const Mesh& result) {
  for (const ValueConflict& conflict : report.values) {
    std::vector<FaceId> faces;
    if (conflict.domain == Domain::Vertex) {
      std::vector<VertexId> vertices;
      for (const std::uint32_t number : conflict.first) vertices.emplace_back(number);
      faces = faces_around(result, {vertices}).front();
    } else {
      for (const std::uint32_t number : conflict.first) {
        faces.push_back(conflict.domain == Domain::Face ? FaceId(number) : result.face(HalfedgeId(number)));
      }
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    changes.push_back({"conflict of data", {}, std::move(faces), describe(conflict)});
  }
}

/// Who did something, in the order in which it is told.
enum class Doer : std::uint8_t { Ours, Theirs, Both };
constexpr std::array<const char*, 3> kDoers = {"OURS", "THEIRS", "both sides"};

Doer doer_of(bool ours, bool theirs) { return ours && theirs ? Doer::Both : ours ? Doer::Ours : Doer::Theirs; }

using ByDoer = std::array<std::vector<FaceId>, 3>;

PerFace<std::uint8_t> matched_faces(const Mesh& base, const Match& match) {
  PerFace<std::uint8_t> matched(base.face_count(), 0);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) matched[pair.source] = 1;
  }
  return matched;
}

/// Faces of the base that are not in the result, by the sides that have lost them.
ByDoer removed_faces(const Mesh& base, const std::vector<InThree<FaceId>>& origins, const Match& to_ours,
                     const Match& to_theirs) {
  PerFace<std::uint8_t> kept(base.face_count(), 0);
  for (const InThree<FaceId>& origin : origins) {
    if (origin[Side::Base].valid()) kept[origin[Side::Base]] = 1;
  }
  const PerFace<std::uint8_t> in_ours = matched_faces(base, to_ours), in_theirs = matched_faces(base, to_theirs);
  ByDoer removed;
  for (std::uint32_t f = 0; f < base.face_count(); ++f) {
    const FaceId face(f);
    if (kept[face] != 0) continue;
    const Doer doer = doer_of(in_ours[face] == 0, in_theirs[face] == 0);
    removed[static_cast<std::size_t>(doer)].push_back(face);
  }
  return removed;
}

/// Faces of the result that the base has not.
ByDoer added_faces(const std::vector<InThree<FaceId>>& origins) {
  ByDoer added;
  for (std::uint32_t f = 0; f < origins.size(); ++f) {
    const InThree<FaceId>& origin = origins[f];
    if (origin[Side::Base].valid()) continue;
    const Doer doer = doer_of(origin[Side::Ours].valid(), origin[Side::Theirs].valid());
    added[static_cast<std::size_t>(doer)].emplace_back(f);
  }
  return added;
}

std::string sentence_of(const std::vector<FaceId>& area, const char* mesh) {
  if (area.size() == 1) return fmt::format("{} of {}", to_string(area.front()), mesh);
  return fmt::format("{} around {} of {}", counted(area.size(), "face"), to_string(area.front()), mesh);
}

}  // namespace

ReportText report_text(const MergeSummary& summary, const Mesh& base, const Mesh& result,
                       const std::vector<InThree<FaceId>>& origins, const Match& to_ours, const Match& to_theirs) {
  ReportText text{.title = report_title(summary.base, summary.output == "-" ? "standard output" : summary.output),
                  .program = "quadmatch " QUADMATCH_VERSION,
                  .figures = figures_of(summary)};
  add_conflicts(text.changes, summary.report, base, result);
  add_value_conflicts(text.changes, summary.report, result);
  const ByDoer removed = removed_faces(base, origins, to_ours, to_theirs);
  const ByDoer added = added_faces(origins);
  for (std::size_t doer = 0; doer < kDoers.size(); ++doer) {
    for (std::vector<FaceId>& area : connected_areas(base, removed[doer])) {
      std::string sentence = sentence_of(area, "BASE");
      text.changes.push_back({fmt::format("removed by {}", kDoers[doer]), std::move(area), {}, std::move(sentence)});
    }
    for (std::vector<FaceId>& area : connected_areas(result, added[doer])) {
      std::string sentence = sentence_of(area, "OUT");
      text.changes.push_back({fmt::format("added by {}", kDoers[doer]), {}, std::move(area), std::move(sentence)});
    }
  }
  for (const DoubtfulPart& part : summary.report.doubtful) {
    text.changes.push_back({"doubtful", {part.first_base}, {}, describe(part)});
  }
  return text;
}

}  // namespace quadmatch::cli
