#include "starts.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/spoke_colours.hpp>
#include <quadmatch/analysis/vertex_code.hpp>

namespace quadmatch::canonical {
namespace {

/// A half-edge and what it looks like.
struct Coloured {
  std::uint32_t cluster;
  bool backward;  ///< the spoke arrives along it
  Colour colour;
  HalfedgeId halfedge;

  [[nodiscard]] auto look() const { return std::tuple(cluster, colour, backward); }
  bool operator<(const Coloured& other) const {
    return std::pair(look(), halfedge) < std::pair(other.look(), other.halfedge);
  }
};

/// The looks of a cluster.
struct Looks {
  std::size_t halfedges = 0;          ///< that were looked at
  std::size_t count = 0;              ///< that are different
  std::size_t rarest = 0, times = 0;  ///< where the rarest stands, and how many half-edges look so
};

/// Sort half-edges by cluster and look. Of several rarest looks of a cluster the one that comes first counts.
std::vector<Looks> sort_by_look(std::vector<Coloured>& halfedges, std::uint32_t clusters) {
  std::sort(halfedges.begin(), halfedges.end());
  std::vector<Looks> all(clusters);
  for (std::size_t first = 0, last = 0; first < halfedges.size(); first = last) {
    while (last < halfedges.size() && halfedges[last].look() == halfedges[first].look()) ++last;
    Looks& looks = all[halfedges[first].cluster];
    looks.halfedges += last - first;
    if (looks.count++ > 0 && looks.times <= last - first) continue;
    looks.rarest = first;
    looks.times = last - first;
  }
  return all;
}

void add_rarest(std::vector<Coloured>& starts, const std::vector<Coloured>& halfedges, const Looks& looks) {
  const auto first = halfedges.begin() + static_cast<std::ptrdiff_t>(looks.rarest);
  starts.insert(starts.end(), first, first + static_cast<std::ptrdiff_t>(looks.times));
}

/// Colours spokes as far as it helps. How far that is, a cluster decides by itself: beside others it is the same.
class SpokeStarts {
 public:
  SpokeStarts(const Mesh& mesh, const Clusters& clusters)
      : mesh_(mesh),
        clusters_(clusters),
        codes_(vertex_codes(mesh)),
        arcs_(trace_separatrices(mesh, codes_)),
        colours_(initial_spoke_colours(arcs_, codes_)),
        corners_(clusters.size(), 0),
        is_open_(clusters.is_single),
        known_(clusters.size(), 0) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) corners_[clusters.of_face(FaceId(f))] += mesh.size(FaceId(f));
  }

  /// The starts of the single components that have spokes.
  std::vector<Coloured> find() {
    // What is rare shows early; a mesh that looks alike everywhere is not asked for more than it has.
    constexpr std::uint32_t kMostRounds = 64;
    settle(2);
    for (std::uint32_t rounds = 2; open_ > 0; rounds *= 2) {
      for (std::uint32_t more = rounds / 2; more > 0; --more) {
        colours_ = refine_spoke_colours(arcs_, codes_, colours_, {.arc_lengths = true});
      }
      settle(rounds < kMostRounds ? rounds : 0);
    }
    return std::move(starts_);
  }

 private:
  /// Take the starts of clusters of which more rounds promise little.
  /// @param more  rounds that would come next; 0: none, so take those of all.
  void settle(std::uint32_t more) {
    std::vector<Coloured> halfedges = coloured();
    const std::vector<Looks> looks = sort_by_look(halfedges, clusters_.size());
    open_ = 0;
    for (std::uint32_t cluster = 0; cluster < clusters_.size(); ++cluster) {
      const Looks& own = looks[cluster];
      if (own.count == 0) continue;
      is_open_[cluster] = own.times > 1 && own.count > known_[cluster] && !is_cheaper_to_try(cluster, own, more);
      known_[cluster] = own.count;
      if (is_open_[cluster]) {
        ++open_;
      } else {
        add_rarest(starts_, halfedges, own);
      }
    }
  }

  /// Starts that are no symmetry are given up early; of those that are, so many are written to their end as the number
  /// of symmetries has bits.
  [[nodiscard]] bool is_cheaper_to_try(std::uint32_t cluster, const Looks& looks, std::uint32_t more) const {
    return std::uint64_t(std::bit_width(looks.times)) * corners_[cluster] <= std::uint64_t{more} * looks.halfedges ||
           more == 0;
  }

  [[nodiscard]] std::vector<Coloured> coloured() const {
    std::vector<Coloured> halfedges;
    halfedges.reserve(arcs_.spokes.size());
    for (std::size_t spoke = 0; spoke < arcs_.spokes.size(); ++spoke) {
      const Dart start = arcs_.spokes[spoke].start;
      const std::uint32_t cluster = clusters_.of_face(mesh_.face(start.halfedge));
      if (is_open_[cluster]) halfedges.push_back({cluster, start.backward, colours_[spoke], start.halfedge});
    }
    return halfedges;
  }

  const Mesh& mesh_;
  const Clusters& clusters_;
  PerFan<VertexCode> codes_;
  ArcGraph arcs_;
  std::vector<Colour> colours_;
  std::vector<std::uint32_t> corners_;  // of each cluster
  std::vector<Coloured> starts_;
  std::vector<bool> is_open_;       // clusters whose starts are still sought
  std::vector<std::size_t> known_;  // looks of each when last asked
  std::size_t open_ = 0;
};

/// The rarer of open half-edges and all others, for the single components that have none among `starts`.
void add_regular(const Mesh& mesh, const Clusters& clusters, std::vector<Coloured>& starts) {
  std::vector<bool> is_regular = clusters.is_single;
  for (const Coloured& start : starts) is_regular[start.cluster] = false;
  if (std::none_of(is_regular.begin(), is_regular.end(), [](bool regular) { return regular; })) return;
  std::vector<Coloured> halfedges;
  for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    const std::uint32_t cluster = clusters.of_face(mesh.face(h));
    if (is_regular[cluster]) halfedges.push_back({cluster, false, mesh.twin(h).valid() ? Colour{1} : Colour{0}, h});
  }
  for (const Looks& looks : sort_by_look(halfedges, clusters.size())) add_rarest(starts, halfedges, looks);
}

}  // namespace

Starts starts_of(const Mesh& mesh, const Clusters& clusters) {
  std::vector<Coloured> starts = SpokeStarts(mesh, clusters).find();
  add_regular(mesh, clusters, starts);
  std::sort(starts.begin(), starts.end());
  Starts result;
  result.first.assign(clusters.size() + 1, 0);
  for (const Coloured& start : starts) {
    ++result.first[start.cluster + 1];
    result.halfedges.push_back(start.halfedge);
  }
  for (std::uint32_t cluster = 0; cluster < clusters.size(); ++cluster) {
    result.first[cluster + 1] += result.first[cluster];
  }
  return result;
}

}  // namespace quadmatch::canonical
