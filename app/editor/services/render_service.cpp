#include "app/editor/services/render_service.h"

#include <utility>

#include "ui/words/picture_words.h"

namespace loomlight {

RenderService::RenderService()
    : worker_(
          {},  // its dialog looks as often as it needs to

          [](const Work& work, const auto& job) {
            Task task;
            task.stop = job.stop();
            task.progress = [&job](double fraction) { job.bring({{true, fraction, "", false}, false}); };
            const std::optional<std::string> written = work(task);
            return Told{{false, 1, written.value_or(words::rendering::cancelled), false}, written.has_value()};
          },
          [](const Work&, const std::string& problem) { return Told{{false, 1, problem, true}, false}; },
          Backlog::newest, Priority::picture) {}

void RenderService::start(Work work) {
  progress_ = {};
  progress_.running = true;
  worker_.ask(std::move(work));
}

void RenderService::forget() {
  if (!isRunning()) progress_ = {};
}

std::optional<bool> RenderService::follow() {
  const auto told = worker_.take();
  if (!told) return std::nullopt;
  progress_ = told->progress;
  if (progress_.running) return std::nullopt;
  return told->written;
}

}  // namespace loomlight
