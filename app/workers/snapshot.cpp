#include "app/workers/snapshot.h"

#include <algorithm>

#include "app/workers/file_name.h"
#include "app/workers/picture.h"
#include "render/trace/make_medium.h"
#include "render/trace/path_tracer.h"
#include "render/trace/scene.h"

namespace loomlight {

bool writeSnapshot(const std::shared_ptr<const Fabric>& fabric, const std::string& file, const Tone& tone,
                   const SnapshotPrint& print, const Task& task) {
  constexpr double kBuildShare = 0.1;  // of the progress
  checkPictureName(file);
  Task build = task;
  build.progress = [&task](double fraction) { task.report(kBuildShare * fraction); };
  const auto scene = makeScene(fabric, build);
  if (!scene) return false;
  const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), build);
  if (!medium) return false;

  Task trace = task;
  trace.progress = nullptr;
  const RenderSettings& settings = fabric->render;
  Film film(settings.width, settings.height);
  const CameraRays camera(fabric->camera, settings.width, settings.height);
  const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
  for (uint32_t done = 0; done < samples;) {
    done = std::min(samples, done + std::max(1u, samples / 64));
    if (!renderUpTo(done, *scene, *medium, camera, film, trace).complete) return false;
    task.report(kBuildShare + (1 - kBuildShare) * done / samples);
  }
  if (lowerExtension(file) == ".png")
    writePng(file, print.finish ? print.finish(toPixels(film, tone)) : toPixels(film, tone), pngTexts(*fabric),
             print.dpi);
  else
    writePicture(file, film, *fabric, tone, false, print.dpi);
  return true;
}

}  // namespace loomlight
