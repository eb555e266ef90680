// quadmatch diff --git: git calls it with a path and two files; quadmatch diff --textconv: with one file. A file that
// is no mesh is said to be none, and the exit status is 0 all the same: any other makes git stop, and the other files
// are not shown.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <quadmatch/analysis/connectivity_hash.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/mesh/check.hpp>

#include "parts_diff.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kNoFile = "/dev/null";
/// A mean that is smaller than this share of the extent is what rounding left of 0.
constexpr double kNoise = 1e-9;

/// PATH OLD OLD-HEX OLD-MODE NEW NEW-HEX NEW-MODE, and of a renamed file its new path and how like both are.
struct GitArguments {
  std::string path, new_path;
  std::string old_file, new_file;
};

GitArguments parse(const std::vector<std::string>& words) {
  GitArguments git{words[0], words.size() > 7 ? words[7] : words[0], words[1], words[4]};
  return git;
}

std::string headline(const GitArguments& git) {
  return git.path == git.new_path ? fmt::format("quadmatch diff {}\n", git.path)
                                  : fmt::format("quadmatch diff {} {}\n", git.path, git.new_path);
}

/// What is wrong with a file, without the name that git made up for it.
std::string describe(const Error& error) {
  return error.line > 0 ? fmt::format("line {}: {}", error.line, error.message) : error.message;
}

/// A file that came or went.
std::string describe_whole(const char* what, const Expected<MeshFile>& file) {
  if (!file) return fmt::format("{}, cannot be read: {}\n", what, describe(file.error()));
  return fmt::format("{}: {}, {}\n", what, counted(file->mesh.face_count(), "face"),
                     counted(file->mesh.vertex_count(), "vertex", "vertices"));
}

bool print_lines(const DiffArguments& arguments, const GitArguments& git, const std::string& text) {
  return print(arguments.stat ? fmt::format("{}: {}", git.new_path, text) : headline(git) + text);
}

/// The components of a mesh, a line for those that are alike, in an order that does not depend on numbers.
std::vector<std::string> component_lines(const CheckReport& report) {
  std::map<std::string, std::size_t> counts;
  for (const ComponentReport& component : report.components) {
    ++counts[fmt::format("component of {:7} faces, {} vertices, {}, {} extraordinary, Euler {}", component.faces,
                         component.vertices, counted(component.boundary_loops, "boundary loop"),
                         component.extraordinary, component.euler)];
  }
  std::vector<std::string> lines;
  for (const auto& [line, count] : counts)
    lines.push_back(count == 1 ? line : fmt::format("{}, {} times", line, count));
  return lines;
}

/// Where a mesh is, whatever its order: sums are made of sorted numbers.
std::string position_lines(const Mesh& mesh) {
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Point& point : mesh.positions()) values.push_back(point[axis]);
    if (values.empty()) return text;
    std::sort(values.begin(), values.end());
    double sum = 0;
    for (const double value : values) sum += value;
    const double mean = sum / static_cast<double>(values.size());
    const bool is_noise = std::abs(mean) < kNoise * (values.back() - values.front());
    text += fmt::format("{} from {:.6g} to {:.6g}, mean {:.9g}\n", "xyz"[axis], values.front(), values.back(),
                        is_noise ? 0.0 : mean);
  }
  return text;
}

/// The same for the same mesh in any order; a line changes where something did.
std::string as_lines(const MeshFile& file) {
  const CheckReport report = check(file.mesh, 0);
  std::string text =
      fmt::format("vertices {}\nedges {}\nfaces {}\nquads {}\ntriangles {}\nlarger faces {}\n", report.vertices,
                  report.edges, report.faces, report.quads, report.triangles, report.larger);
  text += fmt::format("components {}\nboundary loops {}\nextraordinary vertices {}\n", report.components.size(),
                      report.boundary_loops, report.extraordinary);
  for (const std::string& line : component_lines(report)) text += line + "\n";
  text += position_lines(file.mesh);
  return text + fmt::format("connectivity {}\n", connectivity_hash(file.mesh).oriented.hex());
}

}  // namespace

int run_git_diff(const DiffArguments& arguments) {
  if (arguments.git.size() == 1) {
    return print(fmt::format("quadmatch diff {}\nnot merged yet\n", arguments.git[0])) ? kSame : kTrouble;
  }
  if (arguments.git.size() != 7 && arguments.git.size() != 9) {
    complain("--git is for git to call, with a path and two files; see quadmatch diff --help");
    return kTrouble;
  }
  const GitArguments git = parse(arguments.git);
  const Expected<MeshFile> source = read_mesh(git.old_file), target = read_mesh(git.new_file);
  if (git.old_file == kNoFile || git.new_file == kNoFile) {
    const std::string text =
        git.old_file == kNoFile ? describe_whole("new file", target) : describe_whole("deleted file", source);
    return print_lines(arguments, git, text) ? kSame : kTrouble;
  }
  if (!source || !target) {
    const std::string text = fmt::format("the {} file cannot be compared: {}\n", source ? "new" : "old",
                                         describe(source ? target.error() : source.error()));
    return print_lines(arguments, git, text) ? kSame : kTrouble;
  }
  Progress progress(false);
  std::optional<DiffSummary> summary = compare(arguments, *source, *target, 0, progress);
  if (!summary) return kTrouble;
  summary->source = "a/" + git.path;
  summary->target = "b/" + git.new_path;
  const std::string text = arguments.json ? as_json(*summary) : arguments.stat ? as_stat(*summary) : as_text(*summary);
  return print_lines(arguments, git, text) ? kSame : kTrouble;
}

int run_textconv(const DiffArguments& arguments) {
  const Expected<MeshFile> file = read_mesh(arguments.textconv);
  return print(file ? as_lines(*file) : fmt::format("no mesh: {}\n", describe(file.error()))) ? kSame : kTrouble;
}

}  // namespace quadmatch::cli
