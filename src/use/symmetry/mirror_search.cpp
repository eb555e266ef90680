#include "mirror_search.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "mirror_plane.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kRounds = 8;
/// Faces grown at most, by those of the component, and beside that for the smallest.
constexpr std::size_t kBudget = 48, kLeastBudget = 1 << 16;
/// Germs of one round of colours.
constexpr std::size_t kMostGerms = 192;
/// Mirrors of fewer faces than this share of the largest are others' fragments.
constexpr double kLeastShare = 0.9;

/// Mixes a number well, so that sums of such numbers tell sets apart.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 31)) * 0x7fb5d329728ea185U;
  x = (x ^ (x >> 27)) * 0x81dadef4bc2dd44dU;
  return x ^ (x >> 33);
}

/// Of a plane, as modellers expect it: x first, then y and z, then what lies askew.
std::uint32_t unusualness(const std::optional<MirrorPlane>& plane) {
  if (!plane) return 4;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    if (plane->normal[axis] > 0.99) return axis;
  }
  return 3;
}

/// By what the right mirror is told from others, before anything that depends on the numbering. A plane says most; of a
/// posed model it says next to nothing, and what counts is how far the mirror reaches.
auto rank(const Mirror& mirror, std::uint32_t most) {
  const double off = mirror.plane ? mirror.plane->error : 0;
  const bool fits = off < kPlaneFits;
  const double lost = fits ? 0 : 1 - static_cast<double>(mirror.faces) / most;
  return std::make_tuple(mirror.line_length == 0, !fits, std::lround(lost * 50), std::lround(std::min(off, 1.0) * 200),
                         std::lround(std::min(mirror.misfit, 10.0) * 100), unusualness(mirror.plane));
}

}  // namespace

MirrorSearch::MirrorSearch(const Mesh& mesh, const PerFan<VertexCode>& codes, const Components& components, double edge)
    : mesh_(mesh),
      codes_(codes),
      components_(components),
      edge_(edge),
      turned_(mesh.mirrored()),
      turned_codes_(vertex_codes(turned_)),
      spokes_(trace_separatrices(mesh, codes)),
      turned_spokes_(trace_separatrices(turned_, turned_codes_)),
      map_(mesh, codes) {
  const ColouringOptions options{.arc_lengths = true};
  colours_ = quadmatch::colour_spokes(spokes_, codes_, kRounds, options);
  turned_colours_ = quadmatch::colour_spokes(turned_spokes_, turned_codes_, kRounds, options);
}

/// The spokes of a component, by colour.
std::vector<MirrorSearch::Coloured> MirrorSearch::spokes_in(std::uint32_t component, std::uint32_t round,
                                                            bool opposite) const {
  const ArcGraph& graph = opposite ? turned_spokes_ : spokes_;
  const std::vector<Colour>& colours = (opposite ? turned_colours_ : colours_).rounds[round];
  std::vector<Coloured> result;
  for (std::uint32_t k = 0; k < graph.spokes.size(); ++k) {
    const Dart dart = graph.spokes[k].start;
    const FaceId face = mesh_.face(dart.halfedge);  // faces and first half-edges are the same in the mirror image
    if (components_.of_face[face] != component) continue;
    HalfedgeId start = dart.halfedge;
    if (opposite) {
      // There corner k is corner n - 1 - k, so the half-edge along this edge begins a corner before.
      const std::uint32_t corner = mesh_.size(face) - 1 - mesh_.corner(start);
      start = mesh_.prev(HalfedgeId(mesh_.first(face).value + corner));
    }
    result.push_back({colours[k], start, dart.backward});
  }
  std::sort(result.begin(), result.end(), [](const Coloured& a, const Coloured& b) {
    return std::tie(a.colour, a.start, a.backward) < std::tie(b.colour, b.start, b.backward);
  });
  return result;
}

/// Each exact mirror of the component comes from exactly one of these.
std::vector<Germ> MirrorSearch::exact_germs(std::uint32_t component) {
  const std::vector<Coloured> here = spokes_in(component, kRounds, false);
  std::vector<Germ> germs;
  if (here.empty()) {  // nothing stands out: any half-edge, on each of the component
    HalfedgeId first;
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      if (components_.of_face[mesh_.face(HalfedgeId(h))] != component) continue;
      if (!first.valid()) first = HalfedgeId(h);
      germs.push_back({first, HalfedgeId(h)});
    }
    return germs;
  }
  std::size_t rarest = 0, fewest = here.size() + 1;
  for (std::size_t k = 0, end = 0; k < here.size(); k = end) {
    while (end < here.size() && here[end].colour == here[k].colour) ++end;
    if (end - k < fewest) {
      fewest = end - k;
      rarest = k;
    }
  }
  for (const Coloured& there : spokes_in(component, kRounds, true)) {
    if (there.colour != here[rarest].colour || there.backward != here[rarest].backward) continue;
    germs.push_back({here[rarest].start, there.start});
  }
  return germs;
}

/// Places that look alike within so many arcs, the rarest looks first; of each look one place, on all others.
std::vector<Germ> MirrorSearch::likely_germs(std::uint32_t component) const {
  std::vector<Germ> germs;
  for (const std::uint32_t round : {kRounds, 5U, 3U, 2U, 1U, 0U}) {
    const std::vector<Coloured> here = spokes_in(component, round, false), there = spokes_in(component, round, true);
    struct Look {
      std::size_t places, first, begin, end;  // first of `here`, and those of `there`
    };
    std::vector<Look> looks;
    for (std::size_t k = 0, end = 0, begin = 0; k < here.size(); k = end) {
      while (end < here.size() && here[end].colour == here[k].colour) ++end;
      while (begin < there.size() && there[begin].colour < here[k].colour) ++begin;
      std::size_t last = begin;
      while (last < there.size() && there[last].colour == here[k].colour) ++last;
      if (last > begin) looks.push_back({(end - k) * (last - begin), k, begin, last});
    }
    std::stable_sort(looks.begin(), looks.end(), [](const Look& a, const Look& b) { return a.places < b.places; });
    const std::size_t most = germs.size() + kMostGerms;
    for (const Look& look : looks) {
      for (std::size_t k = look.begin; k < look.end && germs.size() < most; ++k) {
        if (here[look.first].backward == there[k].backward) germs.push_back({here[look.first].start, there[k].start});
      }
    }
  }
  return germs;
}

double MirrorSearch::length(HalfedgeId h) const {
  const Point& a = mesh_.positions()[mesh_.origin(h).value];
  const Point& b = mesh_.positions()[mesh_.tip(h).value];
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double MirrorSearch::misfit_of_map() const {
  if (edge_ <= 0) return 0;
  std::vector<double> differences;
  const std::size_t step = map_.laid().size() / 500 + 1;
  for (std::size_t k = 0; k < map_.laid().size(); k += step) {
    for (const HalfedgeId h : mesh_.halfedges(mesh_.face(map_.laid()[k].from))) {
      const double least = 1e-6 * edge_;
      differences.push_back(std::abs(std::log((length(h) + least) / (length(map_.image(h)) + least))));
    }
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

/// @return  nothing where it is a map that was found before, or not whole though only those are asked for
std::optional<Mirror> MirrorSearch::grown(Germ germ, std::uint32_t component, bool whole_only) {
  map_.clear();
  ++spent_;
  if (!map_.lay(germ, Fit::Looks)) return std::nullopt;
  if (whole_only) {  // what is no mirror is seen at the first conflict
    for (std::uint32_t most = 1; map_.conflicts() == 0; most *= 2) {
      const std::uint32_t before = map_.faces();
      map_.grow(Fit::Looks, most);
      if (map_.faces() == before && most > before) break;
    }
  } else {
    map_.grow(Fit::Looks);
  }
  spent_ += map_.faces();
  Mirror mirror;
  mirror.germ = germ;
  mirror.faces = map_.faces();
  mirror.whole = map_.conflicts() == 0 && mirror.faces == components_.face_count[component];
  if (whole_only && !mirror.whole) return std::nullopt;

  std::uint64_t signature = 0;
  std::vector<VertexPair> pairs;
  for (const Germ& laid : map_.laid()) {
    const FaceId face = mesh_.face(laid.from), partner = mesh_.face(laid.to);
    mirror.line_length += face == partner ? 1 : 0;
    signature += mixed((std::uint64_t{std::min(face, partner).value} << 32) | std::max(face, partner).value);
    for (const HalfedgeId h : mesh_.halfedges(face)) {
      mirror.line_length += mesh_.twin(h).valid() && map_.image(h) == mesh_.twin(h) ? 1 : 0;
      pairs.push_back({mesh_.origin(h), map_.image(mesh_.origin(h))});
    }
    const HalfedgeId first = mesh_.first(std::min(face, partner));
    signature += mixed((std::uint64_t{first.value} << 32) | map_.image(first).value);
  }
  if (std::find(signatures_.begin(), signatures_.end(), signature) != signatures_.end()) return std::nullopt;
  signatures_.push_back(signature);
  mirror.misfit = misfit_of_map();
  if (edge_ > 0) mirror.plane = fit_plane(mesh_, pairs);
  return mirror;
}

/// Where the budget may not last for all: first the germs that a plane x, y or z = constant would lay on each other.
void MirrorSearch::nearest_plane_first(std::vector<Germ>& germs) const {
  if (edge_ <= 0 || germs.size() < 2) return;
  const MirrorPlane plane = likely_plane(mesh_, edge_);
  std::vector<std::pair<double, std::size_t>> order;
  for (const Germ& germ : germs) {
    const auto off = [&](VertexId v, VertexId w) {
      const Point p = plane.mirrored(mesh_.positions()[v.value]);
      const Point& q = mesh_.positions()[w.value];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    };
    order.emplace_back(
        off(mesh_.origin(germ.from), mesh_.tip(germ.to)) + off(mesh_.tip(germ.from), mesh_.origin(germ.to)),
        order.size());
  }
  std::sort(order.begin(), order.end());
  std::vector<Germ> sorted;
  sorted.reserve(germs.size());
  for (const auto& [distance, k] : order) sorted.push_back(germs[k]);
  germs = std::move(sorted);
}

void MirrorSearch::try_germs(const std::vector<Germ>& germs, std::uint32_t component, bool whole_only,
                             MirrorsOfComponent& found) {
  const std::size_t budget = kBudget * components_.face_count[component] + kLeastBudget;
  spent_ = 0;
  signatures_.clear();
  for (const Germ& germ : germs) {
    if (spent_ > budget) {
      found.maybe_more = true;
      break;
    }
    if (std::optional<Mirror> mirror = grown(germ, component, whole_only)) found.mirrors.push_back(*mirror);
  }
  map_.clear();
}

MirrorsOfComponent MirrorSearch::mirrors_of(std::uint32_t component) {
  MirrorsOfComponent found;
  std::vector<Germ> germs = exact_germs(component);
  nearest_plane_first(germs);
  try_germs(germs, component, true, found);
  if (found.mirrors.empty()) {
    try_germs(likely_germs(component), component, false, found);
    found.maybe_more = true;
  }
  std::uint32_t most = 1;
  for (const Mirror& mirror : found.mirrors) most = std::max(most, mirror.faces);
  std::erase_if(found.mirrors, [&](const Mirror& mirror) { return mirror.faces < kLeastShare * most; });
  std::stable_sort(found.mirrors.begin(), found.mirrors.end(), [&](const Mirror& a, const Mirror& b) {
    const auto left = rank(a, most), right = rank(b, most);
    if (left != right) return left < right;
    return std::tie(b.faces, b.line_length) < std::tie(a.faces, a.line_length);
  });
  return found;
}

}  // namespace quadmatch::use
