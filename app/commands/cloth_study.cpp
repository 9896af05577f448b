#include "app/commands/cloth_study.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "render/metrics/comparison.h"
#include "render/trace/path_tracer.h"

namespace loomlight {
namespace {

/// The same cloth in another light and with another pattern of noise.
std::shared_ptr<const Scene> relit(const Scene& scene, const Light& light, uint64_t seed, const Task& task) {
  Fabric fabric = *scene.fabric;
  fabric.light = light;
  fabric.render.seed = seed;
  return makeScene(std::make_shared<const Fabric>(std::move(fabric)), task, &scene);
}

LinearPicture middleOf(const Film& film, double part) {
  LinearPicture middle;
  middle.width = std::max(1, static_cast<int>(film.width() * part));
  middle.height = std::max(1, static_cast<int>(film.height() * part));
  const int x0 = (film.width() - middle.width) / 2, y0 = (film.height() - middle.height) / 2;
  for (int y = 0; y < middle.height; ++y)
    for (int x = 0; x < middle.width; ++x) middle.pixels.push_back(film.mean(x0 + x, y0 + y));
  return middle;
}

PicturePair pairOf(const Film& picture, const Film& reference, double part) {
  return {middleOf(picture, part), middleOf(reference, part), "picture", "reference"};
}

}  // namespace

std::optional<PreparedCloth> prepare(Fabric fabric, const Variant& variant, double memoryLimit_bytes,
                                     const Task& task) {
  fabric.render.method = variant.method;
  fabric.render.estimator = variant.estimator;
  fabric.render.resolution = variant.resolution;
  PreparedCloth cloth{variant, nullptr, nullptr};
  CpuStopwatch watch;
  cloth.scene = makeScene(std::make_shared<const Fabric>(std::move(fabric)), task);
  if (!cloth.scene) return std::nullopt;
  // Once more, alone: a scene has lights and lobes to make as well.
  const ClothGeometry& geometry = cloth.scene->volume->geometry();
  watch.lap();
  const auto copy = std::make_shared<const ClothGeometry>(*cloth.scene->fabric, geometry.ends(), geometry.picks());
  if (!ClothVolume::build(copy, variant.resolution, task)) return std::nullopt;
  const double volume_s = watch.lap();
  MediumCost cost;
  cloth.medium = makeMedium(*cloth.scene, memoryLimit_bytes, task, &cost);
  if (!cloth.medium) return std::nullopt;
  const double medium_s = watch.lap();

  const VolumeCounts volume = cloth.scene->volume->counts();
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
                                                      const Task& task) {
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
        const auto samples = static_cast<uint32_t>((settings.samplesPerPixel * turn + kTurns - 1) / kTurns);
        const CameraRays camera(scene.fabric->camera, settings.width, settings.height);
        CpuStopwatch watch;
        const PassResult pass = renderUpTo(samples, scene, *cloths[i].medium, camera, pictures[i].films[k], task);
        pictures[i].render_s += watch.lap();
        pictures[i].counts += pass.counts;
        if (!pass.complete) return std::nullopt;
      }
  return pictures;
}

StudyErrors errorsOf(const TwoPictures& pictures, const TwoPictures& reference, int threads, double part) {
  const PicturePair first = pairOf(pictures.films[0], reference.films[0], part);
  const PicturePair second = pairOf(pictures.films[1], reference.films[1], part);
  StudyErrors errors;
  const double bias = noiseFreeBias(first, second);
  errors.rms_percent = 100 * std::copysign(std::sqrt(std::abs(bias)), bias);
  const Comparison one = compare(first, Viewing{}, threads), two = compare(second, Viewing{}, threads);
  errors.flip = 0.5 * (one.flipMean + two.flipMean);
  errors.mean_percent = 0.5 * (one.meanDifference_percent() + two.meanDifference_percent());
  return errors;
}

}  // namespace loomlight
