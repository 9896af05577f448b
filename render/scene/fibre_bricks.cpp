#include "render/scene/fibre_bricks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "render/scene/curve_runs.h"
#include "render/scene/embree_device.h"
#include "render/scene/place_in_cloth.h"

// How it works. A ray goes from cell to cell of the weave, as it does through voxels. In each it is asked of the bricks
// that reach into the cell, up to six, every one about the middle of its own cell; only what is met inside of the cell
// counts, so that the nearest hit of the first cell that has any is the first of all. Numbers are counted from the
// cell, so that floats will do on cloth of any size.

namespace loomlight {
struct FibreBricks::Brick {
  explicit Brick(CurveRuns c) : curves(std::move(c)) {}
  ~Brick() {
    if (scene) rtcReleaseScene(scene);
  }
  Brick(const Brick&) = delete;
  Brick& operator=(const Brick&) = delete;

  uint64_t fibre(const Reader::Cell::Reaching& of, unsigned segment) const {
    return fibreNumber(of.system, of.system == System::warp ? of.end : of.pick, curves.strandOf(segment));
  }

  CurveRuns curves;  ///< from the middle of the cell, cloth space
  RTCScene scene = nullptr;
  glm::vec3 lower{0}, upper{0};  ///< of all its fibres

  /// Whether a ray of this length comes there at all.
  bool isOn(const RTCRay& ray) const {
    const glm::vec3 inverse = 1.0f / embree::directionOf(ray), origin = embree::originOf(ray);
    const glm::vec3 a = (lower - origin) * inverse, b = (upper - origin) * inverse;
    const glm::vec3 enter = glm::min(a, b), leave = glm::max(a, b);  // a NaN (in the plane of a face) loses
    return std::max({0.0f, enter.x, enter.y, enter.z}) <= std::min({ray.tfar, leave.x, leave.y, leave.z});
  }
};

/// A question to a brick; the fibre that the ray leaves does not count.
struct FibreBricks::Reader::Query : CurveQuery {
  /// `from`: where on the ray Embree's begins.
  Query(const Cell::Reaching& reaching, const ClothRay& ray, float from)
      : CurveQuery(sees), of(&reaching), ownFibre(ray.ownFibre), ownUntil(ray.ownUntil - from) {}

  static bool sees(const CurveQuery& query, uint32_t segment, float t) {
    const auto& asked = static_cast<const Query&>(query);
    return t >= asked.ownUntil || asked.of->brick->fibre(*asked.of, segment) != asked.ownFibre;
  }

  const Cell::Reaching* of;
  uint64_t ownFibre;
  float ownUntil;  ///< of Embree's ray
};

struct FibreBricks::Slot {
  std::once_flag once;
  std::unique_ptr<const Brick> brick;
};

std::string FibreBricks::whyNone(const VolumeCounts& counts) {
  if (counts.segments <= kMostSegments) return "";
  return fmt::format(
      "Seen close by, voxels stay voxels: there are {:.0f} million fibre segments in cells that differ, too many to "
      "show fibres, for which there may be {:.0f} million.",
      1e-6 * static_cast<double>(counts.segments), 1e-6 * static_cast<double>(kMostSegments));
}

std::shared_ptr<const FibreBricks> FibreBricks::of(const ClothVolume& volume,
                                                   std::shared_ptr<const ClothGeometry> geometry) {
  if (!whyNone(volume.counts()).empty()) return nullptr;
  return std::shared_ptr<const FibreBricks>(new FibreBricks(std::move(geometry)));
}

FibreBricks::FibreBricks(std::shared_ptr<const ClothGeometry> geometry)
    : geometry_(std::move(geometry)), thinnest_mm_(2 * static_cast<float>(geometry_->yarns().minFibreRadius_mm())) {}
FibreBricks::~FibreBricks() = default;

size_t FibreBricks::made() const {
  const std::lock_guard lock(mutex_);
  return bricks_.size();
}

size_t FibreBricks::bytes() const {
  const size_t curves = bytesOfCurves_;  // of finished bricks: where there are any, the device is there
  return curves == 0 ? 0 : curves + device_->bytes();
}

const FibreBricks::Brick& FibreBricks::brick(const YarnCellKey& key) const {
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

std::unique_ptr<const FibreBricks::Brick> FibreBricks::make(const YarnCellKey& key) const {
  std::call_once(started_, [this] { device_ = std::make_unique<EmbreeDevice>(); });
  auto brick = std::make_unique<Brick>(
      CurveRuns(geometry_->strands(key), [&](glm::vec3 usz) { return inCloth(usz, key.system, glm::vec2(0)); }));
  RTCGeometry curves = brick->curves.geometry(*device_);
  brick->scene = rtcNewScene(*device_);
  // Embree then lets a leaf hold several runs, which takes a quarter of the memory of one each, and less time to make.
  rtcSetSceneBuildQuality(brick->scene, RTC_BUILD_QUALITY_LOW);
  rtcAttachGeometry(brick->scene, curves);
  rtcReleaseGeometry(curves);
  // On one thread: many bricks are made side by side, and this thread may not take up other work while it waits for
  // Embree, which could come to wait for this very brick.
  device_->commit(brick->scene, 1);
  if (rtcGetDeviceError(*device_) != RTC_ERROR_NONE) throw std::bad_alloc();
  RTCBounds bounds;
  rtcGetSceneBounds(brick->scene, &bounds);
  brick->lower = {bounds.lower_x, bounds.lower_y, bounds.lower_z};
  brick->upper = {bounds.upper_x, bounds.upper_y, bounds.upper_z};
  bytesOfCurves_ += brick->curves.bytes();
  return brick;
}

const FibreBricks::Reader::Cell& FibreBricks::Reader::at(glm::ivec3 cell) {
  return cells_.at(cell, [&](Cell& reaching) { gather(cell, reaching); });
}

/// The bricks that reach into a cell, with the places of their own cells.
void FibreBricks::Reader::gather(glm::ivec3 cell, Cell& reaching) const {
  const ClothGeometry& geometry = volume_.geometry();
  const ClothVolume::CellBricks bricks = volume_.bricksIn(cell);
  reaching.count = bricks.count;
  for (int i = 0; i < bricks.count; ++i) {
    const ClothVolume::CellBricks::Brick& of = bricks.bricks[i];
    const bool warp = of.system == System::warp;
    const int end = warp ? of.index : cell.x, pick = warp ? cell.y : of.index;
    reaching.bricks[i] = {&bricks_.brick(geometry.key(of.system, pick, end)),
                          {(end - cell.x + 0.5) * geometry.warpPitch_mm(),
                           (pick - cell.y + 0.5) * geometry.weftPitch_mm(), -volume_.grid().zLower_mm},
                          of.system,
                          end,
                          pick};
  }
}

template <class Visit>
void FibreBricks::Reader::forEachCell(const ClothRay& ray, const Visit& visit) {
  const ClothGeometry& geometry = volume_.geometry();
  ClothVolume::CellMarch march(volume_, ray.origin, ray.direction, ray.t0, ray.t1);
  if (!march.inPiece()) return;
  const double size_mm[2] = {geometry.warpPitch_mm(), geometry.weftPitch_mm()};
  for (float from = march.enter();;) {
    const glm::vec3 start = march.start_mm();
    float to = march.leave();
    int through = -1;
    for (int axis = 0; axis < 2; ++axis) {
      if (ray.direction[axis] == 0) continue;
      const auto face = static_cast<float>(ray.direction[axis] > 0 ? size_mm[axis] : 0.0);
      const float t = (face - start[axis]) / ray.direction[axis];
      if (t >= to) continue;
      to = t;
      through = axis;
    }
    to = std::max(to, from);
    if (visit(at(march.cell()), start + from * ray.direction, from, to)) return;
    if (through < 0 || !march.leaveCell(through)) return;
    from = to;
  }
}

std::optional<FibreHit> FibreBricks::Reader::meet(const ClothRay& ray) {
  std::optional<FibreHit> nearest;
  forEachCell(ray, [&](const Cell& cell, glm::vec3 entry, float from, float to) {
    for (int i = 0; i < cell.count; ++i) {
      const Cell::Reaching& of = cell.bricks[i];
      const float length = (nearest ? nearest->distance_mm : to) - from;
      const RTCRay asked = embree::rayOf(entry - of.centre_mm, ray.direction, 0, length);
      if (!of.brick->isOn(asked)) continue;
      Query query(of, ray, from);
      const RTCRayHit met = embree::nearestHit(of.brick->scene, query.embree, asked);
      if (!embree::isHit(met)) continue;
      const RTCHit& hit = met.hit;
      nearest = {from + met.ray.tfar,
                 glm::normalize(glm::vec3(hit.Ng_x, hit.Ng_y, hit.Ng_z)),
                 of.brick->curves.tangent(hit.primID),
                 of.brick->curves.radius_mm(hit.primID),
                 of.system,
                 of.end,
                 of.pick,
                 of.brick->fibre(of, hit.primID)};
    }
    return nearest.has_value();
  });
  return nearest;
}

bool FibreBricks::Reader::isFree(const ClothRay& ray) {
  bool free = true;
  forEachCell(ray, [&](const Cell& cell, glm::vec3 entry, float from, float to) {
    for (int i = 0; i < cell.count && free; ++i) {
      const Cell::Reaching& of = cell.bricks[i];
      const RTCRay asked = embree::rayOf(entry - of.centre_mm, ray.direction, 0, to - from);
      if (!of.brick->isOn(asked)) continue;
      Query query(of, ray, from);
      free = embree::isFree(of.brick->scene, query.embree, asked);
    }
    return !free;
  });
  return free;
}

}  // namespace loomlight
