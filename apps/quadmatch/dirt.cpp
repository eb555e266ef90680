#include "dirt.hpp"

#include <vector>

#include <fmt/format.h>

#include <quadmatch/mesh/check.hpp>

#include "text.hpp"

namespace quadmatch::cli {
namespace {

std::size_t unused_vertices(const Mesh& mesh) {
  std::size_t unused = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) unused += mesh.halfedge(FanId(v)).valid() ? 0 : 1;
  return unused;
}

}  // namespace

std::string describe_dirt(const Mesh& mesh, const std::string& work) {
  std::vector<std::string> counts;
  const auto add = [&counts](std::size_t count, const char* noun, const char* plural) {
    if (count > 0) counts.push_back(counted(count, noun, plural));
  };
  // Degenerate and duplicate faces leave seams or split vertices behind, so a mesh without either needs no closer look.
  if (!mesh.seams().empty() || !mesh.split_vertices().empty()) {
    const CheckReport report = check(mesh, 0);
    const auto found = [&report](DepartureKind kind) {
      return report.departure_counts[static_cast<std::size_t>(kind)];
    };
    add(found(DepartureKind::NonManifoldEdge), "non-manifold edge", "non-manifold edges");
    add(found(DepartureKind::DisconnectedVertex), "non-manifold vertex", "non-manifold vertices");
    add(found(DepartureKind::InconsistentWinding), "wrongly wound edge", "wrongly wound edges");
    add(found(DepartureKind::DegenerateFace), "degenerate face", "degenerate faces");
    add(found(DepartureKind::DuplicateFace), "duplicate face", "duplicate faces");
  }
  add(unused_vertices(mesh), "unused vertex", "unused vertices");
  if (counts.empty()) return {};
  return fmt::format("{}; {} goes on{}", joined(counts), work,
                     mesh.seams().empty() ? "" : ", faces are not adjacent across such edges");
}

}  // namespace quadmatch::cli
