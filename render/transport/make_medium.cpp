#include "render/transport/make_medium.h"

#include "core/base/checksum.h"
#include "core/base/hash.h"
#include "core/base/stopwatch.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/media/close_up_medium.h"
#include "render/media/fibre_medium.h"
#include "render/media/report_medium.h"
#include "render/media/volume_medium.h"

namespace loomlight {
namespace {

std::unique_ptr<const Medium> makeFibres(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost& cost) {
  auto fibres = FibreMedium::build(scene.cloth, options, task);
  if (!fibres) return nullptr;
  cost.segments = fibres->segments();
  cost.geometryBytes = fibres->geometryBytes();
  cost.acceleratorBytes = fibres->acceleratorBytes();
  return fibres;
}

uint64_t checksumOf(const BvdfSet& set) {
  uint64_t sum = 0;
  for (const Bvdf& table : set.tables) {
    const auto ratios = table.ratios();
    sum = hashCombine(sum, checksum({reinterpret_cast<const char*>(ratios.data()), ratios.size_bytes()}));
  }
  return sum;
}

std::unique_ptr<const Medium> makeReport(const Scene& scene, const Task& task, MediumCost& cost) {
  auto bvdf = bakeBvdf(*scene.fabric, BvdfOptions{}, BvdfCache(BvdfCache::userFolder()), task);
  if (!bvdf) return nullptr;
  cost.bvdfBytes = bvdf->bytes();
  cost.bvdfChecksum = checksumOf(*bvdf);
  return std::make_unique<const ReportMedium>(scene.cloth, std::move(bvdf));
}

}  // namespace

std::unique_ptr<const Medium> makeMedium(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost* cost) {
  MediumCost own;
  Stopwatch watch;
  std::unique_ptr<const Medium> medium;
  if (scene.cloth->method == Method::fibres) {
    medium = makeFibres(scene, options, task, own);
    own.fibreSeconds = watch.lap();
  } else if (scene.cloth->estimator == Estimator::report) {
    medium = makeReport(scene, task, own);
    own.bvdfSeconds = watch.lap();
  } else if (scene.cloth->estimator == Estimator::loomlight) {
    medium = std::make_unique<const CloseUpMedium>(scene.cloth);
  } else {
    medium = std::make_unique<const VolumeMedium>(scene.cloth);
  }
  if (cost) *cost = own;
  return medium;
}

}  // namespace loomlight
