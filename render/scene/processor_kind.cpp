#include "render/scene/processor_kind.h"

#include <fmt/format.h>

#include <bit>
#include <limits>
#include <new>

#include "core/base/hash.h"
#include "core/base/random.h"
#include "render/scene/embree_device.h"
#include "render/scene/round_curves.h"

// How it works. Embree has kernels for several instruction sets, and they start from the processor's estimates of
// 1 / x and 1 / sqrt(x), which differ by maker and with AVX-512. No name of a processor says which of these round alike
// (up to AVX they do, AVX2 and AVX-512 each stand alone), so the kernels are asked: a kind is a digest of where some
// thousand rays meet a tangle of curves. It tells versions of Embree apart that round otherwise.

namespace loomlight {
namespace {

glm::vec3 pointInCube(Random& random) {
  return {random.uniform(), random.uniform(), random.uniform()};
}

/// Strands that go to and fro in a cube of a millimetre.
RoundCurves tangle(Random& random) {
  constexpr uint32_t kStrands = 32, kPoints = 8;
  CellStrands cell;
  cell.fibreRadius_mm = 0.02f;
  for (uint32_t strand = 0; strand < kStrands; ++strand) {
    cell.strands.push_back({strand * kPoints, kPoints});
    for (uint32_t i = 0; i < kPoints; ++i) cell.points.push_back(pointInCube(random));
  }
  RoundCurves curves;
  curves.add(cell, [](glm::vec3 point) { return point; });
  return curves;
}

/// Where a ray from about the cube, towards a point in it, meets the scene.
uint64_t digestOfRay(RTCScene scene, Random& random) {
  const glm::vec3 from = 3.0f * pointInCube(random) - 1.0f, to = pointInCube(random);
  const RTCRay ray = embree::rayOf(from, glm::normalize(to - from), 0, std::numeric_limits<float>::infinity());
  embree::QueryContext context;
  embree::initialise(context);
  const RTCRayHit met = embree::nearestHit(scene, context, ray);
  uint64_t digest = met.hit.geomID;
  for (const float value : {met.ray.tfar, met.hit.Ng_x, met.hit.Ng_y, met.hit.Ng_z})
    digest = hashCombine(digest, std::bit_cast<uint32_t>(value));
  return digest;
}

}  // namespace

std::string processorKind() {
  constexpr int kRays = 4096;
  Random random(1);
  const EmbreeDevice device;
  const RoundCurves curves = tangle(random);
  const RTCScene scene = rtcNewScene(device);
  const RTCGeometry geometry = curves.geometry(device, nullptr, nullptr);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  device.commit(scene, 1);
  const bool failed = rtcGetDeviceError(device) != RTC_ERROR_NONE;
  uint64_t digest = 0;
  for (int ray = 0; ray < kRays && !failed; ++ray) digest = hashCombine(digest, digestOfRay(scene, random));
  rtcReleaseScene(scene);
  if (failed) throw std::bad_alloc();
  return fmt::format("{:016x}", digest);
}

}  // namespace loomlight
