#include "symmetry_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>

#include "html_report.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

/// The axis a plane is across, if it is across one.
std::optional<std::size_t> axis_of(const MirrorPlane& plane) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (plane.normal[axis] > 0.999) return axis;
  }
  return std::nullopt;
}

std::size_t main_axis(const MirrorPlane& plane) {
  return static_cast<std::size_t>(std::max_element(plane.normal.begin(), plane.normal.end(),
                                                   [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                                  plane.normal.begin());
}

std::string place_of(const std::optional<MirrorPlane>& plane, const Point& sum, double corners) {
  if (!plane) return {};
  double height = -plane->offset;
  for (std::size_t axis = 0; axis < 3; ++axis) height += plane->normal[axis] * sum[axis] / corners;
  return fmt::format("on the {}{} side", height < 0 ? '-' : '+', "xyz"[main_axis(*plane)]);
}

std::string describe_plane(const MirrorPlane& plane) {
  // No "-0": a plane through the middle, but for rounding, is a plane through the middle.
  const auto plain = [](double number) { return std::abs(number) < 1e-5 ? 0.0 : number; };
  const std::optional<std::size_t> axis = axis_of(plane);
  const std::string where = axis ? fmt::format("{} = {:.4g}", "xyz"[*axis], plain(plane.offset))
                                 : fmt::format("across ({:.3f}, {:.3f}, {:.3f})", plain(plane.normal[0]),
                                               plain(plane.normal[1]), plain(plane.normal[2]));
  if (plane.error < 5e-6) return where + "; half of the vertices or more are exactly opposite their partners";
  const std::string off =
      fmt::format("in it vertices miss their partners by {:.2g} % of the model's size", 100 * plane.error);
  if (plane.fits()) return fmt::format("{}; {}", where, off);
  return fmt::format("none: the model is posed; {}, at best", off);
}

std::string describe_mirrors(const Symmetry& symmetry) {
  if (symmetry.mirrors == 0) return "none was found";
  if (symmetry.mirrors == 1) return "one";
  return fmt::format(
      "{}{} fit as well as each other; taken is the one whose edges are as long as their partners and "
      "whose plane is nearest to x",
      symmetry.maybe_more ? "at least " : "", grouped(symmetry.mirrors));
}

std::string describe_mesh(const SymmetrySummary& summary) {
  const Symmetry& symmetry = summary.symmetry;
  const std::string size = fmt::format("{}: {}, {}", display_name(summary.path), counted(symmetry.faces, "face"),
                                       counted(symmetry.vertices, "vertex", "vertices"));
  if (symmetry.whole()) return size + ", wholly symmetric";
  const auto paired = static_cast<std::uint32_t>(symmetry.faces - symmetry.unpaired_faces.size());
  return fmt::format("{}; {} of the faces have a mirror image", size, percent(paired, symmetry.faces));
}

std::string describe_line(const CentreLine& line) {
  if (line.empty()) return "none: no vertex, edge or face lies on itself";
  return fmt::format("{}, {} along it; it crosses {} and {}", counted(line.vertices.size(), "vertex", "vertices"),
                     counted(line.edges.size(), "edge"), counted(line.crossed_edges.size(), "edge"),
                     counted(line.faces.size(), "face"));
}

std::string describe(const LonelyArea& area) {
  return fmt::format("{}{} from f{} on: nothing opposite is connected like this", counted(area.faces.size(), "face"),
                     area.place.empty() ? "" : " " + area.place, area.faces.front().value);
}

void add_lonely(std::vector<ReportFigure>& figures, const SymmetrySummary& summary) {
  constexpr std::size_t kMostLines = 8;
  const std::vector<LonelyArea>& areas = summary.lonely;
  const std::size_t shown = areas.size() <= kMostLines + 1 ? areas.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) figures.push_back({k == 0 ? "no partner" : "", describe(areas[k])});
  if (shown < areas.size()) figures.push_back({"", fmt::format("and {} more areas", areas.size() - shown)});
  const std::size_t vertices = summary.symmetry.unpaired_vertices.size();
  if (vertices == 0) return;
  figures.push_back(
      {shown == 0 ? "no partner" : "", fmt::format("{} in all", counted(vertices, "vertex", "vertices"))});
}

/// What the summary says, line by line, but for times and files.
std::vector<ReportFigure> figures_of(const SymmetrySummary& summary) {
  const Symmetry& symmetry = summary.symmetry;
  std::vector<ReportFigure> figures{{"mesh", describe_mesh(summary)}, {"mirrors", describe_mirrors(symmetry)}};
  if (symmetry.mirrors > 0) {
    figures.push_back({"pairs", fmt::format("{} of faces, {} of vertices", grouped(symmetry.face_pairs),
                                            grouped(symmetry.vertex_pairs))});
    figures.push_back({"centre line", describe_line(symmetry.line)});
    if (symmetry.plane) figures.push_back({"plane", describe_plane(*symmetry.plane)});
  }
  add_lonely(figures, summary);
  return figures;
}

/// Faces that the line runs through or along.
std::vector<FaceId> faces_at_line(const Mesh& mesh, const CentreLine& line) {
  std::vector<FaceId> faces = line.faces;
  PerVertex<std::uint8_t> on_line(mesh.vertex_count(), 0);
  for (const VertexId vertex : line.vertices) on_line[vertex] = 1;
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId side(h);
    if (on_line[mesh.origin(side)] != 0 && on_line[mesh.tip(side)] != 0) faces.push_back(mesh.face(side));
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Cuts the regions of a mirror where a face meets its own partner, and around faces that are their own.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const Match& match) : mesh_(mesh), pair_of_(mesh.face_count()), to_take_(mesh.face_count()) {
    for (std::uint32_t r = 0; r < match.regions.size(); ++r) {
      for (const FacePair& pair : match.regions[r].faces) {
        pair_of_[pair.source] = {r, pair};
        to_take_[pair.source] = 1;
      }
    }
  }

  /// The piece around a face, none where it was taken before; faces in the order in which they are met.
  std::vector<FacePair> take(FaceId start) {
    std::vector<FacePair> piece;
    if (!start.valid() || to_take_[start] == 0) return piece;
    to_take_[start] = 0;
    piece.push_back(pair_of_[start].pair);
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const FaceId here = piece[next].source;
      for (const HalfedgeId h : mesh_.halfedges(here)) {
        const HalfedgeId other = mesh_.twin(h);
        if (!other.valid() || to_take_[mesh_.face(other)] == 0 || !hang_together(here, mesh_.face(other))) continue;
        to_take_[mesh_.face(other)] = 0;
        piece.push_back(pair_of_[mesh_.face(other)].pair);
      }
    }
    return piece;
  }

 private:
  struct Placed {
    std::uint32_t region = 0;
    FacePair pair = {};
  };

  [[nodiscard]] bool hang_together(FaceId a, FaceId b) const {
    const auto& [region_a, pair_a] = pair_of_[a];
    const auto& [region_b, pair_b] = pair_of_[b];
    const bool a_on_line = pair_a.target == a, b_on_line = pair_b.target == b;
    return region_a == region_b && pair_a.target != b && a_on_line == b_on_line;
  }

  const Mesh& mesh_;
  PerFace<Placed> pair_of_;
  PerFace<std::uint8_t> to_take_;
};

void add_symmetrized(Lines& lines, const SymmetrizeSummary& done) {
  if (done.with_positions) {
    lines.add("copied", fmt::format("positions of the {} side: {} moved, by {:.3g} at most", done.side,
                                    counted(done.moved, "vertex", "vertices"), done.farthest));
  }
  for (std::size_t k = 0; k < done.copied.size(); ++k) {
    lines.add(k == 0 && !done.with_positions ? "copied" : "",
              fmt::format("{} of the {} side, to {}", done.copied[k].first, done.side,
                          counted(done.copied[k].second, "element")));
  }
}

Json edges(const std::vector<std::pair<VertexId, VertexId>>& pairs) {
  Json result = Json::array();
  for (const auto& [a, b] : pairs) result.push_back({a.value, b.value});
  return result;
}

Json plane_json(const std::optional<MirrorPlane>& plane) {
  if (!plane) return nullptr;
  return {{"normal", plane->normal}, {"offset", plane->offset}, {"error", plane->error}, {"fits", plane->fits()}};
}

}  // namespace

std::vector<LonelyArea> lonely_areas(const Mesh& mesh, const Symmetry& symmetry) {
  std::vector<LonelyArea> areas;
  for (std::vector<FaceId>& faces : connected_areas(mesh, symmetry.unpaired_faces)) {
    Point sum = {0, 0, 0};
    double corners = 0;
    for (const FaceId face : faces) {
      corners += mesh.size(face);
      if (mesh.positions().empty()) continue;
      for (const HalfedgeId h : mesh.halfedges(face)) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += mesh.positions()[mesh.origin(h).value][axis];
      }
    }
    std::string place = place_of(symmetry.plane, sum, corners);
    areas.push_back({std::move(faces), std::move(place)});
  }
  return areas;
}

Match cut_along_line(const Mesh& mesh, const Symmetry& symmetry) {
  Match cut{.regions = {}, .vertices = symmetry.match.vertices, .complete = symmetry.match.complete};
  Cutter cutter(mesh, symmetry.match);
  for (const Region& region : symmetry.match.regions) {
    for (const FacePair& pair : region.faces) {
      for (const FaceId start : {pair.source, pair.target}) {  // the piece opposite comes next
        std::vector<FacePair> piece = cutter.take(start);
        if (piece.empty()) continue;
        cut.regions.push_back(region);
        cut.regions.back().faces = std::move(piece);
        cut.regions.back().waves.clear();
      }
    }
  }
  std::stable_sort(cut.regions.begin(), cut.regions.end(),
                   [](const Region& a, const Region& b) { return a.faces.size() > b.faces.size(); });
  return cut;
}

ReportText report_text(const Mesh& mesh, const SymmetrySummary& summary) {
  ReportText text{.title = report_title(summary.path, "its mirror image"),
                  .program = "quadmatch " QUADMATCH_VERSION,
                  .figures = figures_of(summary),
                  .changes = {},
                  .mirror = true};
  if (const CentreLine& line = summary.symmetry.line; !line.empty()) {
    const std::vector<FaceId> faces = faces_at_line(mesh, line);
    text.changes.push_back({"centre line", faces, faces, describe_line(line)});
  }
  for (const LonelyArea& area : summary.lonely) {
    text.changes.push_back({"no partner", area.faces, area.faces, describe(area)});
  }
  return text;
}

std::string map_field(const Symmetry& symmetry) {
  const Json json = {
      {"mirrors", symmetry.mirrors},
      {"maybe_more", symmetry.maybe_more},
      {"plane", plane_json(symmetry.plane)},
      {"centre_line",
       {{"vertices", numbers(symmetry.line.vertices)},
        {"edges", edges(symmetry.line.edges)},
        {"crossed_edges", edges(symmetry.line.crossed_edges)},
        {"faces", numbers(symmetry.line.faces)}}},
      {"unpaired", {{"vertices", numbers(symmetry.unpaired_vertices)}, {"faces", numbers(symmetry.unpaired_faces)}}}};
  return json.dump();
}

std::string as_text(const SymmetrySummary& summary) {
  Lines lines;
  for (ReportFigure& figure : figures_of(summary)) lines.add(std::move(figure.name), std::move(figure.text));
  if (summary.symmetrized) add_symmetrized(lines, *summary.symmetrized);
  lines.add("time",
            fmt::format("reading {}, matching {}", duration(summary.times.reading), duration(summary.times.matching)));
  const auto file = [](const std::string& output) { return output == "-" ? std::string() : output; };
  add_written(lines, {file(summary.output), summary.symmetrized ? file(summary.symmetrized->output) : "", summary.page},
              summary.pictures);
  return lines.render();
}

std::string as_json(const SymmetrySummary& summary) {
  const Symmetry& symmetry = summary.symmetry;
  Json areas = Json::array(), settings = Json::object();
  for (const LonelyArea& area : summary.lonely) {
    areas.push_back({{"first_face", area.faces.front().value}, {"faces", area.faces.size()}, {"place", area.place}});
  }
  for (const auto& [name, value] : summary.settings) settings[name] = value;
  Json json = {{"mesh", {{"path", summary.path}, {"faces", symmetry.faces}, {"vertices", symmetry.vertices}}},
               {"whole", symmetry.whole()},
               {"mirrors", symmetry.mirrors},
               {"maybe_more", symmetry.maybe_more},
               {"face_pairs", symmetry.face_pairs},
               {"vertex_pairs", symmetry.vertex_pairs},
               {"centre_line",
                {{"vertices", symmetry.line.vertices.size()},
                 {"edges", symmetry.line.edges.size()},
                 {"crossed_edges", symmetry.line.crossed_edges.size()},
                 {"faces", symmetry.line.faces.size()}}},
               {"plane", plane_json(symmetry.plane)},
               {"unpaired_faces", symmetry.unpaired_faces.size()},
               {"unpaired_vertices", symmetry.unpaired_vertices.size()},
               {"unpaired_areas", areas}};
  if (summary.symmetrized) {
    const SymmetrizeSummary& done = *summary.symmetrized;
    Json copied = Json::object();
    for (const auto& [name, elements] : done.copied) copied[name] = elements;
    json["symmetrized"] = {{"output", done.output},
                           {"from", done.side},
                           {"moved", done.moved},
                           {"farthest", done.farthest},
                           {"copied", copied}};
  }
  json["settings"] = settings;
  json["milliseconds"] = {{"reading", rounded(summary.times.reading)}, {"matching", rounded(summary.times.matching)}};
  json["output"] = summary.output;
  json["report"] = summary.page.empty() ? Json(nullptr) : Json(summary.page);
  json["pictures"] = summary.pictures;
  return json_text(json);
}

}  // namespace quadmatch::cli
