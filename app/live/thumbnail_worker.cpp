#include "app/live/thumbnail_worker.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include "render/display/denoise.h"
#include "render/display/display_picture.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// With less noise than few samples leave. Single fibres are shown as they are once they are clear.
Pixels8 quietPicture(const Film& film, uint32_t samples, Method method) {
  constexpr uint32_t kClearSamples = 16;
  Frame frame;
  frame.width = film.width();
  frame.height = film.height();
  film.toDisplayBuffer(frame.rgba);
  if (method == Method::volume || samples < kClearSamples) {
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

ThumbnailWorker::ThumbnailWorker(std::function<void()> wake) : wake_(std::move(wake)) {
  thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

ThumbnailWorker::~ThumbnailWorker() = default;

void ThumbnailWorker::request(std::vector<ThumbnailOrder> orders) {
  orders_.post(std::move(orders));
}

std::shared_ptr<const Thumbnail> ThumbnailWorker::of(const std::string& name) const {
  std::lock_guard lock(mutex_);
  const auto found = done_.find(name);
  return found == done_.end() ? nullptr : found->second;
}

void ThumbnailWorker::publish(const std::string& name, std::shared_ptr<const Thumbnail> thumbnail) {
  {
    std::lock_guard lock(mutex_);
    done_[name] = std::move(thumbnail);
  }
  wake_();
}

/// False when stopped.
bool ThumbnailWorker::fulfil(const ThumbnailOrder& order, uint32_t samples, const Task& task) {
  const auto before = of(order.name);
  const bool same = before && *before->fabric == *order.fabric;
  if (same && (before->samples >= samples || !before->error.empty())) return true;
  auto thumbnail = std::make_shared<Thumbnail>();
  thumbnail->fabric = order.fabric;
  try {
    const auto scene = makeScene(order.fabric, task, scene_.get());
    if (!scene) return false;
    scene_ = scene;
    const auto medium = makeMedium(*scene, 0.25 * defaultMemoryLimit_bytes(), task);
    if (!medium) return false;
    const RenderSettings& settings = order.fabric->render;
    Film film(settings.width, settings.height);
    const CameraRays camera(order.fabric->camera, settings.width, settings.height);
    if (!renderUpTo(samples, *scene, *medium, camera, film, task).complete) return false;
    thumbnail->samples = samples;
    thumbnail->picture = quietPicture(film, samples, settings.method);
  } catch (const std::exception& e) {
    thumbnail->error = e.what();
  }
  publish(order.name, std::move(thumbnail));
  return true;
}

void ThumbnailWorker::loop(std::stop_token stop) {
  constexpr uint32_t kFewSamples = 1;
  std::optional<std::vector<ThumbnailOrder>> next;
  while (auto orders = next ? std::exchange(next, std::nullopt) : orders_.wait(stop)) {
    std::stop_source newer;
    const std::stop_callback withThread(stop, [&newer] { newer.request_stop(); });
    Task task;
    task.stop = newer.get_token();
    task.threads = 1;
    task.progress = [&](double) {
      if (!orders_.waiting()) return;
      next = orders_.take();
      newer.request_stop();
    };
    bool going = true;
    for (const bool first : {true, false})
      for (const ThumbnailOrder& order : *orders) {
        const auto wanted = static_cast<uint32_t>(order.fabric->render.samplesPerPixel);
        going = going && fulfil(order, first ? std::min(kFewSamples, wanted) : wanted, task);
      }
    if (stop.stop_requested()) return;
  }
}

}  // namespace loomlight
