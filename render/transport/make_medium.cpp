#include "render/transport/make_medium.h"

#include <algorithm>

#include "core/base/memory.h"
#include "core/base/stopwatch.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/media/report_medium.h"
#include "render/media/volume_medium.h"

namespace loomlight {
namespace {

std::unique_ptr<const Medium> makeFibres(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost& cost) {
  auto fibres = FibreMedium::build(scene, options, task);
  if (!fibres) return nullptr;
  cost.segments = fibres->segments();
  cost.geometryBytes = fibres->geometryBytes();
  cost.acceleratorBytes = fibres->acceleratorBytes();
  return fibres;
}

std::unique_ptr<const Medium> makeReport(const Scene& scene, const Task& task, MediumCost& cost) {
  auto bvdf = bakeBvdf(*scene.fabric, BvdfOptions{}, BvdfCache(BvdfCache::userFolder()), task);
  if (!bvdf) return nullptr;
  cost.bvdfBytes = bvdf->bytes();
  return std::make_unique<const ReportMedium>(scene, std::move(bvdf));
}

bool sameYarns(const std::vector<YarnOptics>& a, const std::vector<YarnOptics>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const YarnOptics& x, const YarnOptics& y) {
    return x.material == y.material && x.packed == y.packed && x.fibreRadius_mm == y.fibreRadius_mm;
  });
}

}  // namespace

double defaultMemoryLimit_bytes() {
  return 0.75 * static_cast<double>(physicalMemory_bytes());
}

std::unique_ptr<const Medium> makeMedium(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost* cost) {
  MediumCost own;
  Stopwatch watch;
  const RenderSettings& settings = scene.fabric->render;
  std::unique_ptr<const Medium> medium;
  if (settings.method == Method::fibres) {
    medium = makeFibres(scene, options, task, own);
    own.fibreSeconds = watch.lap();
  } else if (settings.estimator == Estimator::report) {
    medium = makeReport(scene, task, own);
    own.bvdfSeconds = watch.lap();
  } else if (settings.estimator == Estimator::loomlight) {
    medium = std::make_unique<const LoomlightMedium>(scene);
  } else {
    medium = std::make_unique<const VolumeMedium>(scene);
  }
  if (cost) *cost = own;
  return medium;
}

bool sameMedium(const Scene& a, const Scene& b) {
  const RenderSettings &x = a.fabric->render, &y = b.fabric->render;
  return a.volume == b.volume && a.shell == b.shell && x.method == y.method && x.estimator == y.estimator &&
         x.eventLaw == y.eventLaw && sameYarns(a.yarns[0], b.yarns[0]) && sameYarns(a.yarns[1], b.yarns[1]) &&
         std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                    [](const Material& m, const Material& n) { return m.bcsdf == n.bcsdf; });
}

}  // namespace loomlight
