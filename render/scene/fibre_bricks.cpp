#include "render/scene/fibre_bricks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "core/base/parallel.h"
#include "render/scene/embree.h"
#include "render/scene/place_in_cloth.h"

// How it works. A ray goes from cell to cell of the weave, as it does through voxels. In each it is asked of the bricks
// that reach into the cell, up to six, every one about the middle of its own cell; only what is met inside of the cell
// counts, so that the nearest hit of the first cell that has any is the first of all. Numbers are counted from the
// cell, so that floats will do on cloth of any size.

namespace loomlight {
namespace {

/// Surfaces count from outside only: a ray that comes into a cell may be inside of a fibre, which it has met before.
void meetFromOutside(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  if (ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z > 0) args->valid[0] = 0;
}

}  // namespace

struct FibreBricks::Device {
  Device() {
#ifdef LOOMLIGHT_STD_THREADS
    handle = rtcNewDevice("threads=1");  // ThreadSanitizer cannot follow oneTBB's threads
#else
    handle = rtcNewDevice(nullptr);
#endif
    if (!handle) throw std::runtime_error("Embree could not start");
  }
  ~Device() {
    rtcReleaseDevice(handle);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDevice handle;
};

struct FibreBricks::Brick {
  Brick() = default;
  ~Brick() {
    if (scene) rtcReleaseScene(scene);
  }
  Brick(const Brick&) = delete;
  Brick& operator=(const Brick&) = delete;

  std::vector<glm::vec4> vertices;           ///< from the middle of the cell, cloth space; radius
  std::vector<uint32_t> segments, strandOf;  ///< first vertex of each, and its strand
  RTCScene scene = nullptr;
};

struct FibreBricks::Slot {
  std::once_flag once;
  std::unique_ptr<const Brick> brick;
};

std::shared_ptr<const FibreBricks> FibreBricks::of(const ClothVolume& volume,
                                                   std::shared_ptr<const ClothGeometry> geometry) {
  if (volume.counts().segments > kMostSegments) return nullptr;
  return std::shared_ptr<const FibreBricks>(new FibreBricks(std::move(geometry)));
}

FibreBricks::FibreBricks(std::shared_ptr<const ClothGeometry> geometry) : geometry_(std::move(geometry)) {}
FibreBricks::~FibreBricks() = default;

size_t FibreBricks::made() const {
  const std::lock_guard lock(mutex_);
  return bricks_.size();
}

const FibreBricks::Brick& FibreBricks::brick(const CellKey& key) const {
  Slot* slot = nullptr;
  {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Slot>& entry = bricks_[key];
    if (!entry) entry = std::make_unique<Slot>();
    slot = entry.get();
  }
  std::call_once(slot->once, [&] { slot->brick = make(key); });
  return *slot->brick;
}

std::unique_ptr<const FibreBricks::Brick> FibreBricks::make(const CellKey& key) const {
  std::call_once(started_, [this] { device_ = std::make_unique<Device>(); });
  auto brick = std::make_unique<Brick>();
  const CellStrands cell = geometry_->strands(key);
  brick->vertices.reserve(cell.points.size());
  brick->segments.reserve(cell.segments());
  brick->strandOf.reserve(cell.segments());
  for (size_t s = 0; s < cell.strands.size(); ++s) {
    const CellStrands::Strand& strand = cell.strands[s];
    for (uint32_t i = strand.first; i < strand.first + strand.count; ++i) {
      if (i + 1 < strand.first + strand.count) {
        brick->segments.push_back(static_cast<uint32_t>(brick->vertices.size()));
        brick->strandOf.push_back(static_cast<uint32_t>(s));
      }
      brick->vertices.emplace_back(inCloth(cell.points[i], key.system, glm::vec2(0)), cell.fibreRadius_mm);
    }
  }
  RTCGeometry curves = rtcNewGeometry(device_->handle, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, brick->vertices.data(), 0,
                             sizeof(glm::vec4), brick->vertices.size());
  rtcSetSharedGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, brick->segments.data(), 0,
                             sizeof(uint32_t), brick->segments.size());
  rtcSetGeometryIntersectFilterFunction(curves, meetFromOutside);
  rtcCommitGeometry(curves);
  brick->scene = rtcNewScene(device_->handle);
  rtcAttachGeometry(brick->scene, curves);
  rtcReleaseGeometry(curves);
  rtcSetSceneFlags(brick->scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(brick->scene);
  if (rtcGetDeviceError(device_->handle) != RTC_ERROR_NONE) throw std::bad_alloc();
  return brick;
}

const FibreBricks::Reader::Cell& FibreBricks::Reader::at(glm::ivec3 cell) {
  Cell& known = cells_[static_cast<size_t>(cell.x & 7) | static_cast<size_t>(cell.y & 7) << 3];
  if (known.cell == cell) return known;
  const ClothGeometry& geometry = volume_.geometry();
  const ClothVolume::CellBricks reaching = volume_.bricksIn(cell);
  known.count = reaching.count;
  for (int i = 0; i < reaching.count; ++i) {
    const ClothVolume::CellBricks::Brick& of = reaching.bricks[i];
    const bool warp = of.system == System::warp;
    const int end = warp ? of.index : cell.x, pick = warp ? cell.y : of.index;
    known.bricks[i] = {&bricks_.brick(geometry.key(of.system, pick, end)),
                       {(end - cell.x + 0.5) * geometry.warpPitch_mm(), (pick - cell.y + 0.5) * geometry.weftPitch_mm(),
                        -volume_.grid().zLower_mm},
                       of.system,
                       end,
                       pick};
  }
  known.cell = cell;
  return known;
}

/// start_mm: the ray at t = 0, from the corner of the cell.
std::optional<FibreHit> FibreBricks::Reader::meetIn(const Cell& cell, glm::vec3 start_mm, glm::vec3 direction,
                                                    float from, float to) const {
  std::optional<FibreHit> nearest;
  const glm::vec3 entry = start_mm + from * direction;
  float length = to - from;
  for (int i = 0; i < cell.count; ++i) {
    const Cell::Reaching& of = cell.bricks[i];
    const glm::vec3 origin = entry - of.centre_mm;
    RTCRayHit query{};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tfar = length;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::QueryContext context;
    embree::initialise(context);
    embree::intersect(of.brick->scene, context, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    length = query.ray.tfar;
    const glm::vec4* const segment = &of.brick->vertices[of.brick->segments[query.hit.primID]];
    nearest = {
        from + length,
        glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z)),
        glm::normalize(glm::vec3(segment[1]) - glm::vec3(segment[0])),
        of.system,
        of.end,
        of.pick,
        fibreNumber(of.system, of.system == System::warp ? of.end : of.pick, of.brick->strandOf[query.hit.primID])};
  }
  return nearest;
}

std::optional<FibreHit> FibreBricks::Reader::meet(glm::vec3 origin, glm::vec3 direction, float t0, float t1) {
  const ClothGeometry& geometry = volume_.geometry();
  ClothVolume::CellMarch march(volume_, origin, direction, t0, t1);
  if (!march.inPiece()) return std::nullopt;
  const double size_mm[2] = {geometry.warpPitch_mm(), geometry.weftPitch_mm()};
  for (float from = march.enter();;) {
    const glm::vec3 start = march.start_mm();
    float to = march.leave();
    int through = -1;
    for (int axis = 0; axis < 2; ++axis) {
      if (direction[axis] == 0) continue;
      const auto face = static_cast<float>(direction[axis] > 0 ? size_mm[axis] : 0.0);
      const float t = (face - start[axis]) / direction[axis];
      if (t >= to) continue;
      to = t;
      through = axis;
    }
    to = std::max(to, from);
    if (const auto hit = meetIn(at(march.cell()), start, direction, from, to)) return hit;
    if (through < 0 || !march.leaveCell(through)) return std::nullopt;
    from = to;
  }
}

}  // namespace loomlight
