#include <quadmatch/shapes/random_edit.hpp>

#include <charconv>
#include <cmath>
#include <functional>
#include <system_error>
#include <utility>

#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "edit_support.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

constexpr int kPlaces = 400;
/// How far a patch is lifted, in lengths of its first edge.
constexpr double kLift = 1.0;

FaceId any_face(const PolygonSoup& soup, Random& random) { return FaceId(random.below(face_count(soup))); }

HalfedgeId any_halfedge(const PolygonSoup& soup, Random& random) {
  return HalfedgeId(random.below(static_cast<std::uint32_t>(soup.corners.size())));
}

double lift_at(const PolygonSoup& soup, FaceId face) {
  if (soup.positions.empty()) return 0.0;
  const auto corners = corners_of(soup, face.value);
  const Point &from = soup.positions[corners[0].value], &to = soup.positions[corners[1].value];
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += (to[k] - from[k]) * (to[k] - from[k]);
  return kLift * std::sqrt(square);
}

using Place = std::function<Expected<Edit>(const PolygonSoup&)>;

/// Make an edit where it fits.
Expected<Edit> tried(const PolygonSoup& soup, const Place& at_any_place) {
  Expected<Edit> edit = at_any_place(soup);
  for (int attempt = 1; attempt < kPlaces && !edit; ++attempt) edit = at_any_place(soup);
  return edit;
}

/// Make an edit `count` times, one after the other.
Expected<Edit> repeated(const PolygonSoup& soup, std::uint32_t count, const Place& at_any_place) {
  Expected<Edit> all = tried(soup, at_any_place);
  for (std::uint32_t step = 1; step < count && all; ++step) {
    Expected<Edit> next = tried(all->soup, at_any_place);
    if (!next) return next;
    next->truth = chained(all->truth, next->truth, next->soup);
    all = std::move(next);
  }
  return all;
}

using Maker = Expected<Edit> (*)(const PolygonSoup& soup, std::uint32_t size, Random& random);

struct Kind {
  RandomEditKind told;
  Maker make;
};

Expected<Edit> erase(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return tried(soup, [&](const PolygonSoup& at) { return delete_patch(at, any_face(at, random), size); });
}

Expected<Edit> extrude(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return tried(soup, [&](const PolygonSoup& at) {
    const FaceId centre = any_face(at, random);
    return extrude_patch(at, centre, size, lift_at(at, centre));
  });
}

Expected<Edit> collapse(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return repeated(soup, size, [&](const PolygonSoup& at) { return collapse_quad(at, any_halfedge(at, random)); });
}

Expected<Edit> rip(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return tried(soup, [&](const PolygonSoup& at) { return rip_edges(at, any_halfedge(at, random), size); });
}

Expected<Edit> refine(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return tried(soup, [&](const PolygonSoup& at) { return refine_patch(at, any_face(at, random), size); });
}

Expected<Edit> loop(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return repeated(soup, size, [&](const PolygonSoup& at) { return insert_edge_loop(at, any_halfedge(at, random)); });
}

Expected<Edit> unloop(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return repeated(soup, size, [&](const PolygonSoup& at) { return remove_edge_loop(at, any_halfedge(at, random)); });
}

Expected<Edit> twist(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return tried(soup, [&](const PolygonSoup& at) { return twist_ring(at, any_halfedge(at, random), size); });
}

Expected<Edit> handle(const PolygonSoup& soup, std::uint32_t size, Random& random) {
  return repeated(soup, size, [&](const PolygonSoup& at) {
    const FaceId one = any_face(at, random);
    return add_handle(at, one, any_face(at, random));
  });
}

Expected<Edit> subdivide(const PolygonSoup& soup, std::uint32_t size, Random&) {
  return Edit{catmull_clark(soup, size), {}};
}

Expected<Edit> renumber(const PolygonSoup& soup, std::uint32_t, Random& random) {
  Renumbered result = renumbered(soup, random.below(1U << 31U));
  return Edit{std::move(result.soup), std::move(result.faces)};
}

constexpr Kind kKinds[] = {
    {{"delete", 20, "remove a connected patch of N faces"}, erase},
    {{"extrude", 12, "lift a patch of N faces and add its side quads"}, extrude},
    {{"collapse", 3, "collapse N quads along a diagonal"}, collapse},
    {{"rip", 6, "open a slit along N edges"}, rip},
    {{"refine", 9, "split each quad of a patch of N in four"}, refine},
    {{"loop", 1, "insert N edge loops"}, loop},
    {{"unloop", 1, "remove N rows of quads"}, unloop},
    {{"twist", 1, "turn one side of a ring of quads by N quads and join it again"}, twist},
    {{"handle", 1, "join two quads by a tube, N times"}, handle},
    {{"subdivide", 1, "refine the whole N times (Catmull-Clark); no face survives"}, subdivide},
    {{"renumber", 1, "vertices and faces in random order, every face from a random corner"}, renumber},
};

}  // namespace

std::vector<RandomEditKind> random_edit_kinds() {
  std::vector<RandomEditKind> told;
  for (const Kind& kind : kKinds) told.push_back(kind.told);
  return told;
}

Expected<RandomEdit> parse_random_edit(std::string_view text) {
  const std::size_t colon = text.find(':');
  RandomEdit edit{std::string(text.substr(0, colon)), 0};
  for (const Kind& kind : kKinds) {
    if (edit.name == kind.told.name) edit.size = kind.told.size;
  }
  if (edit.size == 0) return does_not_fit("there is no edit named " + edit.name);
  if (colon == std::string_view::npos) return edit;
  const std::string_view digits = text.substr(colon + 1);
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), edit.size);
  if (problem != std::errc() || end != digits.data() + digits.size() || edit.size == 0) {
    return does_not_fit("the size of " + edit.name + " is not a number from 1 on: " + std::string(digits));
  }
  return edit;
}

Expected<Edit> edit_at_random(const PolygonSoup& soup, const RandomEdit& edit, Random& random) {
  if (soup.corners.empty()) return does_not_fit("there is no face to edit");
  for (const Kind& kind : kKinds) {
    if (edit.name == kind.told.name) return kind.make(soup, edit.size, random);
  }
  return does_not_fit("there is no edit named " + edit.name);
}

}  // namespace quadmatch::shapes
