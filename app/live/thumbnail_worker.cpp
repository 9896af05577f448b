#include "app/live/thumbnail_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/fabric/model/changes.h"
#include "render/display/denoise.h"
#include "render/display/display_picture.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// With less noise than few samples leave. Single fibres are shown as they are once they are clear.
Pixels8 quietPicture(const Film& film, uint32_t samples, Method method) {
  Frame frame;
  frame.width = film.width();
  frame.height = film.height();
  film.toDisplayBuffer(frame.rgba);
  if (method == Method::volume || samples < uint32_t{kClearSamples}) {
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        frame.hits.push_back(film.hit(x, y));
        if (samples > 1) frame.variances.push_back(film.variance(x, y));
      }
    denoise(frame.rgba, {frame.hits, frame.variances}, frame.width, frame.height, 1);
  }
  return displayPicture(frame, Tone{});
}

}  // namespace

ThumbnailWorker::ThumbnailWorker(std::function<void()> wake, Sketch sketch)
    : sketch_(std::move(sketch)),
      worker_(
          std::move(wake),
          [this](const Orders& orders, auto& job) {
            fulfil(orders, job);
            return std::nullopt;
          },
          [this](const Orders&, const std::string&) { return std::make_shared<const Thumbnails>(done_); }) {}

std::shared_ptr<const Thumbnail> ThumbnailWorker::of(const std::string& name) const {
  const auto done = worker_.newest();
  if (!done) return nullptr;
  const auto found = (*done)->find(name);
  return found == (*done)->end() ? nullptr : found->second;
}

/// Null when stopped. What cannot be rendered has its reason in the place of a picture.
std::shared_ptr<const Thumbnail> ThumbnailWorker::rendered(const ThumbnailOrder& order, uint32_t samples,
                                                           const Task& task) {
  auto thumbnail = std::make_shared<Thumbnail>();
  thumbnail->fabric = order.fabric;
  try {
    const auto scene = makeScene(order.fabric, task, scene_.get());
    if (!scene) return nullptr;
    scene_ = scene;
    const auto medium = makeMedium(*scene, 0.25 * defaultMemoryLimit_bytes(), task);
    if (!medium) return nullptr;
    const RenderSettings& settings = order.fabric->render;
    Film film(settings.width, settings.height);
    const CameraRays camera(order.fabric->camera, settings.width, settings.height);
    if (!renderUpTo(samples, *scene, *medium, camera, film, task).complete) return nullptr;
    thumbnail->samples = samples;
    thumbnail->picture = quietPicture(film, samples, settings.method);
  } catch (const std::exception&) {
    thumbnail->error = problemCaught();
  }
  return thumbnail;
}

void ThumbnailWorker::sketchMissing(const Orders& orders, Rendering::Job& job) {
  for (const ThumbnailOrder& order : orders) {
    if (job.isStopped()) return;
    std::shared_ptr<const Thumbnail>& thumbnail = done_[order.name];
    if (thumbnail) continue;
    thumbnail = std::make_shared<const Thumbnail>(Thumbnail{order.fabric, sketch_(*order.fabric), 0, ""});
    job.bring(std::make_shared<const Thumbnails>(done_));
  }
}

void ThumbnailWorker::fulfil(const Orders& orders, Rendering::Job& job) {
  constexpr uint32_t kFewSamples = 1;
  Task task;
  task.stop = job.stop();
  task.threads = 1;
  task.progress = [&](double) {
    if (worker_.isWaiting()) job.giveWay();
  };
  sketchMissing(orders, job);
  for (const bool first : {true, false})
    for (const ThumbnailOrder& order : orders) {
      const auto wanted = static_cast<uint32_t>(order.fabric->render.samplesPerPixel);
      const uint32_t samples = first ? std::min(kFewSamples, wanted) : wanted;
      const auto before = done_.find(order.name);
      const Thumbnail* old = before == done_.end() ? nullptr : before->second.get();
      const bool same = old && !changes(*old->fabric, *order.fabric).picture();
      if (same && (old->samples >= samples || !old->error.empty())) continue;
      auto thumbnail = rendered(order, samples, task);
      if (!thumbnail) return;
      done_[order.name] = std::move(thumbnail);
      job.bring(std::make_shared<const Thumbnails>(done_));
    }
}

}  // namespace loomlight
