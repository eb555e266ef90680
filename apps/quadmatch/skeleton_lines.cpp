#include "skeleton_lines.hpp"

#include <iterator>
#include <vector>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::cli {
namespace {

/// The vertices along an arc, both ends included.
std::vector<VertexId> vertices_along(const Mesh& mesh, const Spoke& spoke) {
  std::vector<VertexId> vertices{tail_of(mesh, spoke.start)};
  Dart dart = spoke.start;
  for (std::uint32_t step = 1; step < spoke.length; ++step) {
    vertices.push_back(head_of(mesh, dart));
    dart = straight_ahead(mesh, dart);
  }
  vertices.push_back(head_of(mesh, dart));
  return vertices;
}

}  // namespace

std::string lines_of(const Mesh& mesh, const ArcGraph& graph) {
  std::string points;
  std::string lines;
  PerVertex<std::uint32_t> number(mesh.vertex_count(), 0);  // of its v record, from 1
  std::uint32_t used = 0;
  for (std::uint32_t index = 0; index < graph.spokes.size(); ++index) {
    const Spoke& spoke = graph.spokes[index];
    if (spoke.to_spoke != Spoke::kNone && spoke.to_spoke < index) continue;  // drawn from its other end
    lines += 'l';
    for (const VertexId v : vertices_along(mesh, spoke)) {
      if (number[v] == 0) {
        number[v] = ++used;
        const Point& point = mesh.positions()[v.value];
        fmt::format_to(std::back_inserter(points), "v {} {} {}\n", point[0], point[1], point[2]);
      }
      fmt::format_to(std::back_inserter(lines), " {}", number[v]);
    }
    lines += '\n';
  }
  return points + lines;
}

}  // namespace quadmatch::cli
