#include "app/live/fibre_layer.h"

#include <atomic>
#include <utility>

#include "render/media/fibre_medium.h"

namespace loomlight {

FibreLayer::FibreLayer(std::function<void()> wake, std::function<void(Traceable)> deliver, int threads)
    : deliver_(std::move(deliver)),
      threads_(threads),
      worker_(
          std::move(wake), [this](const Wish& wish, const auto& job) { return fulfil(wish, job); },
          [](const Wish&, const std::string& problem) {
            Status status;
            status.phase = Status::Phase::failed;
            status.error = problem;
            return status;
          },
          Backlog::newest, Priority::picture) {}

void FibreLayer::lay(std::shared_ptr<const Scene> scene, double limit_bytes) {
  const bool isOfThisCloth = newest_.scene && newest_.scene->cloth == scene->cloth;
  if (!isOfThisCloth || limit_bytes != newest_.limit_bytes) post({std::move(scene), limit_bytes});
}

void FibreLayer::clear() {
  if (newest_.scene) post({});
}

void FibreLayer::post(Wish wish) {
  newest_ = wish;
  worker_.forget();
  worker_.ask(std::move(wish));
}

FibreLayer::Status FibreLayer::status() const {
  return worker_.newest().value_or(Status{});
}

std::optional<FibreLayer::Status> FibreLayer::fulfil(const Wish& wish, const Laying::Job& job) {
  Status status;
  deliver_({});  // what was laid before may be gigabytes
  if (!wish.scene) return status;
  job.bring(status);
  // Bricks are there at once, while one tree of a piece takes seconds; but of a piece of few cells it takes less
  // memory.
  FibreOptions options(wish.limit_bytes);
  if (wish.scene->cloth->fibres) options.extent = FibreExtent::bricks;
  status.size = planFibres(*wish.scene->cloth, options);
  if (status.size.bytes > wish.limit_bytes) {
    options.extent = FibreExtent::automatic;
    status.size = planFibres(*wish.scene->cloth, options);
  }
  if (status.size.bytes > wish.limit_bytes) {
    status.size = planFibres(*wish.scene->cloth, {wish.limit_bytes, FibreExtent::wholePiece});
    status.phase = Status::Phase::tooLarge;
    return status;
  }
  status.phase = Status::Phase::laying;
  job.bring(status);

  Task task;
  task.stop = job.stop();
  task.threads = threads_;
  constexpr int kSteps = 25;
  std::atomic<int> told{0};
  task.progress = [&job, &status, &told](double fraction) {
    const int step = static_cast<int>(kSteps * fraction);
    if (told.exchange(step) == step) return;  // each wakes the window
    Status now = status;
    now.progress = fraction;
    job.bring(now);
  };
  std::shared_ptr<const Medium> fibres = FibreMedium::build(wish.scene->cloth, options, task);
  if (!fibres) return std::nullopt;
  status.phase = Status::Phase::laid;
  deliver_({wish.scene, std::move(fibres)});
  return status;
}

}  // namespace loomlight
