#include <quadmatch/shapes/planted.hpp>

#include <algorithm>
#include <array>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/random.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "edit_support.hpp"
#include "planted_region.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

constexpr std::uint32_t kTries = 60;

enum class Change : std::uint8_t { Hole, Inset, Squeezed, Slit };
constexpr std::array<const char*, 4> kChangeNames = {"hole", "inset", "squeezed row", "slit"};
constexpr std::array<const char*, 4> kSurfaceNames = {"grid", "tube", "torus", "sphere"};

bool exists(const PlantedOptions& options) {
  if (std::min({options.width, options.height, options.places, options.size}) == 0) return false;
  if (options.surface == Surface::Tube) return options.width >= 3;
  return options.surface != Surface::Torus || std::min(options.width, options.height) >= 3;
}

PolygonSoup surface_of(const PlantedOptions& options) {
  switch (options.surface) {
    case Surface::Grid:
      return grid(options.width, options.height);
    case Surface::Tube:
      return cylinder(options.width, options.height);
    case Surface::Torus:
      return torus(options.width, options.height);
    case Surface::Sphere:
      break;
  }
  return sphere(options.width);
}

/// Quads on a way once around the surface, or from one side to the other.
std::uint32_t girth(const PlantedOptions& options) {
  switch (options.surface) {
    case Surface::Tube:
      return options.width;
    case Surface::Sphere:
      return 4 * options.width;
    default:
      return std::min(options.width, options.height);
  }
}

/// Where a half-edge of the first soup is after edits, none of which turns a face; not valid where it is gone.
HalfedgeId now(HalfedgeId h, const Edit& edit) {
  const auto found = std::lower_bound(edit.truth.begin(), edit.truth.end(), h.value / 4,
                                      [](const FacePair& pair, std::uint32_t f) { return pair.source.value < f; });
  if (found == edit.truth.end() || found->source.value != h.value / 4) return {};
  return HalfedgeId(4 * found->target.value + h.value % 4);
}

void follow(Edit& all, Edit next) {
  all.truth = chained(all.truth, next.truth, next.soup);
  all.soup = std::move(next.soup);
}

/// Squeeze quads in a row, each along a parallel diagonal, as in Fig. 4.2.
Expected<Edit> squeeze_row(const Mesh& mesh, Edit all, HalfedgeId start, std::uint32_t count) {
  HalfedgeId corner = start;
  for (std::uint32_t k = 0; k < count; ++k) {
    const HalfedgeId here = corner.valid() ? now(corner, all) : corner;
    if (!here.valid()) return does_not_fit("the row ends");
    Expected<Edit> next = collapse_quad(all.soup, here);
    if (!next) return next;
    follow(all, *std::move(next));
    const HalfedgeId beyond = mesh.twin(mesh.next(corner));
    corner = beyond.valid() ? mesh.next(beyond) : beyond;
  }
  return all;
}

Expected<Edit> changed(const Mesh& mesh, const Edit& all, Change change, HalfedgeId place, std::uint32_t size) {
  if (change == Change::Squeezed) return squeeze_row(mesh, all, place, size);
  const HalfedgeId here = now(place, all);
  if (!here.valid()) return does_not_fit("the place is gone");
  const FaceId face(here.value / 4);
  Expected<Edit> next = change == Change::Hole    ? delete_patch(all.soup, face, size)
                        : change == Change::Inset ? extrude_patch(all.soup, face, size, 0.5)
                                                  : rip_edges(all.soup, here, size + 1);
  if (!next) return next;
  Edit result = all;
  follow(result, *std::move(next));
  return result;
}

/// Places one after the other, each where there is room.
class Planting {
 public:
  Planting(const PlantedOptions& options, const Mesh& mesh, Edit start)
      : options_(options), mesh_(mesh), random_(options.seed), all_(std::move(start)) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      const HalfedgeRange sides = mesh.halfedges(FaceId(f));
      if (std::any_of(sides.begin(), sides.end(), [&](HalfedgeId h) { return !mesh.twin(h).valid(); })) {
        taken_.emplace_back(f);
      }
    }
  }

  void plant() {
    for (std::uint32_t k = 0; k < options_.places; ++k) {
      const std::vector<std::uint32_t> steps = steps_from(mesh_, taken_, std::vector<bool>(mesh_.face_count(), true));
      for (std::uint32_t tries = 0; tries < kTries; ++tries) {
        if (plant_one(steps)) break;
      }
    }
  }
  /// Where each face is, once all is planted, and what was.
  [[nodiscard]] const Edit& edit() const { return all_; }
  [[nodiscard]] const std::string& description() const { return description_; }

 private:
  bool plant_one(const std::vector<std::uint32_t>& steps) {
    const HalfedgeId place(random_.below(mesh_.halfedge_count()));
    const std::uint32_t size = 1 + random_.below(options_.size);
    const auto change = static_cast<Change>(random_.below(kChangeNames.size()));
    // A place of this size reaches as far from its face, or from one on the other side.
    const std::uint32_t reach = size + 1 + (taken_far_ ? options_.size + 1 : 0);
    if (steps[mesh_.face(place).value] <= options_.gap + reach) return false;
    Expected<Edit> next = changed(mesh_, all_, change, place, size);
    if (!next) return false;
    all_ = *std::move(next);
    taken_.push_back(mesh_.face(place));
    taken_far_ = true;
    description_ += std::string(description_.empty() ? "" : ", ") + kChangeNames[static_cast<std::size_t>(change)] +
                    " of " + std::to_string(size) + " at " + to_string(place);
    return true;
  }

  const PlantedOptions& options_;
  const Mesh& mesh_;
  Random random_;
  Edit all_;
  std::vector<FaceId> taken_;
  bool taken_far_ = false;
  std::string description_;
};

/// A pair at random among those at least half of ε away from all rims, or as far as there is.
FacePair on_axis(const Planted& planted, const Rims& rims, Random& random) {
  const std::uint32_t deepest = *std::max_element(rims.depth.begin(), rims.depth.end());
  const std::uint32_t asked = std::min(deepest, planted.epsilon / 2);
  std::vector<FacePair> deep;
  for (std::size_t k = 0; k < rims.depth.size(); ++k) {
    if (rims.depth[k] >= asked) deep.push_back(planted.region[k]);
  }
  return deep[random.below(static_cast<std::uint32_t>(deep.size()))];
}

}  // namespace

Expected<Planted> plant_mismatches(const PlantedOptions& options) {
  if (!exists(options)) return does_not_fit("there is no surface of that size, or nothing to plant");
  Planted planted;
  planted.source = surface_of(options);
  const Expected<Mesh> source = Mesh::build(planted.source);
  if (!source) return Unexpected(source.error());
  Edit start{planted.source, {}};
  for (std::uint32_t f = 0; f < source->face_count(); ++f) start.truth.push_back({FaceId(f), FaceId(f), 0});
  Planting planting(options, *source, std::move(start));
  planting.plant();
  if (planting.description().empty()) return does_not_fit("there is no room for a single mismatch");

  Renumbered renumbering = renumbered(planting.edit().soup, options.seed);
  planted.target = std::move(renumbering.soup);
  const Expected<Mesh> target = Mesh::build(planted.target);
  if (!target) return Unexpected(target.error());
  planted.region = sound_part(*source, *target, chained(planting.edit().truth, renumbering.faces, planted.target));
  const Rims rims = measure_rims(*source, *target, planted.region);
  planted.delta = rims.longest;
  const std::uint32_t around = girth(options) - std::min(girth(options), (rims.longest + 1) / 2);
  planted.epsilon = std::min(rims.narrowest, around);
  Random random(options.seed + 1);
  planted.anywhere = planted.region[random.below(static_cast<std::uint32_t>(planted.region.size()))];
  planted.anchor = on_axis(planted, rims, random);
  planted.description = std::string(kSurfaceNames[static_cast<std::size_t>(options.surface)]) + " " +
                        std::to_string(options.width) + " x " +
                        std::to_string(options.surface == Surface::Sphere ? options.width : options.height) + ": " +
                        planting.description();
  return planted;
}

PlantedOptions random_planted_options(std::uint64_t seed) {
  Random random(seed);
  PlantedOptions options{.surface = static_cast<Surface>(random.below(4)), .seed = seed};
  options.places = 1 + random.below(4);
  options.size = 1 + random.below(3);
  // Mismatches of size 1, 2, 3 have a rim of 4 ... 8, 10, 12 edges.
  options.gap = 1 + random.below(2 * (5 + options.size));
  const std::uint32_t cell = options.gap + 2 * options.size + 4;
  const bool two_rows = options.places > 2;
  options.width = cell * (two_rows ? 3 : 1 + options.places) + random.below(options.gap);
  options.height = cell * (two_rows ? 3 : 2) + random.below(options.gap);
  if (options.surface == Surface::Sphere) options.width = 1 + cell * (2 + options.places) / 3;
  return options;
}

}  // namespace quadmatch::shapes
