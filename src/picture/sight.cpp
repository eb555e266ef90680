// Rays are cast by Embree: it takes quads as they are and finds the nearest face exactly, without a display or a
// graphics card. Shading and the lines along edges are made of the faces as they are seen.

#include "sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <embree3/rtcore.h>

namespace quadmatch::picture {
namespace {

constexpr std::uint32_t kRaysAside = 3;
static_assert(kRaysAside * kRaysAside == kRays);

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

/// Faces as quads: a triangle's last corner stands twice, and larger faces are fans of several.
struct Quads {
  std::vector<std::array<std::uint32_t, 4>> corners;
  /// Empty where every face is one quad.
  std::vector<FaceId> faces;

  [[nodiscard]] FaceId face(std::uint32_t quad) const { return faces.empty() ? FaceId(quad) : faces[quad]; }
};

Quads quads_of(const Mesh& mesh) {
  Quads quads;
  quads.corners.reserve(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t first = mesh.first(FaceId(f)).value;
    const auto corner = [&](std::uint32_t k) { return mesh.corners()[first + k].value; };
    const std::uint32_t size = mesh.size(FaceId(f));
    for (std::uint32_t k = 1; k + 1 < size; k += 2) {
      quads.corners.push_back({corner(0), corner(k), corner(k + 1), corner(std::min(k + 2, size - 1))});
      if (!mesh.all_quads()) quads.faces.push_back(FaceId(f));
    }
  }
  return quads;
}

/// Room in a geometry, filled; false where there is none.
template <class Number, class Rows>
bool fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const Rows& rows) {
  constexpr std::size_t kColumns = std::tuple_size_v<typename Rows::value_type>;
  void* const room = rtcSetNewGeometryBuffer(geometry, type, 0, format, kColumns * sizeof(Number), rows.size());
  if (room == nullptr) return false;
  auto* number = static_cast<Number*>(room);
  for (const auto& row : rows)
    number = std::transform(row.begin(), row.end(), number, [](auto value) { return static_cast<Number>(value); });
  return true;
}

/// Nothing where memory runs out.
Scene scene_of(RTCDevice device, const std::vector<Point>& points, const Quads& quads) {
  Scene scene(rtcNewScene(device));
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  const bool filled = fill<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points) &&
                      fill<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT4, quads.corners);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  // No ray slips through between two faces.
  rtcSetSceneFlags(scene.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT));
  if (filled) rtcCommitScene(scene.get());
  if (!filled || rtcGetDeviceError(device) != RTC_ERROR_NONE) scene.reset();
  return scene;
}

double smoothstep(double low, double high, double x) {
  const double share = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

std::uint8_t of_255(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

/// How a face looks.
struct Look {
  std::uint8_t light = 0;
  /// How strong its edges are: not at all where it is but a few pixels wide, else they would paint all of it.
  float edges = 0;
};

/// The faces of a mesh as they are seen from a place.
class Faces {
 public:
  Faces(const Mesh& mesh, const std::vector<Point>& points, const Camera& camera) : mesh_(mesh) {
    places_.reserve(points.size());
    for (const Point& point : points) places_.push_back(camera.pixel_of(point));
    looks_.reserve(mesh.face_count());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) looks_.push_back(look_of(FaceId(f), points, camera));
  }

  [[nodiscard]] std::uint8_t light(FaceId face) const { return looks_[face.value].light; }

  /// How strong the line along the nearest edge of a face is at a place.
  [[nodiscard]] double edge_at(FaceId face, double x, double y) const {
    const double strength = looks_[face.value].edges;
    if (strength == 0) return 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const HalfedgeId h : mesh_.halfedges(face)) {
      const auto& a = places_[mesh_.origin(h).value];
      const auto& b = places_[mesh_.tip(h).value];
      nearest = std::min(nearest, squared_distance(x - a[0], y - a[1], b[0] - a[0], b[1] - a[1]));
    }
    constexpr double kFull = 0.6, kNone = 1.4;  // pixels from the edge
    return nearest >= kNone * kNone ? 0 : strength * (1 - smoothstep(kFull, kNone, std::sqrt(nearest)));
  }

 private:
  /// From a point to the segment from 0 to (dx, dy).
  static double squared_distance(double x, double y, double dx, double dy) {
    const double squared = dx * dx + dy * dy;
    const double share = squared > 0 ? std::clamp((x * dx + y * dy) / squared, 0.0, 1.0) : 0;
    const double away_x = x - share * dx, away_y = y - share * dy;
    return away_x * away_x + away_y * away_y;
  }

  [[nodiscard]] Look look_of(FaceId face, const std::vector<Point>& points, const Camera& camera) const {
    Point normal = {0, 0, 0};
    double area = 0, longest = 0;  // as seen
    for (const HalfedgeId h : mesh_.halfedges(face)) {
      const Point& a = points[mesh_.origin(h).value];
      const Point& b = points[mesh_.tip(h).value];
      normal[0] += a[1] * b[2] - a[2] * b[1];
      normal[1] += a[2] * b[0] - a[0] * b[2];
      normal[2] += a[0] * b[1] - a[1] * b[0];
      const auto& [ax, ay] = places_[mesh_.origin(h).value];
      const auto& [bx, by] = places_[mesh_.tip(h).value];
      area += (static_cast<double>(ax) * by - static_cast<double>(ay) * bx) / 2;
      longest = std::max(longest, std::hypot(static_cast<double>(bx) - ax, static_cast<double>(by) - ay));
    }
    Look look;
    look.light = of_255(light_of(camera.seen(normal), area <= 0));
    const double breadth = longest > 0 ? std::abs(area) / longest : 0;
    look.edges = static_cast<float>(smoothstep(1.5, 5, breadth));
    return look;
  }

  /// As web/src/picture/materials.ts has it. Pixels are counted downwards, so fronts have negative areas.
  static double light_of(const Point& normal, bool front) {
    const double length = std::sqrt(dot(normal, normal));
    const Point lamp = {0.35, 0.5, 0.8};
    const double facing = length > 0 ? std::abs(dot(normal, lamp)) / length / std::sqrt(dot(lamp, lamp)) : 1;
    return (0.62 + 0.38 * facing) * (front ? 1 : 0.72);
  }

  const Mesh& mesh_;
  std::vector<std::array<float, 2>> places_;
  std::vector<Look> looks_;
};

class Looker {
 public:
  Looker(RTCScene scene, const Quads& quads, const Faces& faces, const Camera& camera)
      : scene_(scene), quads_(quads), faces_(faces), camera_(camera) {}

  Sight look(std::uint32_t width, std::uint32_t height) {
    Sight sight{.width = width, .height = height};
    sight.starts.reserve(std::size_t{1} * width * height + 1);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        sight.starts.push_back(static_cast<std::uint32_t>(sight.fragments.size()));
        look_at_pixel(x, y, sight.fragments);
      }
    }
    sight.starts.push_back(static_cast<std::uint32_t>(sight.fragments.size()));
    return sight;
  }

 private:
  struct Met {
    FaceId face;
    std::uint32_t rays = 0;
    double edge = 0;
  };

  void look_at_pixel(std::uint32_t x, std::uint32_t y, std::vector<Fragment>& fragments) {
    std::array<Met, kRays> met;
    std::size_t count = 0;
    for (std::uint32_t ray = 0; ray < kRays; ++ray) {
      const std::uint32_t column = ray % kRaysAside, row = ray / kRaysAside;
      const double at_x = x + (column + 0.5) / kRaysAside;
      const double at_y = y + (row + 0.5) / kRaysAside;
      const FaceId face = face_at(at_x, at_y);
      if (!face.valid()) continue;
      const auto end = met.begin() + static_cast<std::ptrdiff_t>(count);
      const auto known = std::find_if(met.begin(), end, [&](const Met& other) { return other.face == face; });
      if (known == end) met[count++] = {face, 0, 0};
      ++known->rays;
      known->edge += faces_.edge_at(face, at_x, at_y);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const Met& one = met[k];
      fragments.push_back(
          {one.face, static_cast<std::uint8_t>(one.rays), faces_.light(one.face), of_255(one.edge / one.rays)});
    }
  }

  FaceId face_at(double x, double y) {
    const Point& eye = camera_.eye();
    const Point way = camera_.ray_through(x, y);
    RTCRayHit ray = {};
    ray.ray.org_x = static_cast<float>(eye[0]);
    ray.ray.org_y = static_cast<float>(eye[1]);
    ray.ray.org_z = static_cast<float>(eye[2]);
    ray.ray.dir_x = static_cast<float>(way[0]);
    ray.ray.dir_y = static_cast<float>(way[1]);
    ray.ray.dir_z = static_cast<float>(way[2]);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = std::numeric_limits<unsigned>::max();
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(scene_, &context, &ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? FaceId{} : quads_.face(ray.hit.primID);
  }

  RTCScene scene_;
  const Quads& quads_;
  const Faces& faces_;
  const Camera& camera_;
};

Error no_memory(const MeshFile& file) {
  return {ErrorCode::TooLarge, "there is not enough memory to draw the mesh; leave --image and --animation out",
          file.path};
}

}  // namespace

Expected<Sight> look(const MeshFile& file, PictureView view, std::uint32_t width, std::uint32_t height) {
  const Expected<std::vector<Point>> points = framed(file);
  if (!points) return Unexpected(points.error());
  // One thread, and the instructions that every processor has: the same pixels everywhere.
  const Device device(rtcNewDevice("threads=1,isa=sse2,frequency_level=simd128"));
  if (!device) return Unexpected(no_memory(file));
  const Quads quads = quads_of(file.mesh);
  const Scene scene = scene_of(device.get(), *points, quads);
  if (!scene) return Unexpected(no_memory(file));
  const Camera camera(view, width, height);
  const Faces faces(file.mesh, *points, camera);
  return Looker(scene.get(), quads, faces, camera).look(width, height);
}

}  // namespace quadmatch::picture
