#include "differences.hpp"

#include <algorithm>
#include <compare>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/components.hpp>

namespace quadmatch {
namespace {

using canonical::CanonicalForm;

/// How often each value was met.
using Counts = std::map<std::uint64_t, std::size_t>;

/// What is counted: "component" and "components", and how one of a value is called: " of 6 faces".
struct Noun {
  const char* one;
  const char* several;
};

/// "12 components", "1 component", "no component".
std::string counted(std::size_t count, const Noun& noun) {
  if (count == 0) return fmt::format("no {}", noun.one);
  return fmt::format("{} {}", count, count == 1 ? noun.one : noun.several);
}

class Comparison {
 public:
  void add(const Noun& noun, std::size_t source, std::size_t target, const std::string& kind = {}) {
    if (source == target) return;
    differences_.push_back(fmt::format("the source has {}{}, the target {}", counted(source, noun), kind,
                                       target == 0 ? "none" : fmt::format("{}", target)));
  }

  /// The first three values that are met more often in one mesh.
  template <class Describe>
  void add(const Noun& noun, const Counts& source, const Counts& target, Describe describe) {
    constexpr std::size_t kNamed = 3;
    Counts all = source;
    all.insert(target.begin(), target.end());
    std::size_t named = 0;
    for (const auto& [value, unused] : all) {
      const auto left = source.find(value), right = target.find(value);
      const std::size_t one = left == source.end() ? 0 : left->second;
      const std::size_t other = right == target.end() ? 0 : right->second;
      if (one == other) continue;
      if (named++ == kNamed) break;
      add(noun, one, other, describe(value));
    }
  }

  std::vector<std::string> take() { return std::move(differences_); }

 private:
  std::vector<std::string> differences_;
};

Counts component_sizes(const Mesh& mesh) {
  Counts counts;
  for (const std::uint32_t faces : connected_components(mesh).face_count) ++counts[faces];
  return counts;
}

Counts face_sizes(const Mesh& mesh) {
  Counts counts;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) ++counts[mesh.size(FaceId(f))];
  return counts;
}

std::size_t open_edges(const Mesh& mesh) {
  std::size_t open = 0;
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) open += mesh.twin(HalfedgeId(h)).valid() ? 0 : 1;
  return open;
}

Counts fan_codes(const Mesh& mesh) {
  Counts counts;
  for (const VertexCode code : vertex_codes(mesh)) ++counts[code.value];
  counts.erase(0);  // vertices that no face uses are counted by themselves
  return counts;
}

std::size_t unused_vertices(const Mesh& mesh) {
  std::size_t unused = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) unused += mesh.halfedge(FanId(v)).valid() ? 0 : 1;
  return unused;
}

std::string of_faces(std::uint64_t faces) { return fmt::format(" of {} face{}", faces, faces == 1 ? "" : "s"); }

std::string of_valence(std::uint64_t value) {
  const VertexCode code{static_cast<std::uint16_t>(value)};
  return fmt::format(" of valence {}{}{}", code.valence(), code.on_boundary() ? " on the boundary" : "",
                     code.touches_non_quad() ? " at a face that is no quad" : "");
}

/// Where clusters of one form stand in their mesh: those that are not in the other.
std::vector<const CanonicalForm::Cluster*> without_equal(const CanonicalForm& form, const CanonicalForm& other) {
  std::vector<const CanonicalForm::Cluster*> result;
  std::size_t there = 0;
  for (const CanonicalForm::Cluster& cluster : form.clusters) {
    while (there < other.clusters.size() && std::is_lt(compare(other, other.clusters[there], form, cluster))) ++there;
    if (there < other.clusters.size() && std::is_eq(compare(other, other.clusters[there], form, cluster))) {
      ++there;
    } else {
      result.push_back(&cluster);
    }
  }
  return result;
}

std::string named(const Mesh& mesh, const CanonicalForm& form, const CanonicalForm::Cluster& cluster) {
  FaceId first = mesh.face(form.faces_of(cluster).front());
  for (const HalfedgeId h : form.faces_of(cluster)) first = std::min(first, mesh.face(h));
  return fmt::format("the one of f{}, {} face{}", first.value, cluster.face_count, cluster.face_count == 1 ? "" : "s");
}

}  // namespace

std::vector<std::string> different_counts(const Mesh& source, const Mesh& target) {
  Comparison comparison;
  comparison.add({"vertex", "vertices"}, source.vertex_count(), target.vertex_count());
  comparison.add({"vertex", "vertices"}, unused_vertices(source), unused_vertices(target), " that no face uses");
  comparison.add({"face", "faces"}, source.face_count(), target.face_count());
  comparison.add({"face", "faces"}, face_sizes(source), face_sizes(target),
                 [](std::uint64_t corners) { return fmt::format(" of {} corners", corners); });
  const Counts left = component_sizes(source), right = component_sizes(target);
  comparison.add({"component", "components"}, left, right, of_faces);
  comparison.add({"seam", "seams"}, source.seams().size(), target.seams().size());
  comparison.add({"edge", "edges"}, open_edges(source), open_edges(target), " of one face, or cut at a seam");
  comparison.add({"vertex", "vertices"}, source.split_vertices().size(), target.split_vertices().size(),
                 " of several fans");
  comparison.add({"fan", "fans"}, fan_codes(source), fan_codes(target), of_valence);
  return comparison.take();
}

std::vector<std::string> different_parts(const Mesh& source, const CanonicalForm& left, const Mesh& target,
                                         const CanonicalForm& right) {
  const auto own = without_equal(left, right), others = without_equal(right, left);
  if (left.clusters.size() == 1) {
    return {"all counts agree, but no map keeps which faces share their vertices"};
  }
  return {fmt::format(
      "all counts agree, but {} of {} parts of the source have no equal in the target: the largest is {}; "
      "there it is {}",
      own.size(), left.clusters.size(), named(source, left, *own.back()), named(target, right, *others.back()))};
}

}  // namespace quadmatch
