// The check against an independent program: the table that tools/mesh_stats.py wrote about the collection of meshes.

#include "named_meshes.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/mesh/check.hpp>

using namespace quadmatch;
namespace fs = std::filesystem;

namespace {

/// A row of the table: cell by column title.
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') + 1 - first));
  }
  return cells;
}

/// Every row of every table that begins with the columns file, V, E.
std::vector<Row> statistics_rows(const fs::path& readme) {
  std::vector<Row> rows;
  std::vector<std::string> titles;
  std::ifstream file(readme);
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() < 4) {
      titles.clear();
    } else if (cells[1] == "file" && cells[2] == "V") {
      titles = cells;
    } else if (!titles.empty() && cells[1].find(".obj") != std::string::npos) {
      Row row;
      for (std::size_t i = 1; i < std::min(cells.size(), titles.size()); ++i) row[titles[i]] = cells[i];
      rows.push_back(row);
    }
  }
  return rows;
}

/// "0x3 1 ?" as a count of each genus.
std::map<std::string, int> genera_of(const std::string& text) {
  std::map<std::string, int> genera;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t times = word.find('x');
    genera[word.substr(0, times)] += times == std::string::npos ? 1 : std::stoi(word.substr(times + 1));
  }
  return genera;
}

std::map<std::string, int> genera_of(const CheckReport& report) {
  std::map<std::string, int> genera;
  for (const ComponentReport& component : report.components) {
    const std::string number = component.genus ? std::to_string(*component.genus) : "?";
    ++genera[component.genus && !component.orientable ? number + "K" : number];
  }
  return genera;
}

std::size_t count(const CheckReport& report, DepartureKind kind) {
  return report.departure_counts[static_cast<std::size_t>(kind)];
}

void compare(const CheckReport& report, const Row& row) {
  CHECK(std::to_string(report.vertices) == row.at("V"));
  CHECK(std::to_string(report.edges) == row.at("E"));
  CHECK(std::to_string(report.faces) == row.at("F"));
  CHECK(std::to_string(report.triangles) == row.at("tri"));
  CHECK(std::to_string(report.larger) == row.at("ngon"));
  CHECK(100.0 * report.quads / report.faces == doctest::Approx(std::stod(row.at("quad%"))).epsilon(1e-3));
  CHECK(std::to_string(report.components.size()) == row.at("comp"));
  CHECK(std::to_string(report.boundary_loops) == row.at("loops"));
  CHECK(std::to_string(report.extraordinary) == row.at("xord"));
  CHECK(std::to_string(std::int64_t{report.vertices} - report.edges + report.faces) == row.at("chi"));
  CHECK(genera_of(report) == genera_of(row.at("genus")));
  CHECK(std::to_string(count(report, DepartureKind::NonManifoldEdge)) + "/" +
            std::to_string(count(report, DepartureKind::DisconnectedVertex)) ==
        row.at("nm e/v"));
  const bool consistent = count(report, DepartureKind::InconsistentWinding) == 0;
  const bool orientable = count(report, DepartureKind::NotOrientable) == 0;
  CHECK((consistent ? "consistent" : orientable ? "orientable" : "NON-ORIENTABLE") == row.at("orientation"));
}

}  // namespace

TEST_CASE("check counts what an independent program counts on every mesh of the collection") {
  const fs::path folder = QUADMATCH_SHARED_MESHES;
  const std::vector<Row> rows = statistics_rows(folder / "README.md");
  if (rows.empty()) {
    MESSAGE("skipped: there is no collection of meshes at " << folder);
    return;
  }
  CHECK(rows.size() >= 30);
  for (const Row& row : rows) {
    const std::string& name = row.at("file");
    CAPTURE(name);
    const fs::path single = folder / name;
    const Expected<MeshFile> file = read_mesh((fs::exists(single) ? single : folder / "pairs" / name).string());
    REQUIRE_MESSAGE(file.has_value(), name);
    compare(check(file->mesh), row);
  }
}
