#include "equal_parts.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace quadmatch::regions {
namespace {

/// Faces grown at most while the maps of one part are tried: by its faces, and beside that for the smallest.
constexpr std::size_t kBudget = 24, kLeastBudget = 1 << 16;
/// Maps of one part that are tried at most.
constexpr std::size_t kMostWays = 64;

/// Mixes a number well, so that sums of such numbers tell multisets apart.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 31)) * 0x7fb5d329728ea185U;
  x = (x ^ (x >> 27)) * 0x81dadef4bc2dd44dU;
  return x ^ (x >> 33);
}

/// Is the nearest much nearer than the next, and that farther than any error? By squares of distances.
bool is_clear(std::vector<double> distances, double error) {
  if (distances.size() < 2) return true;
  std::partial_sort(distances.begin(), distances.begin() + 2, distances.end());
  return std::max(4 * distances[0], 16 * error * error) < distances[1];
}

/// The first bits of all colours of the last round: what is not here is nowhere in that mesh.
class ColourFilter {
 public:
  explicit ColourFilter(const std::vector<Colour>& colours)
      : shift_(60 - static_cast<int>(std::bit_width(colours.size()))), has_(std::size_t{1} << (64 - shift_), false) {
    for (const Colour colour : colours) has_[colour >> shift_] = true;
  }
  [[nodiscard]] bool may_have(Colour colour) const { return has_[colour >> shift_]; }

 private:
  int shift_;
  std::vector<bool> has_;
};

}  // namespace

/// Is there a part all of whose colours the target may have? An edit changes colours from one end of a part to the
/// other.
bool EqualParts::any_may_have_equal(const std::vector<Part>& parts, const ColouredSpokes& colours) {
  const ColourFilter target(colours.target.rounds.back());
  return std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
    return std::all_of(part.spokes.begin(), part.spokes.end(),
                       [&](std::uint32_t spoke) { return target.may_have(colours.source.rounds.back()[spoke]); });
  });
}

std::vector<EqualParts::Part> EqualParts::parts_of(const Side& side, const SpokeColours& colours,
                                                   const Components& components) {
  std::vector<Part> parts(components.face_count.size());
  for (std::uint32_t f = 0; f < side.mesh.face_count(); ++f) {
    Part& part = parts[components.of_face[FaceId(f)]];
    if (part.faces++ == 0) part.first_face = FaceId(f);
    std::uint64_t open = 0;
    for (const HalfedgeId h : side.mesh.halfedges(FaceId(f))) open += !side.mesh.twin(h).valid();
    part.signature += mixed(std::uint64_t{64} * side.mesh.size(FaceId(f)) + open);
  }
  for (std::uint32_t spoke = 0; spoke < side.separatrices.spokes.size(); ++spoke) {
    const HalfedgeId start = side.separatrices.spokes[spoke].start.halfedge;
    Part& part = parts[components.of_face[side.mesh.face(start)]];
    part.signature += mixed(colours.rounds.back()[spoke]);
    part.spokes.push_back(spoke);
  }
  return parts;
}

/// The middle of a part's corners. O(its faces).
Point EqualParts::middle_of(const Mesh& mesh, const Part& part) {
  Point sum = {0, 0, 0};
  double corners = 0;
  std::vector<FaceId> faces{part.first_face};
  std::unordered_set<std::uint32_t> seen{part.first_face.value};
  for (std::size_t here = 0; here < faces.size(); ++here) {
    for (const HalfedgeId h : mesh.halfedges(faces[here])) {
      const Point& p = mesh.positions()[mesh.origin(h).value];
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += p[axis];
      corners += 1;
      const HalfedgeId beside = mesh.twin(h);
      if (beside.valid() && seen.insert(mesh.face(beside).value).second) faces.push_back(mesh.face(beside));
    }
  }
  for (double& number : sum) number /= corners;
  return sum;
}

EqualParts::EqualParts(Workbench& bench, const ColouredSpokes& colours)
    : bench_(bench), colours_(colours), map_(bench.sides) {
  const Components components = connected_components(bench.sides.source.mesh);
  source_parts_ = parts_of(bench.sides.source, colours.source, components);
  if (!any_may_have_equal(source_parts_, colours)) return;
  // What equals a part of all the source's faces is all of a target of as many: whether that too is connected, the map
  // will tell.
  const Mesh& target = bench.sides.target.mesh;
  const bool is_one = source_parts_.size() == 1 && target.face_count() == source_parts_.front().faces;
  target_parts_ = parts_of(bench.sides.target, colours.target,
                           is_one ? Components{PerFace<std::uint32_t>(target.face_count(), 0), {target.face_count()}}
                                  : connected_components(target));
  using Entry = std::tuple<std::uint64_t, std::uint32_t, std::uint32_t>;  // signature, faces, part
  const auto sorted = [](const std::vector<Part>& parts) {
    std::vector<Entry> entries;
    for (std::uint32_t k = 0; k < parts.size(); ++k) entries.emplace_back(parts[k].signature, parts[k].faces, k);
    std::sort(entries.begin(), entries.end());
    return entries;
  };
  const std::vector<Entry> left = sorted(source_parts_), right = sorted(target_parts_);
  const auto same = [](const Entry& a, const Entry& b) {
    return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
  };
  for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
    if (!same(left[i], right[j])) {
      ++(left[i] < right[j] ? i : j);
      continue;
    }
    Class equal;
    const Entry first = left[i];
    for (; i < left.size() && same(left[i], first); ++i) equal.source.push_back(std::get<2>(left[i]));
    for (; j < right.size() && same(right[j], first); ++j) equal.target.push_back(std::get<2>(right[j]));
    classes_.push_back(std::move(equal));
  }
  // The largest first: they say most about where the rest lies.
  std::stable_sort(classes_.begin(), classes_.end(), [&](const Class& a, const Class& b) {
    return source_parts_[a.source.front()].faces > source_parts_[b.source.front()].faces;
  });
}

/// Where a map of the part may begin: a spoke of the rarest colour, on each that is like it. Without any, an arbitrary
/// half-edge, on each of the other part.
std::vector<Candidate> EqualParts::seeds(const Part& part, const Part& other) const {
  const Side& source = bench_.sides.source;
  const Side& target = bench_.sides.target;
  std::vector<Candidate> result;
  if (part.spokes.empty()) {
    const HalfedgeId s = source.mesh.first(part.first_face);
    std::vector<FaceId> faces{other.first_face};
    PerFace<bool> listed(target.mesh.face_count(), false);
    listed[other.first_face] = true;
    for (std::size_t here = 0; here < faces.size(); ++here) {
      for (const HalfedgeId t : target.mesh.halfedges(faces[here])) {
        result.push_back({s, t});
        const HalfedgeId beside = target.mesh.twin(t);
        if (!beside.valid() || listed[target.mesh.face(beside)]) continue;
        listed[target.mesh.face(beside)] = true;
        faces.push_back(target.mesh.face(beside));
      }
    }
    return result;
  }
  const std::vector<Colour>& colours = colours_.source.rounds.back();
  std::vector<std::pair<Colour, std::uint32_t>> sorted;
  for (const std::uint32_t spoke : part.spokes) sorted.emplace_back(colours[spoke], spoke);
  std::sort(sorted.begin(), sorted.end());
  std::size_t rarest = 0, fewest = sorted.size() + 1;
  for (std::size_t k = 0; k < sorted.size();) {
    std::size_t end = k;
    while (end < sorted.size() && sorted[end].first == sorted[k].first) ++end;
    if (end - k < fewest) {
      fewest = end - k;
      rarest = k;
    }
    k = end;
  }
  const Dart start = source.separatrices.spokes[sorted[rarest].second].start;
  for (const std::uint32_t spoke : other.spokes) {
    const Dart end = target.separatrices.spokes[spoke].start;
    const bool alike = colours_.target.rounds.back()[spoke] == sorted[rarest].first;
    if (alike && start.backward == end.backward) result.push_back({start.halfedge, end.halfedge});
  }
  return result;
}

/// Does the map that begins here cover the part with all corners agreeing, and is all of it still free?
bool EqualParts::fills(Candidate seed, const Part& part) {
  const bool fills = map_.grow(seed, part.faces);
  spent_ += 16 + map_.pairs().size();
  const Patchwork& patchwork = bench_.patchwork;
  return fills &&
         (patchwork.matched_faces() == 0 || std::all_of(map_.pairs().begin(), map_.pairs().end(), [&](Candidate pair) {
            return !patchwork.is_matched(bench_.sides.source.mesh.face(pair.source)) &&
                   !patchwork.is_taken(bench_.sides.target.mesh.face(pair.target));
          }));
}

/// How well lengths, and where the model as a whole is placed also distances, like the latest map; 0 where they do not
/// matter.
double EqualParts::worth_of_map() const {
  double sum = 0;
  for (const Candidate& pair : map_.pairs()) {
    if (bench_.misfit.uses_lengths()) sum -= std::min(10.0, bench_.misfit.length_error(pair));
    if (bench_.misfit.is_placed()) sum -= std::min(10.0, bench_.misfit.distance(pair));
  }
  return sum / static_cast<double>(map_.pairs().size());
}

/// How far the latest map brings corners from where the part's surroundings would have them, in sizes of the part: the
/// last resort for what lengths do not tell.
double EqualParts::drift_of_map(const Point& middle) const {
  if (!here_ || bench_.misfit.is_placed()) return 0;
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  double off = 0, size = 1e-30;
  for (const Candidate& pair : map_.pairs()) {
    const Point& here = source.positions()[source.origin(pair.source).value];
    off += std::sqrt(squared_distance(here_->similarity(here), target.positions()[target.origin(pair.target).value]));
    size += std::sqrt(squared_distance(here, middle)) * here_->similarity.scale();
  }
  return std::min(2.0, off / size);
}

/// Positions are looked at where there is a choice, and only then.
void EqualParts::look_at_positions() {
  if (looked_) return;
  looked_ = true;
  if (bench_.patchwork.matched_faces() > 0) {
    bench_.misfit.calibrate(bench_.patchwork);
  } else {
    bench_.misfit.assume();
  }
  place(bench_);
}

void EqualParts::nearest_first(std::vector<Candidate>& places) const {
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (const auto& [s, t] : places) {
    const auto distance = [&](VertexId v, VertexId w) {
      return std::sqrt(squared_distance(here_->similarity(source.positions()[v.value]), target.positions()[w.value]));
    };
    by_distance.emplace_back(distance(source.origin(s), target.origin(t)) + distance(source.tip(s), target.tip(t)),
                             by_distance.size());
  }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<Candidate> sorted;
  sorted.reserve(places.size());
  for (const auto& [distance, place] : by_distance) sorted.push_back(places[place]);
  places = std::move(sorted);
}

EqualParts::Laying EqualParts::best_laying(const Part& part, const Part& other) {
  constexpr double kClear = 0.01, kDrift = 0.3;
  const std::size_t budget = kBudget * part.faces + kLeastBudget;
  spent_ = 0;
  Laying laying;
  double most = 0, chosen = 0;
  std::vector<double> worths;
  std::vector<Candidate> places = seeds(part, other);
  here_.reset();
  if (places.size() > 1) {
    look_at_positions();
    here_ = placement_of(part);
    if (here_) nearest_first(places);
  }
  const Point middle = here_ ? middle_of(bench_.sides.source.mesh, part) : Point();
  for (const Candidate& seed : places) {
    if (laying.ways >= kMostWays || (laying.ways > 0 && spent_ > budget)) break;
    laying.is_latest = false;
    if (!fills(seed, part)) continue;
    worths.push_back(worth_of_map());
    const double all_told = worths.back() - kDrift * drift_of_map(middle);
    if (laying.ways++ == 0 || all_told > most) {
      laying.seed = seed;
      laying.is_latest = true;
      most = all_told;
      chosen = worths.back();
    }
  }
  const auto as_good =
      std::count_if(worths.begin(), worths.end(), [&](double worth) { return worth > chosen - kClear; });
  laying.by_positions = laying.ways > 1 && as_good == 1;
  return laying;
}

std::size_t EqualParts::lay(const Part& part, const Part& other, std::uint32_t equals, bool chosen_by_positions) {
  const Laying laying = best_laying(part, other);
  if (laying.ways == 0 || (!laying.is_latest && !fills(laying.seed, part))) return 0;
  const std::uint32_t region = bench_.patchwork.fresh_region();
  bench_.patchwork.lay(map_.pairs(), region);
  WholeMap::Faces faces = map_.take();
  pieces_.push_back({.pairs = std::move(faces.pairs), .waves = std::move(faces.waves)});
  const std::uint32_t ways = laying.ways * equals;
  if (ways > 1)
    ties_.push_back({part.first_face, ways, chosen_by_positions && (laying.ways == 1 || laying.by_positions)});
  return part.faces;
}

std::size_t EqualParts::lay_single() {
  std::size_t matched = 0;
  for (const Class& equal : classes_) {
    if (equal.source.size() != 1 || equal.target.size() != 1) continue;
    matched += lay(source_parts_[equal.source[0]], target_parts_[equal.target[0]], 1, true);
  }
  return matched;
}

/// Where a source part comes to lie, as far as positions say: with the model as a whole, or as what lies beside it.
std::optional<LocalPlacement> EqualParts::placement_of(const Part& part) {
  constexpr std::size_t kMostLooks = 1 << 24;
  if (bench_.misfit.is_placed()) return LocalPlacement{*bench_.misfit.placement(), 0};
  if (!bench_.misfit.trusts_lengths() || looked_at_ > kMostLooks) return std::nullopt;
  looked_at_ += bench_.patchwork.history().size();
  return local_placement(bench_, middle_of(bench_.sides.source.mesh, part));
}

EqualParts::Order EqualParts::nearest_pairs(const Class& equal) {
  // Thousands of bolts are taken as they come.
  constexpr std::size_t kMostDistances = 1 << 20;
  Order order;
  const bool few = equal.source.size() * equal.target.size() <= kMostDistances;
  std::vector<LocalPlacement> placements;
  for (const std::uint32_t i : equal.source) {
    const std::optional<LocalPlacement> placement = few ? placement_of(source_parts_[i]) : std::nullopt;
    if (!placement) break;
    placements.push_back(*placement);
  }
  if (placements.size() < equal.source.size()) {
    for (std::size_t k = 0; k < std::min(equal.source.size(), equal.target.size()); ++k) {
      order.pairs.emplace_back(equal.source[k], equal.target[k]);
    }
    return order;
  }
  std::vector<Point> middles;
  for (const std::uint32_t j : equal.target) middles.push_back(middle_of(bench_.sides.target.mesh, target_parts_[j]));
  order.by_positions = true;
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> by_distance;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const Point middle = middle_of(bench_.sides.source.mesh, source_parts_[equal.source[i]]);
    const Point landed = placements[i].similarity(middle);
    std::vector<double> distances;
    for (std::size_t k = 0; k < middles.size(); ++k) {
      distances.push_back(squared_distance(landed, middles[k]));
      by_distance.emplace_back(distances.back(), equal.source[i], equal.target[k]);
    }
    order.by_positions =
        order.by_positions && (bench_.misfit.is_placed() || is_clear(std::move(distances), placements[i].error));
  }
  std::sort(by_distance.begin(), by_distance.end());
  for (const auto& [distance, i, j] : by_distance) order.pairs.emplace_back(i, j);
  return order;
}

std::size_t EqualParts::lay_repeated() {
  std::size_t matched = 0;
  looked_ = false;  // more is matched now
  for (const Class& equal : classes_) {
    if (equal.source.size() == 1 && equal.target.size() == 1) continue;
    look_at_positions();
    const auto equals = static_cast<std::uint32_t>(std::max(equal.source.size(), equal.target.size()));
    const Order order = nearest_pairs(equal);
    for (const auto& [i, j] : order.pairs) {
      const Part& part = source_parts_[i];
      const Part& other = target_parts_[j];
      if (bench_.patchwork.is_matched(part.first_face) || bench_.patchwork.is_taken(other.first_face)) continue;
      matched += lay(part, other, equals, order.by_positions);
    }
  }
  return matched;
}

}  // namespace quadmatch::regions
