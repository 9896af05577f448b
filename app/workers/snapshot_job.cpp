#include "app/workers/snapshot_job.h"

#include <algorithm>
#include <exception>

#include "app/workers/file_name.h"
#include "app/workers/picture.h"
#include "core/base/parallel.h"
#include "render/trace/make_medium.h"
#include "render/trace/path_tracer.h"
#include "render/trace/scene.h"

namespace loomlight {

struct SnapshotJob::Shared {
  std::shared_ptr<const Fabric> fabric;
  std::string file;
  Tone tone;
  Print print;
  mutable std::mutex mutex;
  State state;

  void report(double progress) {
    std::lock_guard lock(mutex);
    state.progress = progress;
  }

  /// Returns false when stopped.
  bool render(std::stop_token stop) {
    constexpr double kBuildShare = 0.1;  // of the progress bar
    checkPictureName(file);
    Task task;
    task.stop = stop;
    task.threads = std::max(1, hardwareThreads() - 1);  // the window keeps its core
    task.progress = [this](double fraction) { report(kBuildShare * fraction); };
    const auto scene = makeScene(fabric, task);
    if (!scene) return false;
    const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), task);
    if (!medium) return false;
    const RenderSettings& settings = fabric->render;
    Film film(settings.width, settings.height);
    const CameraRays camera(fabric->camera, settings.width, settings.height);
    const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
    for (uint32_t done = 0; done < samples;) {
      done = std::min(samples, done + std::max(1u, samples / 64));
      if (!renderUpTo(done, *scene, *medium, camera, film, task).complete) return false;
      report(kBuildShare + (1 - kBuildShare) * done / samples);
    }
    if (lowerExtension(file) == ".png")
      writePng(file, print.finish ? print.finish(toPixels(film, tone)) : toPixels(film, tone), pngTexts(*fabric),
               print.dpi);
    else
      writePicture(file, film, *fabric, tone, false);
    return true;
  }

  void run(std::stop_token stop) {
    std::string error;
    bool complete = false;
    try {
      complete = render(stop);
    } catch (const std::exception& e) {
      error = e.what();
    }
    std::lock_guard lock(mutex);
    state.finished = true;
    state.cancelled = !complete && error.empty();
    state.error = error;
  }
};

SnapshotJob::SnapshotJob(std::shared_ptr<const Fabric> fabric, std::string file, Tone tone, Print print)
    : shared_(std::make_shared<Shared>()) {
  shared_->fabric = std::move(fabric);
  shared_->file = std::move(file);
  shared_->tone = tone;
  shared_->print = std::move(print);
  thread_ = std::jthread([shared = shared_](std::stop_token stop) { shared->run(stop); });
}

SnapshotJob::~SnapshotJob() = default;

void SnapshotJob::cancel() {
  thread_.request_stop();
}

SnapshotJob::State SnapshotJob::state() const {
  std::lock_guard lock(shared_->mutex);
  return shared_->state;
}

}  // namespace loomlight
