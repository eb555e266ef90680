#include "symmetry_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

void add_lonely(Lines& lines, const SymmetrySummary& summary) {
  constexpr std::size_t kMostLines = 8;
  const std::vector<LonelyArea>& areas = summary.lonely;
  const std::size_t shown = areas.size() <= kMostLines + 1 ? areas.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) {
    const LonelyArea& area = areas[k];
    lines.add(k == 0 ? "no partner" : "",
              fmt::format("{}{} from f{} on: nothing opposite is connected like this", counted(area.faces, "face"),
                          area.place.empty() ? "" : " " + area.place, area.first.value));
  }
  if (shown < areas.size()) lines.add("", fmt::format("and {} more areas", areas.size() - shown));
  const std::size_t vertices = summary.symmetry.unpaired_vertices.size();
  if (vertices > 0) {
    lines.add(shown == 0 ? "no partner" : "", fmt::format("{} in all", counted(vertices, "vertex", "vertices")));
  }
}

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
  PerFace<std::uint8_t> is_lonely(mesh.face_count(), 0);
  for (const FaceId face : symmetry.unpaired_faces) is_lonely[face] = 1;
  std::vector<LonelyArea> areas;
  for (const FaceId seed : symmetry.unpaired_faces) {
    if (is_lonely[seed] == 0) continue;
    is_lonely[seed] = 0;
    std::vector<FaceId> faces{seed};
    Point sum = {0, 0, 0};
    double corners = 0;
    for (std::size_t here = 0; here < faces.size(); ++here) {
      for (const HalfedgeId h : mesh.halfedges(faces[here])) {
        if (!mesh.positions().empty()) {
          for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += mesh.positions()[mesh.origin(h).value][axis];
        }
        corners += 1;
        const HalfedgeId beside = mesh.twin(h);
        if (!beside.valid() || is_lonely[mesh.face(beside)] == 0) continue;
        is_lonely[mesh.face(beside)] = 0;
        faces.push_back(mesh.face(beside));
      }
    }
    areas.push_back({seed, static_cast<std::uint32_t>(faces.size()), place_of(symmetry.plane, sum, corners)});
  }
  std::stable_sort(areas.begin(), areas.end(),
                   [](const LonelyArea& a, const LonelyArea& b) { return a.faces > b.faces; });
  return areas;
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
  const Symmetry& symmetry = summary.symmetry;
  Lines lines;
  lines.add("mesh", describe_mesh(summary));
  lines.add("mirrors", describe_mirrors(symmetry));
  if (symmetry.mirrors > 0) {
    lines.add("pairs",
              fmt::format("{} of faces, {} of vertices", grouped(symmetry.face_pairs), grouped(symmetry.vertex_pairs)));
    lines.add("centre line", describe_line(symmetry.line));
    if (symmetry.plane) lines.add("plane", describe_plane(*symmetry.plane));
  }
  add_lonely(lines, summary);
  if (summary.symmetrized) add_symmetrized(lines, *summary.symmetrized);
  lines.add("time",
            fmt::format("reading {}, matching {}", duration(summary.times.reading), duration(summary.times.matching)));
  if (!summary.output.empty() && summary.output != "-") lines.add("written", summary.output);
  if (summary.symmetrized && summary.symmetrized->output != "-") lines.add("written", summary.symmetrized->output);
  return lines.render();
}

std::string as_json(const SymmetrySummary& summary) {
  const Symmetry& symmetry = summary.symmetry;
  Json areas = Json::array(), settings = Json::object();
  for (const LonelyArea& area : summary.lonely) {
    areas.push_back({{"first_face", area.first.value}, {"faces", area.faces}, {"place", area.place}});
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
  return json_text(json);
}

}  // namespace quadmatch::cli
