#include "app/workers/tile_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>

#include "app/workers/tile.h"
#include "core/base/parallel.h"
#include "render/trace/make_medium.h"

namespace loomlight {

struct TileJob::Shared {
  mutable std::mutex mutex;
  State state;

  void run(std::stop_token stop, const Fabric& fabric, const std::string& stem, int longestSide) {
    State last;
    last.finished = true;
    try {
      Task task;
      task.stop = std::move(stop);
      task.threads = std::max(1, hardwareThreads() - 1);  // the window keeps its core
      task.progress = [this](double fraction) {
        std::lock_guard lock(mutex);
        state.progress = fraction;
      };
      const auto tile = makeTile(fabric, stem, longestSide, defaultMemoryLimit_bytes(), task);
      last.outcome = tile ? fmt::format("Written: {}.json and {} maps beside it", stem, tile->files.size() - 1)
                          : std::string("Cancelled; nothing was written.");
    } catch (const std::exception& error) {
      last.outcome = error.what();
      last.failed = true;
    }
    std::lock_guard lock(mutex);
    state = std::move(last);
  }
};

TileJob::TileJob(std::shared_ptr<const Fabric> fabric, std::string stem, int longestSide, int samplesPerPixel)
    : shared_(std::make_shared<Shared>()) {
  Fabric sampled = *fabric;
  sampled.render.samplesPerPixel = samplesPerPixel;
  thread_ = std::jthread([shared = shared_, tile = std::move(sampled), stem = std::move(stem), longestSide](
                             std::stop_token stop) { shared->run(std::move(stop), tile, stem, longestSide); });
}

TileJob::State TileJob::state() const {
  std::lock_guard lock(shared_->mutex);
  return shared_->state;
}

}  // namespace loomlight
