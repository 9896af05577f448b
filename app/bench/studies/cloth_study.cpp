#include "app/bench/studies/cloth_study.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/colour/tone.h"
#include "render/media/report_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// The middle of the mean of some films.
LinearPicture middleOf(std::initializer_list<const Film*> films, double part) {
  const Film& first = **films.begin();
  LinearPicture middle;
  middle.width = std::max(1, static_cast<int>(first.width() * part));
  middle.height = std::max(1, static_cast<int>(first.height() * part));
  const int x0 = (first.width() - middle.width) / 2, y0 = (first.height() - middle.height) / 2;
  for (int y = 0; y < middle.height; ++y)
    for (int x = 0; x < middle.width; ++x) {
      Rgb sum(0);
      for (const Film* film : films) sum += film->mean(x0 + x, y0 + y);
      middle.pixels.push_back(sum / static_cast<float>(films.size()));
    }
  return middle;
}

PicturePair pairOf(const TwoPictures& pictures, const TwoPictures& reference, size_t which, double part) {
  return {middleOf({&pictures.films[which]}, part), middleOf({&reference.films[which]}, part), "picture", "reference"};
}

}  // namespace

Fabric variantOf(Fabric fabric, const Variant& variant) {
  fabric.render.method = variant.method;
  fabric.render.estimator = variant.estimator;
  fabric.render.resolution = variant.resolution;
  return fabric;
}

std::unique_ptr<const Medium> mediumOf(const Scene& scene, const Variant& variant, const ReportBench& bench,
                                       const Task& task, MediumCost& cost) {
  if (variant.method == Method::volume && variant.estimator == Estimator::loomlight && !variant.closeUps)
    return std::make_unique<const LoomlightMedium>(scene.cloth, variant.ingredients);
  if (variant.method == Method::volume && variant.estimator == Estimator::report) {
    BvdfOptions options;
    if (bench.quick) options.rays = 200'000;
    auto bvdf = bakeBvdf(*scene.fabric, options, BvdfCache(BvdfCache::userFolder()), task);
    if (!bvdf) return nullptr;
    cost.bvdfBytes = bvdf->bytes();
    return std::make_unique<const ReportMedium>(scene.cloth, std::move(bvdf));
  }
  // Never a repeat of it: the very fibres that the volume was made of.
  return makeMedium(scene, {bench.memoryLimit_bytes, FibreExtent::wholePiece}, task, &cost);
}

std::shared_ptr<const Scene> relit(const Scene& scene, const Light& light, uint64_t seed, const Task& task) {
  Fabric fabric = *scene.fabric;
  fabric.light = light;
  fabric.render.seed = seed;
  return makeScene(std::make_shared<const Fabric>(std::move(fabric)), task, &scene);
}

std::optional<PreparedCloth> prepare(const Fabric& fabric, const Variant& variant, const ReportBench& bench,
                                     const Task& task) {
  PreparedCloth cloth{variant, nullptr, nullptr};
  CpuStopwatch watch;
  cloth.scene = makeScene(std::make_shared<const Fabric>(variantOf(fabric, variant)), task);
  if (!cloth.scene) return std::nullopt;
  // Again, alone: a scene has lights and lobes to make as well. Often enough to be measured: it is over in no time.
  const double leastTime_s = bench.quick ? 0 : 0.5;
  const ClothGeometry& geometry = cloth.scene->cloth->volume->geometry();
  double volume_s = 0;
  int volumes = 0;
  for (watch.lap(); volumes == 0 || volume_s < leastTime_s; ++volumes) {
    const auto copy = std::make_shared<const ClothGeometry>(*cloth.scene->fabric, geometry.ends(), geometry.picks());
    if (!ClothVolume::build(copy, variant.resolution, task)) return std::nullopt;
    volume_s += watch.lap();
  }
  volume_s /= volumes;
  MediumCost cost;
  cloth.medium = mediumOf(*cloth.scene, variant, bench, task, cost);
  if (!cloth.medium) return std::nullopt;
  const double medium_s = watch.lap();

  const VolumeCounts volume = cloth.scene->cloth->volume->counts();
  if (variant.method == Method::fibres) {
    cloth.elements = cloth.segmentsMade = static_cast<double>(cost.segments);
    cloth.bytes = static_cast<double>(cost.geometryBytes + cost.acceleratorBytes);
    cloth.construction_s = medium_s;
  } else {
    cloth.elements = static_cast<double>(volume.voxels);
    cloth.segmentsMade = static_cast<double>(volume.segments);
    cloth.bytes = static_cast<double>(volume.bytes + cost.bvdfBytes);
    cloth.construction_s = volume_s;
  }
  return cloth;
}

std::optional<std::vector<TwoPictures>> renderInTurns(const std::vector<PreparedCloth>& cloths, const Light& light,
                                                      int samples, const Task& task) {
  constexpr int kTurns = 4;
  std::vector<TwoPictures> pictures;
  std::vector<std::array<std::shared_ptr<const Scene>, 2>> scenes;
  for (const PreparedCloth& cloth : cloths) {
    const RenderSettings& settings = cloth.scene->fabric->render;
    pictures.push_back({{Film(settings.width, settings.height), Film(settings.width, settings.height)}, 0, {}});
    const uint64_t seed = settings.seed;
    scenes.push_back({relit(*cloth.scene, light, seed, task), relit(*cloth.scene, light, seed + 1, task)});
    if (!scenes.back()[0] || !scenes.back()[1]) return std::nullopt;
  }
  for (int turn = 1; turn <= kTurns; ++turn)
    for (size_t i = 0; i < cloths.size(); ++i)
      for (int k = 0; k < 2; ++k) {
        const Scene& scene = *scenes[i][k];
        const RenderSettings& settings = scene.fabric->render;
        const auto reached = static_cast<uint32_t>((samples * turn + kTurns - 1) / kTurns);
        const CameraRays camera(scene.fabric->camera, settings.width, settings.height);
        CpuStopwatch watch;
        const PassResult pass = renderUpTo(reached, scene, *cloths[i].medium, camera, pictures[i].films[k], task);
        pictures[i].render_s += watch.lap();
        pictures[i].counts += pass.counts;
        if (!pass.complete) return std::nullopt;
      }
  return pictures;
}

Estimate squaredDifference(const TwoPictures& pictures, const TwoPictures& reference, double part) {
  return noiseFreeBiasEstimate(pairOf(pictures, reference, 0, part), pairOf(pictures, reference, 1, part));
}

StudyErrors errorsOf(const TwoPictures& pictures, const TwoPictures& reference, int threads, double part) {
  const Comparison means = compare({middleOf({&pictures.films[0], &pictures.films[1]}, part),
                                    middleOf({&reference.films[0], &reference.films[1]}, part), "picture", "reference"},
                                   Viewing{}, threads);
  const double bias = squaredDifference(pictures, reference, part).value;
  return {means.meanDifference_percent(), 100 * std::copysign(std::sqrt(std::abs(bias)), bias), means.flipMean};
}

Pixels8 shown(const TwoPictures& pictures) {
  Film both = pictures.films[0];
  both.merge(pictures.films[1]);
  return toPixels(both, Tone{});
}

}  // namespace loomlight
