#include "canonical_form.hpp"

#include <algorithm>
#include <compare>
#include <optional>
#include <utility>

#include "clusters.hpp"
#include "starts.hpp"
#include "tied_search.hpp"
#include "writer.hpp"

namespace quadmatch::canonical {
namespace {

using Cluster = CanonicalForm::Cluster;

/// Makes the forms of clusters, in any order.
class FormMaker {
 public:
  explicit FormMaker(const Mesh& mesh)
      : mesh_(mesh), clusters_(clusters_of(mesh)), starts_(starts_of(mesh, clusters_)), writer_(mesh) {
    form_.faces.reserve(mesh.face_count());
    form_.numbers.reserve(std::size_t{mesh.face_count()} + mesh.halfedge_count());
  }

  CanonicalForm make() && {
    for (std::uint32_t cluster = 0; cluster < clusters_.size(); ++cluster) {
      if (is_written_at_once(cluster)) {
        LeastWriting least = writer_.write(starts_.of(cluster));
        add(least.writing.faces, least.writing.numbers).multiply(least.symmetries);
      } else {
        TiedOrder tied = search(cluster);
        add(tied.faces, writer_.numbers_of(tied.faces)) = std::move(tied.symmetries);
      }
    }
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      form_.unused_vertices += mesh_.halfedge(FanId(v)).valid() ? 0 : 1;
    }
    return std::move(form_);
  }

 private:
  /// A component whose starts do not see how it touches itself may have to be written from many of them to its end. The
  /// search sees that first; it costs more where there are few.
  [[nodiscard]] bool is_written_at_once(std::uint32_t cluster) const {
    constexpr std::size_t kFew = 64;
    return clusters_.is_clean[cluster] || (clusters_.is_single[cluster] && starts_.of(cluster).size() <= kFew);
  }

  TiedOrder search(std::uint32_t cluster) {
    if (!search_) {
      search_.emplace(mesh_, writer_);
      faces_by_cluster_.resize(clusters_.size());
      for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
        faces_by_cluster_[clusters_.of_face(FaceId(f))].push_back(FaceId(f));
      }
    }
    return search_->order(faces_by_cluster_[cluster]);
  }

  GroupOrder& add(std::span<const HalfedgeId> faces, std::span<const std::uint32_t> numbers) {
    form_.clusters.push_back({static_cast<std::uint32_t>(form_.faces.size()),
                              static_cast<std::uint32_t>(faces.size()),
                              form_.numbers.size(),
                              numbers.size(),
                              {}});
    form_.faces.insert(form_.faces.end(), faces.begin(), faces.end());
    form_.numbers.insert(form_.numbers.end(), numbers.begin(), numbers.end());
    return form_.clusters.back().symmetries;
  }

  const Mesh& mesh_;
  Clusters clusters_;
  Starts starts_;
  Writer writer_;
  std::optional<TiedSearch> search_;  // made where it is needed
  std::vector<std::vector<FaceId>> faces_by_cluster_;
  CanonicalForm form_;
};

}  // namespace

std::strong_ordering compare(const CanonicalForm& one, const Cluster& cluster, const CanonicalForm& other,
                             const Cluster& other_cluster) {
  if (cluster.face_count != other_cluster.face_count) return cluster.face_count <=> other_cluster.face_count;
  const auto left = one.numbers_of(cluster), right = other.numbers_of(other_cluster);
  return std::lexicographical_compare_three_way(left.begin(), left.end(), right.begin(), right.end());
}

CanonicalForm canonical_form(const Mesh& mesh) {
  CanonicalForm form = FormMaker(mesh).make();
  std::stable_sort(form.clusters.begin(), form.clusters.end(),
                   [&form](const Cluster& a, const Cluster& b) { return std::is_lt(compare(form, a, form, b)); });
  return form;
}

bool is_same(const CanonicalForm& one, const CanonicalForm& other) {
  return one.unused_vertices == other.unused_vertices &&
         std::equal(one.clusters.begin(), one.clusters.end(), other.clusters.begin(), other.clusters.end(),
                    [&](const Cluster& a, const Cluster& b) { return std::is_eq(compare(one, a, other, b)); });
}

GroupOrder symmetries_of(const CanonicalForm& form) {
  GroupOrder order;
  for (std::size_t first = 0, last = 0; first < form.clusters.size(); first = last) {
    const Cluster& cluster = form.clusters[first];
    while (last < form.clusters.size() && std::is_eq(compare(form, cluster, form, form.clusters[last]))) ++last;
    order.multiply_by_factorial(last - first);
    order.multiply(cluster.symmetries, last - first);
  }
  return order;
}

}  // namespace quadmatch::canonical
