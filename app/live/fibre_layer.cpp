#include "app/live/fibre_layer.h"

#include <atomic>
#include <exception>

#include "render/media/fibre_medium.h"

namespace loomlight {

FibreLayer::FibreLayer(std::function<void()> wake, std::function<void(Traceable)> deliver, int threads)
    : wake_(std::move(wake)), deliver_(std::move(deliver)), threads_(threads) {
  thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

FibreLayer::~FibreLayer() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  stop_.request_stop();
}

void FibreLayer::lay(std::shared_ptr<const Scene> scene, double limit_bytes) {
  {
    std::lock_guard lock(mutex_);
    if (wanted_ && limit_bytes == limit_bytes_ && wanted_->cloth == scene->cloth) return;
  }
  post(std::move(scene), limit_bytes);
}

void FibreLayer::clear() {
  {
    std::lock_guard lock(mutex_);
    if (!wanted_) return;
  }
  post(nullptr, 0);
}

void FibreLayer::post(std::shared_ptr<const Scene> scene, double limit_bytes) {
  Wish wish{std::move(scene), limit_bytes, {}};
  {
    std::lock_guard lock(mutex_);
    wanted_ = wish.scene;
    limit_bytes_ = limit_bytes;
    stop_.request_stop();
    stop_ = std::stop_source();
    wish.stop = stop_.get_token();
  }
  wishes_.post(std::move(wish));
}

FibreLayer::Status FibreLayer::status() const {
  std::lock_guard lock(mutex_);
  return status_;
}

void FibreLayer::tell(const Wish& wish, const Status& status) {
  {
    std::lock_guard lock(mutex_);
    if (wish.stop.stop_requested()) return;  // of a wish that is no more
    status_ = status;
  }
  wake_();
}

void FibreLayer::loop(std::stop_token stop) {
  while (const auto wish = wishes_.wait(stop)) {
    try {
      fulfil(*wish);
    } catch (const std::exception& e) {
      Status status;
      status.phase = Status::Phase::failed;
      status.error = e.what();
      tell(*wish, status);
    }
  }
}

void FibreLayer::fulfil(const Wish& wish) {
  Status status;
  deliver_({});  // what was laid before may be gigabytes
  tell(wish, status);
  if (!wish.scene) return;
  const FibreOptions options(wish.limit_bytes);
  status.size = planFibres(*wish.scene->cloth, options);
  if (status.size.bytes > wish.limit_bytes) {
    status.size = planFibres(*wish.scene->cloth, {wish.limit_bytes, FibreExtent::wholePiece});
    status.phase = Status::Phase::tooLarge;
    tell(wish, status);
    return;
  }
  status.phase = Status::Phase::laying;
  tell(wish, status);

  Task task;
  task.stop = wish.stop;
  task.threads = threads_;
  constexpr int kSteps = 25;
  std::atomic<int> told{0};
  task.progress = [this, &wish, &status, &told](double fraction) {
    const int step = static_cast<int>(kSteps * fraction);
    if (told.exchange(step) == step) return;  // each wakes the window
    Status now = status;
    now.progress = fraction;
    tell(wish, now);
  };
  std::shared_ptr<const Medium> fibres = FibreMedium::build(wish.scene->cloth, options, task);
  if (!fibres) return;
  status.phase = Status::Phase::laid;
  deliver_({wish.scene, std::move(fibres)});
  tell(wish, status);
}

}  // namespace loomlight
