#include "render/scene/fibre_bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <stdexcept>

#include "core/base/parallel.h"
#include "render/scene/embree_device.h"
#include "render/scene/yarn_curves.h"

// How it works. The fibres of each end and each pick are one Embree geometry of round linear curves, bent by the drape
// when they are laid. A flat piece of many repeats has one repeat laid and the rest as instances of it. Rays are
// answered through a filter: a surface counts only from outside; not the surface of the fibre that the ray has just
// left, within its clearance; and not what the last instances have beyond the edge of the piece.

namespace loomlight {
namespace {

/// What the filter needs to know of a ray, behind Embree's own context.
struct RayContext {
  explicit RayContext(const FibreRay& fibreRay) : ray(&fibreRay) { embree::initialise(embree); }
  embree::QueryContext embree;  ///< first, so that Embree's pointer to it is a pointer to the whole
  const FibreRay* ray;
};

/// A fibre as copies know it: where its yarn is in the whole piece.
struct PlacedFibre {
  const YarnCurves& yarn;
  uint32_t segment;
  int across;     ///< which end (warp) or pick (weft) it belongs to
  int firstCell;  ///< crossing of the piece at which the curves begin
};

}  // namespace

struct FibreBvh::Impl {
  Impl(std::shared_ptr<const TraceData> c, const FibreSize& z) : cloth(std::move(c)), size(z) {}
  ~Impl() {
    if (piece) rtcReleaseScene(piece);
    if (laid) rtcReleaseScene(laid);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool lay(const Task& task);
  void attach(unsigned id);
  bool attachCopies(const Task& task);
  bool commit(RTCScene of, const Task& task, double from, double to) const;

  PlacedFibre placed(const RTCHit& hit) const;
  bool isInPiece(const PlacedFibre& fibre) const;
  uint64_t idOf(const PlacedFibre& fibre) const;
  static void filter(const RTCFilterFunctionNArguments* args);

  const std::shared_ptr<const TraceData> cloth;
  const FibreSize size;
  std::vector<YarnCurves> yarns;  ///< ends, then picks; each one Embree geometry
  std::optional<EmbreeDevice> device;
  RTCScene laid = nullptr;   ///< the crossings that are laid
  RTCScene piece = nullptr;  ///< what rays are asked of: `laid` itself, or its copies
};

bool FibreBvh::Impl::lay(const Task& task) {
  for (int end = 0; end < size.ends; ++end) yarns.emplace_back(System::warp, end);
  for (int pick = 0; pick < size.picks; ++pick) yarns.emplace_back(System::weft, pick);
  const ClothToWorld toWorld(*cloth->shell);
  std::atomic<size_t> done{0};
  parallelFor(yarns.size(), task.threads, [&](size_t i) {
    const int cells = yarns[i].system() == System::warp ? size.picks : size.ends;
    if (!yarns[i].lay(cloth->volume->geometry(), cells, toWorld, task)) return;
    task.report(0.5 * static_cast<double>(++done) / static_cast<double>(yarns.size()));
  });
  return !task.stopped();
}

void FibreBvh::Impl::attach(unsigned id) {
  const YarnCurves& yarn = yarns[id];
  if (yarn.curves().segments().empty()) return;
  RTCGeometry curves = yarn.curves().geometry(*device, filter, this);
  rtcAttachGeometryByID(laid, curves, id);
  rtcReleaseGeometry(curves);
}

/// False when stopped.
bool FibreBvh::Impl::attachCopies(const Task& task) {
  const ClothGeometry& geometry = cloth->volume->geometry();
  for (int y = 0; y < size.copies.y; ++y) {
    if (task.stopped()) return false;
    for (int x = 0; x < size.copies.x; ++x) {
      RTCGeometry copy = rtcNewGeometry(*device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(copy, laid);
      const float placed[12] = {1,
                                0,
                                0,
                                0,
                                1,
                                0,
                                0,
                                0,
                                1,  // columns; the last one is where it stands
                                static_cast<float>(x * size.ends * geometry.warpPitch_mm()),
                                static_cast<float>(y * size.picks * geometry.weftPitch_mm()),
                                0};
      rtcSetGeometryTransform(copy, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, placed);
      rtcCommitGeometry(copy);
      rtcAttachGeometryByID(piece, copy, static_cast<unsigned>(y * size.copies.x + x));
      rtcReleaseGeometry(copy);
    }
  }
  return true;
}

/// False when stopped. Progress goes on from one fraction to the other.
bool FibreBvh::Impl::commit(RTCScene of, const Task& task, double from, double to) const {
  struct Monitor {
    const Task& task;
    double from, to;
  } monitor{task, from, to};
  rtcSetSceneFlags(of, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneProgressMonitorFunction(
      of,
      [](void* user, double fraction) {
        const auto& m = *static_cast<const Monitor*>(user);
        if (m.task.stopped()) return false;
        m.task.report(m.from + (m.to - m.from) * std::clamp(fraction, 0.0, 1.0));
        return !m.task.stopped();
      },
      &monitor);
  device->commit(of, task.threads);
  rtcSetSceneProgressMonitorFunction(of, nullptr, nullptr);
  switch (rtcGetDeviceError(*device)) {
    case RTC_ERROR_NONE:
      return !task.stopped();
    case RTC_ERROR_CANCELLED:
      return false;
    case RTC_ERROR_OUT_OF_MEMORY:
      throw std::bad_alloc();
    default:
      throw std::runtime_error("Embree could not build the fibres");
  }
}

PlacedFibre FibreBvh::Impl::placed(const RTCHit& hit) const {
  const YarnCurves& curves = yarns[hit.geomID];
  glm::ivec2 copy(0);
  if (const unsigned instance = hit.instID[0]; instance != RTC_INVALID_GEOMETRY_ID)
    copy = {static_cast<int>(instance) % size.copies.x, static_cast<int>(instance) / size.copies.x};
  const int end = copy.x * size.ends, pick = copy.y * size.picks;
  const bool warp = curves.system() == System::warp;
  return {curves, hit.primID, curves.index() + (warp ? end : pick), warp ? pick : end};
}

/// The last copies may reach beyond the piece.
bool FibreBvh::Impl::isInPiece(const PlacedFibre& fibre) const {
  const ClothGeometry& geometry = cloth->volume->geometry();
  const bool warp = fibre.yarn.system() == System::warp;
  const int yarnCount = warp ? geometry.ends() : geometry.picks(), cells = warp ? geometry.picks() : geometry.ends();
  return fibre.across < yarnCount && fibre.segment < fibre.yarn.segmentsBefore(cells - fibre.firstCell);
}

uint64_t FibreBvh::Impl::idOf(const PlacedFibre& fibre) const {
  return fibreNumber(fibre.yarn.system(), fibre.across, fibre.yarn.curves().strandOf(fibre.segment));
}

/// Surfaces count from outside only, and not the fibre's own where the ray has just left it.
void FibreBvh::Impl::filter(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const FibreRay& from = *reinterpret_cast<const RayContext*>(args->context)->ray;
  const auto& impl = *static_cast<const Impl*>(args->geometryUserPtr);
  const bool mayBeOwn = ray->tfar < from.clearance_mm;
  if (RoundCurves::isFromInside(*args)) {
    args->valid[0] = 0;
  } else if (mayBeOwn || !impl.size.isWholePiece()) {
    const PlacedFibre fibre = impl.placed(*hit);
    if ((mayBeOwn && impl.idOf(fibre) == from.ownFibre) || !impl.isInPiece(fibre)) args->valid[0] = 0;
  }
}

FibreBvh::FibreBvh(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FibreBvh::~FibreBvh() = default;

std::unique_ptr<const FibreBvh> FibreBvh::build(std::shared_ptr<const TraceData> cloth, const FibreSize& size,
                                                const Task& task) {
  auto impl = std::make_unique<Impl>(std::move(cloth), size);
  if (!impl->lay(task)) return nullptr;
  impl->device.emplace();
  impl->laid = rtcNewScene(*impl->device);
  for (unsigned id = 0; id < impl->yarns.size(); ++id) {
    if (task.stopped()) return nullptr;
    impl->attach(id);
  }
  constexpr double kLaid = 0.5;
  const double built = size.isWholePiece() ? 1 : 0.95;
  if (!impl->commit(impl->laid, task, kLaid, built)) return nullptr;
  if (size.isWholePiece()) {
    rtcRetainScene(impl->laid);
    impl->piece = impl->laid;
  } else {
    impl->piece = rtcNewScene(*impl->device);
    if (!impl->attachCopies(task) || !impl->commit(impl->piece, task, built, 1)) return nullptr;
  }
  task.report(1);
  return std::unique_ptr<const FibreBvh>(new FibreBvh(std::move(impl)));
}

std::optional<FibreHit> FibreBvh::meet(const FibreRay& ray) const {
  RayContext context(ray);
  const RTCRay asked = embree::rayOf(ray.origin, ray.direction, 0, ray.length_mm);
  const RTCRayHit met = embree::nearestHit(impl_->piece, context.embree, asked);
  if (!embree::isHit(met)) return std::nullopt;
  const PlacedFibre fibre = impl_->placed(met.hit);
  const YarnCurves& yarn = fibre.yarn;
  FibreHit hit;
  hit.distance_mm = met.ray.tfar;
  hit.normal = glm::normalize(glm::vec3(met.hit.Ng_x, met.hit.Ng_y, met.hit.Ng_z));
  hit.tangent = yarn.curves().tangent(fibre.segment);
  hit.radius_mm = yarn.curves().radius_mm(fibre.segment);
  hit.system = yarn.system();
  const int cell = fibre.firstCell + yarn.cellOf(fibre.segment);
  hit.end = yarn.system() == System::warp ? fibre.across : cell;
  hit.pick = yarn.system() == System::warp ? cell : fibre.across;
  hit.fibre = impl_->idOf(fibre);
  return hit;
}

bool FibreBvh::isFree(const FibreRay& ray) const {
  RayContext context(ray);
  return embree::isFree(impl_->piece, context.embree, embree::rayOf(ray.origin, ray.direction, 0, ray.length_mm));
}

size_t FibreBvh::segments() const {
  size_t sum = 0;
  for (const YarnCurves& yarn : impl_->yarns) sum += yarn.curves().segments().size();
  return sum;
}

size_t FibreBvh::geometryBytes() const {
  size_t sum = 0;
  for (const YarnCurves& yarn : impl_->yarns) sum += yarn.bytes();
  return sum;
}

size_t FibreBvh::acceleratorBytes() const {
  return impl_->device->bytes();
}

}  // namespace loomlight
