// quadmatch skeleton A...: the graph that particles trace from extraordinary vertices (§4.3), as a row of Table 5.1.

#include <fmt/format.h>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/io/file.hpp>

#include "command.hpp"
#include "console.hpp"
#include "dirt.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "skeleton_lines.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter = R"(From every extraordinary vertex a particle runs along each edge, straight on through
regular vertices, until it meets an extraordinary vertex or the boundary. The skeleton's
vertices are the extraordinary ones, crossings of two tracks, and where a particle ran
into the boundary. Reduction is the share of vertices that the skeleton does without.

Examples:
  quadmatch skeleton *.obj
  quadmatch skeleton bear.obj -o bear_skeleton.obj
  quadmatch skeleton bear.obj --separatrices --json

Exit status: 0, or 2 trouble.)";

struct SkeletonArguments {
  std::vector<std::string> meshes;
  std::string output;
  bool separatrices = false;
  bool json = false;
  bool quiet = false;
};

/// A row of Table 5.1.
struct SkeletonReport {
  std::string path;
  std::uint32_t vertices = 0;  ///< that faces use
  std::uint32_t edges = 0;     ///< distinct pairs of vertices
  std::uint32_t nodes = 0, arcs = 0;

  /// In percent.
  [[nodiscard]] double reduction() const {
    return vertices == 0 ? 0.0 : 100.0 * (1.0 - static_cast<double>(nodes) / vertices);
  }
};

std::uint32_t used_vertices(const Mesh& mesh) {
  std::uint32_t used = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) used += mesh.halfedge(FanId(v)).valid() ? 1 : 0;
  return used;
}

/// A seam counts once, however many faces it has; a side that joins a vertex to itself is no edge.
std::uint32_t distinct_edges(const Mesh& mesh) {
  std::uint32_t edges = mesh.edge_count();
  for (const Seam& seam : mesh.seams()) edges -= seam.kind == SeamKind::Degenerate ? 1 : seam.uses - 1;
  return edges;
}

std::string as_text(const std::vector<SkeletonReport>& reports, bool separatrices) {
  const std::string graph = separatrices ? "separatrix" : "skeleton";
  std::vector<std::vector<std::string>> rows{
      {"model", "vertices", "edges", graph + " vertices", graph + " edges", "reduction"}};
  for (const SkeletonReport& report : reports) {
    rows.push_back({display_name(report.path), std::to_string(report.vertices), std::to_string(report.edges),
                    std::to_string(report.nodes), std::to_string(report.arcs),
                    fmt::format("{:.1f} %", report.reduction())});
  }
  return table(rows);
}

std::string as_json(const std::vector<SkeletonReport>& reports, bool separatrices) {
  Json list = Json::array();
  for (const SkeletonReport& report : reports) {
    list.push_back({{"path", report.path},
                    {"graph", separatrices ? "separatrices" : "skeleton"},
                    {"vertices", report.vertices},
                    {"edges", report.edges},
                    {"graph_vertices", report.nodes},
                    {"graph_edges", report.arcs},
                    {"reduction_percent", report.reduction()}});
  }
  return json_text(list);
}

Expected<void> export_lines(const std::string& output, const MeshFile& file, const ArcGraph& graph) {
  if (file.mesh.positions().empty()) {
    return Unexpected(Error{ErrorCode::BadArgument, "the mesh has no positions to draw lines through; leave -o away",
                            display_name(file.path)});
  }
  return replace_file(output, lines_of(file.mesh, graph));
}

/// Read, trace, and export where asked.
std::optional<SkeletonReport> examine(const std::string& path, const SkeletonArguments& arguments) {
  const std::optional<MeshFile> file = read_input(path, !arguments.quiet);
  if (!file) return std::nullopt;
  if (!arguments.quiet) {
    const std::string dirt = describe_dirt(file->mesh, "tracing");
    if (!dirt.empty()) warn(fmt::format("{}: {}", display_name(path), dirt));
  }
  const Tracing tracing = trace_skeleton(file->mesh, vertex_codes(file->mesh));
  const ArcGraph& graph = arguments.separatrices ? tracing.separatrices : tracing.skeleton;
  if (!arguments.output.empty()) {
    if (Expected<void> written = export_lines(arguments.output, *file, graph); !written) {
      complain(written.error());
      return std::nullopt;
    }
  }
  return SkeletonReport{path, used_vertices(file->mesh), distinct_edges(file->mesh), graph.node_count(),
                        graph.arc_count()};
}

int run_skeleton(const SkeletonArguments& arguments) {
  if (!paths_fit(arguments.meshes, arguments.output)) return kTrouble;
  if (!arguments.output.empty() && arguments.meshes.size() > 1) {
    complain("-o takes the lines of one mesh; name only one, or leave -o away");
    return kTrouble;
  }
  int status = kSame;
  std::vector<SkeletonReport> reports;
  for (const std::string& path : arguments.meshes) {
    if (std::optional<SkeletonReport> report = examine(path, arguments)) {
      reports.push_back(*std::move(report));
    } else {
      status = kTrouble;  // the others are traced all the same
    }
  }
  const bool lines_on_output = arguments.output == "-";
  if (arguments.json && !lines_on_output) return print(as_json(reports, arguments.separatrices)) ? status : kTrouble;
  if (arguments.quiet || reports.empty()) return status;
  const std::string text = as_text(reports, arguments.separatrices);
  if (lines_on_output) {
    fmt::print(stderr, "{}", text);
    return status;
  }
  return print(text) ? status : kTrouble;
}

}  // namespace

void add_skeleton_command(CLI::App& program, Action& chosen) {
  SkeletonArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "skeleton", "Print the size of the skeleton graph, or export its lines",
                                  arguments, run_skeleton, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->meshes, "Meshes; - reads standard input")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->output, "OBJ file of lines to write, for one mesh; - is standard output")
      ->type_name("FILE");
  verb->add_flag("--separatrices", arguments->separatrices,
                 "The graph of extraordinary vertices only, whose edges pass through crossings");
  verb->add_flag("--json", arguments->json, "Print the figures as JSON, one object for each mesh");
  verb->add_flag("--quiet", arguments->quiet, "Print neither table nor warnings");
}

}  // namespace quadmatch::cli
