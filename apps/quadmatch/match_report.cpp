#include "match_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>

#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

/// Connected areas of the faces that are not in `taken`; takes them all.
std::uint32_t count_areas(const Mesh& mesh, PerFace<std::uint8_t> taken) {
  std::uint32_t areas = 0;
  std::vector<FaceId> to_visit;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (taken[FaceId(f)] != 0) continue;
    ++areas;
    taken[FaceId(f)] = 1;
    to_visit.assign(1, FaceId(f));
    while (!to_visit.empty()) {
      const FaceId face = to_visit.back();
      to_visit.pop_back();
      for (const HalfedgeId h : mesh.halfedges(face)) {
        const HalfedgeId other = mesh.twin(h);
        if (!other.valid() || taken[mesh.face(other)] != 0) continue;
        taken[mesh.face(other)] = 1;
        to_visit.push_back(mesh.face(other));
      }
    }
  }
  return areas;
}

SideReport report_side(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  PerFace<std::uint8_t> matched(mesh.face_count(), 0);
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) matched[pair.*side] = 1;
  }
  SideReport report;
  report.vertices = mesh.vertex_count();
  report.faces = mesh.face_count();
  report.matched_faces = static_cast<std::uint32_t>(match.matched_faces());
  report.unmatched_areas = count_areas(mesh, std::move(matched));
  return report;
}

const char* to_string(Orientation orientation) {
  return orientation == Orientation::Preserving ? "preserving" : "reversing";
}

std::string describe(const SeedReport& seed) {
  const std::string place = fmt::format("corner {} of f{} on corner {} of f{}", seed.source_corner,
                                        seed.source_face.value, seed.target_corner, seed.target_face.value);
  if (seed.given) return place + ", as given";
  if (seed.arbitrary) return place + ", any pair, as no vertex stands out";
  const std::string rounds = counted(seed.rounds, "round");
  if (seed.source_rarity == 1 && seed.target_rarity == 1) {
    return fmt::format("{}, unique in both meshes after {}", place, rounds);
  }
  return fmt::format("{}, one of {} and {} alike after {}", place, seed.source_rarity, seed.target_rarity, rounds);
}

std::string describe(const RegionReport& region) {
  const Evidence& evidence = region.evidence;
  std::string text = fmt::format("{}, {}; {} agree, of {} touched in the source and {} in the target",
                                 counted(region.faces, "face"), to_string(region.orientation),
                                 counted(evidence.agreeing, "extraordinary vertex", "extraordinary vertices"),
                                 grouped(evidence.source_extraordinary), grouped(evidence.target_extraordinary));
  if (region.ambiguous) text += fmt::format("; one of {} ways", grouped(region.ways));
  return text;
}

/// The largest regions, a line each, and the rest in one.
void add_regions(std::vector<ReportFigure>& figures, const std::vector<RegionReport>& regions) {
  constexpr std::size_t kMostLines = 6;
  const std::size_t shown = regions.size() <= kMostLines + 1 ? regions.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) figures.push_back({"region", describe(regions[k])});
  if (shown == regions.size()) return;
  std::uint64_t faces = 0;
  for (std::size_t k = shown; k < regions.size(); ++k) faces += regions[k].faces;
  figures.push_back(
      {"", fmt::format("and {} more of {} to {}, {} in all", regions.size() - shown,
                       counted(regions.back().faces, "face"), grouped(regions[shown].faces), counted(faces, "face"))});
}

/// What a modeller should look at before data is carried over.
std::string doubts_of(const MatchReport& report) {
  const std::uint32_t faces = report.ambiguous_faces();
  if (faces == 0) return {};
  const auto parts = std::count_if(report.regions.begin(), report.regions.end(),
                                   [](const RegionReport& region) { return region.ambiguous; });
  return fmt::format(
      "{} in {} could as well lie otherwise: in a symmetric part, in one of several that are equal, or in rows of "
      "quads "
      "beside which one came or went; nothing says which is which, an --anchor there would",
      counted(faces, "face"), counted(static_cast<std::uint64_t>(parts), "region"));
}

std::string describe(const SideReport& side) {
  const std::string faces = fmt::format("{}: {}", display_name(side.path), counted(side.faces, "face"));
  if (side.unmatched_faces() == 0) return faces + ", all matched";
  return fmt::format("{}, {} matched, {} unmatched in {}", faces, percent(side.matched_faces, side.faces),
                     grouped(side.unmatched_faces()), counted(side.unmatched_areas, "area"));
}

Json side_json(const SideReport& side) {
  const double coverage = side.faces == 0 ? 0.0 : static_cast<double>(side.matched_faces) / side.faces;
  return {{"path", side.path},
          {"vertices", side.vertices},
          {"faces", side.faces},
          {"matched_faces", side.matched_faces},
          {"coverage", coverage},
          {"unmatched_faces", side.unmatched_faces()},
          {"unmatched_areas", side.unmatched_areas}};
}

Json seed_json(const std::optional<SeedReport>& seed) {
  if (!seed) return nullptr;
  Json json = {{"source_face", seed->source_face.value},
               {"source_corner", seed->source_corner},
               {"target_face", seed->target_face.value},
               {"target_corner", seed->target_corner},
               {"found_by", seed->given       ? "user"
                            : seed->arbitrary ? "arbitrary choice"
                                              : "colour"}};
  if (!seed->given && !seed->arbitrary) {
    json["rounds"] = seed->rounds;
    json["source_rarity"] = seed->source_rarity;
    json["target_rarity"] = seed->target_rarity;
  }
  return json;
}

Json region_json(const RegionReport& region) {
  return {{"orientation", to_string(region.orientation)},
          {"faces", region.faces},
          {"confidence", region.evidence.confidence()},
          {"ways", region.ways},
          {"ambiguous", region.ambiguous},
          {"evidence",
           {{"agreeing", region.evidence.agreeing},
            {"source_extraordinary", region.evidence.source_extraordinary},
            {"target_extraordinary", region.evidence.target_extraordinary}}}};
}

/// What is proved of the size, in plain words.
std::string describe(const Optimality& optimality, std::uint32_t faces) {
  const std::string nodes = counted(optimality.nodes, "node", "nodes") + " searched";
  if (optimality.proved) return fmt::format("proved: no region has more than {}; {}", counted(faces, "face"), nodes);
  return fmt::format("not proved: a region has {} at most; {}", counted(optimality.bound, "face"), nodes);
}

std::string answer(const Optimality& optimality) {
  const std::string asked = counted(optimality.at_least, "face") + " or more";
  switch (optimality.decision) {
    case Decision::Yes:
      return fmt::format("yes, there is a region of {}", asked);
    case Decision::No:
      return fmt::format("no, there is no region of {}", asked);
    default:
      return fmt::format("unknown: the search ended before it was settled whether there is a region of {}", asked);
  }
}

Json optimality_json(const Optimality& optimality) {
  Json json = {{"proved", optimality.proved}, {"bound", optimality.bound}, {"nodes", optimality.nodes}};
  if (optimality.decision != Decision::NotAsked) {
    json["at_least"] = optimality.at_least;
    json["answer"] = optimality.decision == Decision::Yes  ? "yes"
                     : optimality.decision == Decision::No ? "no"
                                                           : "unknown";
  }
  return json;
}

}  // namespace

std::uint32_t MatchReport::ambiguous_faces() const {
  std::uint32_t faces = 0;
  for (const RegionReport& region : regions) faces += region.ambiguous ? region.faces : 0;
  return faces;
}

MatchReport report_match(const Mesh& source, const Mesh& target, const MatchResult& result, bool anchors_given) {
  MatchReport report;
  report.source = report_side(source, result.match, &FacePair::source);
  report.target = report_side(target, result.match, &FacePair::target);
  report.matched_vertices = static_cast<std::uint32_t>(result.match.vertices.size());
  for (const Region& region : result.match.regions) {
    report.regions.push_back({region.orientation, static_cast<std::uint32_t>(region.faces.size()), region.evidence,
                              region.ways, region.ambiguous});
  }
  report.optimality = result.optimality;
  if (const Anchor& seed = result.seed; seed.source.valid()) {
    report.seed = SeedReport{.source_face = source.face(seed.source),
                             .target_face = target.face(seed.target),
                             .source_corner = source.corner(seed.source),
                             .target_corner = target.corner(seed.target),
                             .given = anchors_given,
                             .arbitrary = result.search.arbitrary,
                             .rounds = result.search.rounds,
                             .source_rarity = result.search.source_rarity,
                             .target_rarity = result.search.target_rarity};
  }
  return report;
}

std::vector<ReportFigure> figures_of(const MatchReport& report) {
  std::vector<ReportFigure> figures;
  const auto add = [&figures](std::string name, std::string text) {
    figures.push_back({std::move(name), std::move(text)});
  };
  add("source", describe(report.source));
  add("target", describe(report.target));
  add("matched", report.regions.empty() ? "nothing"
                                        : fmt::format("{}, {}", counted(report.matched_faces(), "face"),
                                                      counted(report.matched_vertices, "vertex", "vertices")));
  add_regions(figures, report.regions);
  if (std::string doubts = doubts_of(report); !doubts.empty()) add("doubtful", std::move(doubts));
  if (report.optimality) {
    add("largest", describe(*report.optimality, report.matched_faces()));
    if (report.optimality->decision != Decision::NotAsked) add("answer", answer(*report.optimality));
  }
  if (report.seed) add("anchor", describe(*report.seed));
  return figures;
}

std::string as_text(const MatchReport& report) {
  Lines lines;
  for (ReportFigure& figure : figures_of(report)) lines.add(std::move(figure.name), std::move(figure.text));
  lines.add("time", fmt::format("reading {}, matching {}, verifying {}", duration(report.times.reading),
                                duration(report.times.matching), duration(report.times.verifying)));
  add_written(lines, {report.output, report.page}, report.pictures);
  return lines.render();
}

std::string as_json(const MatchReport& report) {
  Json regions = Json::array();
  for (const RegionReport& region : report.regions) regions.push_back(region_json(region));
  Json settings = Json::object();
  for (const auto& [name, value] : report.settings) settings[name] = value;
  return json_text({{"source", side_json(report.source)},
                    {"target", side_json(report.target)},
                    {"matched_faces", report.matched_faces()},
                    {"matched_vertices", report.matched_vertices},
                    {"ambiguous_faces", report.ambiguous_faces()},
                    {"regions", regions},
                    {"optimality", report.optimality ? optimality_json(*report.optimality) : Json(nullptr)},
                    {"anchor", seed_json(report.seed)},
                    {"settings", settings},
                    {"milliseconds",
                     {{"reading", rounded(report.times.reading)},
                      {"matching", rounded(report.times.matching)},
                      {"verifying", rounded(report.times.verifying)},
                      {"writing", rounded(report.times.writing)}}},
                    {"output", report.output.empty() ? Json(nullptr) : Json(report.output)},
                    {"report", report.page.empty() ? Json(nullptr) : Json(report.page)},
                    {"pictures", report.pictures}});
}

}  // namespace quadmatch::cli
