// quadmatch check A...: is each mesh simple and well-formed (§2.1), and where is it not?

#include <map>
#include <optional>

#include <fmt/format.h>

#include <quadmatch/analysis/connectivity_hash.hpp>
#include <quadmatch/mesh/check.hpp>

#include "command.hpp"
#include "console.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(A mesh is well-formed when all its faces are quads, the faces around every vertex hang
together, no hole touches itself, every edge has one or two faces that run along it in
opposite directions, and any two quads meet in one edge, in one vertex, or not at all.
Matching takes any mesh; this tells where one departs from the ideal.

A vertex is extraordinary when its valence is not 4 inside, or not 3 on the boundary.
Elements are numbered from 0, in the order of the file: v12 is a vertex, f7 a face.

--hash names what a mesh is by its connectivity: meshes have the same hash if one is the
other with vertices, faces and first corners in another order, and only then. One hash keeps
the orientation, the other is the same for a mirror image too. Positions do not matter.

Examples:
  quadmatch check model.obj
  quadmatch check *.obj --json
  quadmatch check model.obj --list 100
  quadmatch check *.obj --hash --json | jq -r '.[] | .hash.unoriented + " " + .path'

Exit status: 0 all are well-formed, 1 one is not, 2 trouble.)";

struct CheckArguments {
  std::vector<std::string> meshes;
  std::size_t list = 3;
  bool hash = false;
  bool json = false;
  bool quiet = false;
};

std::string genus_of(const ComponentReport& component) {
  if (!component.genus) return "not manifold";
  return component.orientable ? fmt::format("of genus {}", *component.genus)
                              : fmt::format("one-sided with {}", counted(*component.genus, "crosscap"));
}

/// "64 of genus 0, 6 of genus 1, 2 not manifold", in the order in which they first come.
std::string describe_genera(const std::vector<ComponentReport>& components) {
  std::vector<std::pair<std::string, std::size_t>> genera;
  for (const ComponentReport& component : components) {
    const std::string genus = genus_of(component);
    const auto known =
        std::find_if(genera.begin(), genera.end(), [&genus](const auto& entry) { return entry.first == genus; });
    if (known == genera.end()) {
      genera.emplace_back(genus, 1);
    } else {
      ++known->second;
    }
  }
  if (components.size() == 1) return genera[0].first;
  std::vector<std::string> parts;
  for (const auto& [genus, count] : genera) parts.push_back(fmt::format("{} {}", grouped(count), genus));
  return joined(parts);
}

std::string describe_faces(const CheckReport& report) {
  std::vector<std::string> kinds;
  if (report.quads > 0) kinds.push_back(counted(report.quads, "quad"));
  if (report.triangles > 0) kinds.push_back(counted(report.triangles, "triangle"));
  if (report.larger > 0) kinds.push_back(fmt::format("{} larger", grouped(report.larger)));
  return fmt::format("{}: {}", grouped(report.faces), joined(kinds));
}

/// How often each kind was found, and under it the first places.
void add_departures(Lines& lines, const CheckReport& report) {
  for (std::size_t index = 0; index < report.departure_counts.size(); ++index) {
    const std::size_t count = report.departure_counts[index];
    if (count == 0) continue;
    lines.add(to_string(static_cast<DepartureKind>(index)), grouped(count));
    std::size_t named = 0;
    for (const Departure& departure : report.departures) {
      if (departure.kind != static_cast<DepartureKind>(index)) continue;
      lines.add("", "  " + departure.message);
      ++named;
    }
    if (named > 0 && named < count) lines.add("", fmt::format("  and {} more", grouped(count - named)));
  }
}

void add_hash(Lines& lines, const ConnectivityHash& hash) {
  lines.add("hash", fmt::format("{}, oriented", hash.oriented.hex()));
  lines.add("", hash.oriented == hash.mirrored ? "  the mesh is its own mirror image, so that is the unoriented one too"
                                               : fmt::format("{}, unoriented", hash.unoriented().hex()));
}

std::string as_text(const std::string& path, const CheckReport& report, const std::optional<ConnectivityHash>& hash) {
  Lines lines;
  lines.add("vertices", grouped(report.vertices));
  lines.add("edges", grouped(report.edges));
  lines.add("faces", describe_faces(report));
  lines.add("components", fmt::format("{}: {}", grouped(report.components.size()), describe_genera(report.components)));
  lines.add("boundary loops", grouped(report.boundary_loops));
  lines.add("extraordinary", fmt::format("{}, {}", counted(report.extraordinary, "vertex", "vertices"),
                                         percent(report.extraordinary, report.vertices)));
  if (hash) add_hash(lines, *hash);
  add_departures(lines, report);
  return fmt::format("{}: {}\n{}", display_name(path), report.well_formed() ? "well-formed" : "not well-formed",
                     lines.render(2));
}

Json component_json(const ComponentReport& component) {
  return {{"vertices", component.vertices},
          {"edges", component.edges},
          {"faces", component.faces},
          {"boundary_loops", component.boundary_loops},
          {"extraordinary", component.extraordinary},
          {"euler", component.euler},
          {"manifold", component.manifold},
          {"orientable", component.orientable},
          {"genus", component.genus ? Json(*component.genus) : Json(nullptr)}};
}

Json as_json(const std::string& path, const CheckReport& report, const std::optional<ConnectivityHash>& hash) {
  Json components = Json::array();
  for (const ComponentReport& component : report.components) components.push_back(component_json(component));
  Json departures = Json::object();
  for (std::size_t index = 0; index < report.departure_counts.size(); ++index) {
    departures[to_string(static_cast<DepartureKind>(index))] = {{"count", report.departure_counts[index]},
                                                                {"first", Json::array()}};
  }
  for (const Departure& departure : report.departures) {
    departures[to_string(departure.kind)]["first"].push_back(departure.message);
  }
  Json json{{"path", path},
            {"well_formed", report.well_formed()},
            {"vertices", report.vertices},
            {"edges", report.edges},
            {"faces", report.faces},
            {"quads", report.quads},
            {"triangles", report.triangles},
            {"larger_faces", report.larger},
            {"boundary_loops", report.boundary_loops},
            {"extraordinary", report.extraordinary},
            {"components", components},
            {"departures", departures}};
  if (hash) json["hash"] = {{"oriented", hash->oriented.hex()}, {"unoriented", hash->unoriented().hex()}};
  return json;
}

int run_check(const CheckArguments& arguments) {
  if (!paths_fit(arguments.meshes, {})) return kTrouble;
  int status = kSame;
  Json reports = Json::array();
  for (const std::string& path : arguments.meshes) {
    const std::optional<MeshFile> file = read_input(path, !arguments.quiet);
    if (!file) {
      status = kTrouble;  // the others are checked all the same
      continue;
    }
    const CheckReport report = check(file->mesh, arguments.list);
    if (!report.well_formed()) status = std::max(status, kDifferent);
    std::optional<ConnectivityHash> hash;
    if (arguments.hash) hash = connectivity_hash(file->mesh);
    if (arguments.json) {
      reports.push_back(as_json(path, report, hash));
    } else if (!arguments.quiet && !print(as_text(path, report, hash))) {
      return kTrouble;
    }
  }
  if (arguments.json && !print(json_text(reports))) return kTrouble;
  return status;
}

}  // namespace

void add_check_command(CLI::App& program, Action& chosen) {
  CheckArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "check", "Tell whether meshes are well-formed, and where they are not",
                                  arguments, run_check, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->meshes, "Meshes; - reads standard input")->required()->type_name("FILE");
  verb->add_option("--list", arguments->list, "How many departures of each kind to name; all are counted")
      ->type_name("N")
      ->capture_default_str();
  verb->add_flag("--hash", arguments->hash,
                 "Print the hashes of the connectivity, oriented and unoriented (see below)");
  verb->add_flag("--json", arguments->json, "Print the figures as JSON, one object for each mesh");
  verb->add_flag("--quiet", arguments->quiet, "Print nothing, only set the exit status");
}

}  // namespace quadmatch::cli
