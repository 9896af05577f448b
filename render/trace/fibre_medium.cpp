#include "render/trace/fibre_medium.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/shell/cloth_to_world.h"
#include "render/trace/fibre_exit.h"

namespace loomlight {
namespace {

/// The fibres of one end or pick: one Embree geometry.
struct YarnCurves {
  System system;
  int index;
  std::vector<glm::vec4> vertices;        ///< world position, radius
  std::vector<uint32_t> segments;         ///< first vertex of each
  std::vector<uint32_t> strandOfSegment;  ///< which strand of the yarn's period: the fibre's identity along the yarn
  std::vector<uint32_t> firstOfCell;      ///< first segment of each cell along the yarn

  size_t bytes() const {
    return vertices.size() * sizeof(glm::vec4) +
           (segments.size() + strandOfSegment.size() + firstOfCell.size()) * sizeof(uint32_t);
  }
};

/// A fibre of the whole cloth; 0 is none.
uint64_t fibreId(unsigned geometry, uint32_t strand) {
  return (uint64_t{geometry} + 1) << 32 | strand;
}

/// Threads for Embree's builder; 0: all. They are oneTBB's, which ThreadSanitizer cannot follow (core/base/parallel.h).
int builderThreads([[maybe_unused]] const Task& task) {
#ifdef LOOMLIGHT_STD_THREADS
  return 1;
#else
  return task.threads;
#endif
}

/// Cloth coordinates of a point of CellStrands.
glm::vec3 inCloth(glm::vec3 usz, System system, glm::vec2 centre) {
  return system == System::warp ? glm::vec3(centre.x + usz.x, centre.y + usz.y, usz.z)
                                : glm::vec3(centre.x + usz.y, centre.y - usz.x, usz.z);
}

/// What the filter needs to know of a ray, behind Embree's own context.
struct RayContext {
  RTCIntersectContext embree;
  uint64_t ownFibre;
  float clearance_mm;
};

constexpr float kOwnFibreRadii = 3;  // how far, in radii, a ray does not see the fibre that it has left

}  // namespace

struct FibreMedium::Parts {
  explicit Parts(const Scene& s) : scene(s) {}
  ~Parts() {
    if (bvh) rtcReleaseScene(bvh);
    if (device) rtcReleaseDevice(device);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void addYarn(YarnCurves& yarn, const ClothToWorld& toWorld) const;
  void attach(unsigned id);
  uint64_t idOf(const RTCHit& hit) const { return fibreId(hit.geomID, yarns[hit.geomID].strandOfSegment[hit.primID]); }
  static void filter(const RTCFilterFunctionNArguments* args);
  RTCRay ray(const Departure& from, glm::vec3 direction, float distance) const;

  const Scene& scene;
  std::vector<YarnCurves> yarns;
  RTCDevice device = nullptr;
  RTCScene bvh = nullptr;
  std::atomic<int64_t> acceleratorBytes{0};
};

/// Surfaces count from outside only, and not the fibre's own where the ray has just left it.
void FibreMedium::Parts::filter(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const auto* context = reinterpret_cast<const RayContext*>(args->context);
  const bool fromInside = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z > 0;
  const auto* parts = static_cast<const Parts*>(args->geometryUserPtr);
  if (fromInside || (ray->tfar < context->clearance_mm && parts->idOf(*hit) == context->ownFibre)) args->valid[0] = 0;
}

/// Fills in the curves of the yarn; strands end where the drape has no cloth.
void FibreMedium::Parts::addYarn(YarnCurves& yarn, const ClothToWorld& toWorld) const {
  const ClothGeometry& geometry = scene.volume->geometry();
  const bool warp = yarn.system == System::warp;
  const int cells = warp ? geometry.picks() : geometry.ends();
  for (int cell = 0; cell < cells; ++cell) {
    yarn.firstOfCell.push_back(static_cast<uint32_t>(yarn.segments.size()));
    const int end = warp ? yarn.index : cell, pick = warp ? cell : yarn.index;
    const CellStrands strands = geometry.strands(geometry.key(yarn.system, pick, end));
    const glm::vec2 centre((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm());
    for (size_t s = 0; s < strands.strands.size(); ++s) {
      const CellStrands::Strand& strand = strands.strands[s];
      bool joined = false;
      for (uint32_t i = strand.first; i < strand.first + strand.count; ++i) {
        const auto point = toWorld(inCloth(strands.points[i], yarn.system, centre));
        if (point) {
          if (joined) {
            yarn.segments.push_back(static_cast<uint32_t>(yarn.vertices.size() - 1));
            yarn.strandOfSegment.push_back(static_cast<uint32_t>(s));
          }
          yarn.vertices.emplace_back(point->world, strands.fibreRadius_mm);
        }
        joined = point.has_value();
      }
    }
  }
}

void FibreMedium::Parts::attach(unsigned id) {
  YarnCurves& yarn = yarns[id];
  if (yarn.segments.empty()) return;
  RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, yarn.vertices.data(), 0,
                             sizeof(glm::vec4), yarn.vertices.size());
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, yarn.segments.data(), 0,
                             sizeof(uint32_t), yarn.segments.size());
  rtcSetGeometryUserData(curves, this);
  rtcSetGeometryIntersectFilterFunction(curves, filter);
  rtcSetGeometryOccludedFilterFunction(curves, filter);
  rtcCommitGeometry(curves);
  rtcAttachGeometryByID(bvh, curves, id);
  rtcReleaseGeometry(curves);
}

RTCRay FibreMedium::Parts::ray(const Departure& from, glm::vec3 direction, float distance) const {
  RTCRay ray{};
  ray.org_x = from.place.world.x;
  ray.org_y = from.place.world.y;
  ray.org_z = from.place.world.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = distance;
  ray.mask = ~0u;
  return ray;
}

FibreMedium::FibreMedium(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
FibreMedium::~FibreMedium() = default;

FibreMedium::Size FibreMedium::estimate(const Scene& scene) {
  // Our arrays take 24 bytes a segment, Embree's BVH measured 31-36, and as much again while it builds.
  constexpr double kBytesPerSegment = 24 + 36 + 36;
  const ClothGeometry& geometry = scene.volume->geometry();
  const double repeats =
      static_cast<double>(geometry.ends()) / geometry.repeatEnds() * geometry.picks() / geometry.repeatPicks();
  const double segments = repeats * geometry.measure().segmentsPerRepeat;
  return {segments, segments * kBytesPerSegment};
}

std::unique_ptr<const FibreMedium> FibreMedium::build(const Scene& scene, double limit_bytes, const Task& task) {
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  const Size size = estimate(scene);
  if (size.bytes > limit_bytes)
    throw InputError(
        fmt::format("this piece has {:.3g} fibre segments, which would take {:.2f} GiB; expected at most "
                    "{:.2f} GiB: make the piece smaller, or raise the limit",
                    size.segments, size.bytes / kGiB, limit_bytes / kGiB));
  auto parts = std::make_unique<Parts>(scene);
  const ClothGeometry& geometry = scene.volume->geometry();
  for (int end = 0; end < geometry.ends(); ++end) parts->yarns.push_back({System::warp, end, {}, {}, {}, {}});
  for (int pick = 0; pick < geometry.picks(); ++pick) parts->yarns.push_back({System::weft, pick, {}, {}, {}, {}});

  const ClothToWorld toWorld(*scene.shell);
  std::atomic<size_t> done{0};
  parallelFor(parts->yarns.size(), task.threads, [&](size_t i) {
    if (task.stopped()) return;
    parts->addYarn(parts->yarns[i], toWorld);
    task.report(0.5 * static_cast<double>(++done) / static_cast<double>(parts->yarns.size()));
  });
  if (task.stopped()) return nullptr;

  parts->device = rtcNewDevice(fmt::format("threads={}", builderThreads(task)).c_str());
  if (!parts->device) throw std::runtime_error("Embree could not start");
  rtcSetDeviceMemoryMonitorFunction(
      parts->device,
      [](void* user, ssize_t bytes, bool) {
        static_cast<Parts*>(user)->acceleratorBytes += bytes;
        return true;
      },
      parts.get());
  parts->bvh = rtcNewScene(parts->device);
  rtcSetSceneFlags(parts->bvh, RTC_SCENE_FLAG_ROBUST);
  for (unsigned id = 0; id < parts->yarns.size(); ++id) parts->attach(id);
  rtcCommitScene(parts->bvh);
  task.report(1);
  return std::unique_ptr<const FibreMedium>(new FibreMedium(std::move(parts)));
}

size_t FibreMedium::segments() const {
  size_t sum = 0;
  for (const YarnCurves& yarn : parts_->yarns) sum += yarn.segments.size();
  return sum;
}

size_t FibreMedium::geometryBytes() const {
  size_t sum = 0;
  for (const YarnCurves& yarn : parts_->yarns) sum += yarn.bytes();
  return sum;
}

size_t FibreMedium::acceleratorBytes() const {
  return static_cast<size_t>(parts_->acceleratorBytes.load());
}

std::optional<Collision> FibreMedium::collide(const Departure& from, glm::vec3 direction, Random&,
                                              TraceCounts& counts) const {
  ++counts.rays;
  RayContext context;
  rtcInitIntersectContext(&context.embree);
  context.ownFibre = from.fibre;
  context.clearance_mm = from.clearance_mm;
  RTCRayHit hit{};
  hit.ray = parts_->ray(from, direction, std::numeric_limits<float>::infinity());
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(parts_->bvh, &context.embree, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  ++counts.events;

  const YarnCurves& curves = parts_->yarns[hit.hit.geomID];
  const uint32_t first = curves.segments[hit.hit.primID];
  const glm::vec3 a(curves.vertices[first]), b(curves.vertices[first + 1]);
  const glm::vec3 normal = glm::normalize(glm::vec3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z));
  const Scene& scene = parts_->scene;
  Collision c;
  c.place = {from.place.world + hit.ray.tfar * direction, -1};
  c.distance_mm = hit.ray.tfar;
  c.incoming = direction;
  c.tangent = glm::normalize(b - a);
  const glm::vec3 across = glm::cross(c.tangent, direction);
  // h is the sine, about the axis, from the normal to the way back.
  const float width = glm::length(across);
  c.offset = width > 0 ? std::clamp(glm::dot(across, normal) / width, -1.0f, 1.0f) : 0.0f;
  c.normal = normal;
  c.fibre = parts_->idOf(hit.hit);
  c.events = from.events + 1;
  c.yarn = scene.volume->geometry().yarnIndex(curves.system, curves.index);
  c.optics = scene.yarns[static_cast<int>(curves.system)][c.yarn];
  c.axis = c.place.world - c.optics.fibreRadius_mm * normal;
  const auto cell =
      static_cast<int>(std::upper_bound(curves.firstOfCell.begin(), curves.firstOfCell.end(), hit.hit.primID) -
                       curves.firstOfCell.begin() - 1);
  c.end = curves.system == System::warp ? curves.index : cell;
  c.pick = curves.system == System::warp ? cell : curves.index;
  return c;
}

float FibreMedium::transmittance(const Departure& from, glm::vec3 direction, float distance, Random&,
                                 TraceCounts& counts) const {
  ++counts.rays;
  RayContext context;
  rtcInitIntersectContext(&context.embree);
  context.ownFibre = from.fibre;
  context.clearance_mm = from.clearance_mm;
  RTCRay ray = parts_->ray(from, direction, distance);
  rtcOccluded1(parts_->bvh, &context.embree, &ray);
  return ray.tfar < 0 ? 0.0f : 1.0f;
}

Departure FibreMedium::leave(const Collision& collision, glm::vec3 wi, int order) const {
  const float radius = collision.optics.fibreRadius_mm;
  Departure departure{collision.place, collision.events, collision.fibre, kOwnFibreRadii * radius};
  const Yarn& yarn = parts_->scene.fabric->yarns[collision.yarn];
  if (yarn.layout == FibreLayout::packed) departure.place.world = fibreExit(parts_->scene, collision, wi, order);
  return departure;
}

}  // namespace loomlight
