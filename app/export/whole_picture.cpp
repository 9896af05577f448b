#include "app/export/whole_picture.h"

#include <algorithm>
#include <utility>

#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {

std::optional<WholePicture> renderWhole(std::shared_ptr<const Fabric> fabric, const FibreOptions& fibres,
                                        const Task& task) {
  constexpr double kBuildShare = 0.1;  // of the progress
  constexpr uint32_t kBatches = 64;
  Task building = task;
  building.progress = [&task](double fraction) { task.report(kBuildShare * fraction); };
  const auto scene = makeScene(fabric, building);
  const auto medium = scene ? makeMedium(*scene, fibres, building) : nullptr;
  if (!medium) return std::nullopt;

  const RenderSettings& settings = fabric->render;
  WholePicture picture{scene, Film(settings.width, settings.height)};
  const CameraRays camera(fabric->camera, settings.width, settings.height);
  Task tracing = task;
  tracing.progress = nullptr;
  const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
  for (uint32_t done = 0; done < samples;) {
    done = std::min(samples, done + std::max(1u, samples / kBatches));
    if (!renderUpTo(done, *scene, *medium, camera, picture.film, tracing).complete) return std::nullopt;
    task.report(kBuildShare + (1 - kBuildShare) * done / samples);
  }
  return picture;
}

}  // namespace loomlight
