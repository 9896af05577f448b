#include "app/export/whole_picture.h"

#include <algorithm>
#include <utility>

#include "app/export/task_part.h"
#include "render/transport/make_medium.h"

namespace loomlight {

std::optional<Film> tracedFilm(const Scene& scene, const Medium& medium, const Task& task, FirstFibreSink* first) {
  constexpr uint32_t kBatches = 64;
  const RenderSettings& settings = scene.fabric->render;
  Film film(settings.width, settings.height);
  const CameraRays camera(scene.fabric->camera, settings.width, settings.height);
  const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
  for (uint32_t done = 0; done < samples;) {
    const double before = static_cast<double>(done) / samples;
    done = std::min(samples, done + std::max(1u, samples / kBatches));
    const Task batch = partOf(task, before, static_cast<double>(done) / samples);
    if (!renderUpTo(done, scene, medium, camera, film, batch, {.first = first}).complete) return std::nullopt;
  }
  return film;
}

std::optional<WholePicture> renderWhole(std::shared_ptr<const Fabric> fabric, const FibreOptions& fibres,
                                        const Task& task, const Tiling& tiling) {
  constexpr double kScene = 0.05, kBuilt = 0.1;  // of the progress, where they end
  const auto scene = makeScene(std::move(fabric), partOf(task, 0, kScene), SceneBase{nullptr, {}, tiling});
  const auto medium = scene ? makeMedium(*scene, fibres, partOf(task, kScene, kBuilt)) : nullptr;
  auto film = medium ? tracedFilm(*scene, *medium, partOf(task, kBuilt, 1)) : std::nullopt;
  if (!film) return std::nullopt;
  return WholePicture{scene, std::move(*film)};
}

}  // namespace loomlight
