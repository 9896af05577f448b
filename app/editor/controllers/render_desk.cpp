#include "app/editor/controllers/render_desk.h"

#include <utility>

namespace loomlight {

void RenderDesk::start(FileJob::Work work) {
  job_ = std::make_unique<FileJob>(std::move(work));
  progress_ = {};
  progress_.running = true;
}

void RenderDesk::forget() {
  if (!job_) progress_ = {};
}

void RenderDesk::cancel() {
  if (job_) job_->cancel();
}

std::optional<bool> RenderDesk::follow() {
  if (!job_) return std::nullopt;
  using Phase = FileJob::State::Phase;
  const FileJob::State state = job_->state();
  progress_ = {state.phase == Phase::running, state.progress, state.outcome, state.phase == Phase::failed};
  if (progress_.running) return std::nullopt;
  job_.reset();
  return state.phase == Phase::written;
}

}  // namespace loomlight
