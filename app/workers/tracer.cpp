#include "app/workers/tracer.h"

#include <algorithm>
#include <exception>

#include "render/trace/make_medium.h"

namespace loomlight {
namespace {

PixelRect within(const PixelRect& rect, int width, int height) {
  const int left = std::clamp(rect.x, 0, width), top = std::clamp(rect.y, 0, height);
  return {left, top, std::clamp(rect.x + rect.width, left, width) - left,
          std::clamp(rect.y + rect.height, top, height) - top};
}

}  // namespace

Tracer::Tracer(std::function<void()> wake, int threads) : wake_(std::move(wake)), threads_(threads) {
  thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

Tracer::~Tracer() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  ending_ = true;
  passStop_.request_stop();
}

void Tracer::interrupt() {
  if (passMayBeCancelled_) passStop_.request_stop();
  arrived_.notify_all();
}

void Tracer::show(Request request) {
  std::optional<Request> old(std::move(request));  // then what nobody took: it may die outside the lock
  std::lock_guard lock(mutex_);
  news_.request.swap(old);
  interrupt();
}

void Tracer::lens(std::optional<PixelRect> window) {
  std::lock_guard lock(mutex_);
  news_.lens = window;
  interrupt();
}

void Tracer::fibres(Traceable laid) {
  std::optional<Traceable> old(std::move(laid));
  std::lock_guard lock(mutex_);
  news_.fibres.swap(old);
  interrupt();
}

void Tracer::pause(bool paused) {
  std::lock_guard lock(mutex_);
  paused_ = paused;
  interrupt();
}

std::shared_ptr<const Frame> Tracer::frame() const {
  std::lock_guard lock(mutex_);
  return frame_;
}

std::shared_ptr<const LensFrame> Tracer::lensFrame() const {
  std::lock_guard lock(mutex_);
  return lensFrame_;
}

Tracer::State Tracer::state() const {
  std::lock_guard lock(mutex_);
  return state_;
}

void Tracer::loop(std::stop_token stop) {
  bool busy = false;
  while (!stop.stop_requested()) {
    News news;
    {
      std::unique_lock lock(mutex_);
      // A scene that has come during a pause is shown all the same, by its first pass.
      const auto mayWork = [&] { return !news_.empty() || (busy && (!paused_ || (picture_ && !picture_->begun()))); };
      arrived_.wait(lock, stop, mayWork);
      if (stop.stop_requested()) return;
      std::swap(news, news_);
    }
    try {
      busy = goOn(std::move(news));
    } catch (const std::exception& e) {  // a picture too large for the memory, say: the window goes on without
      giveUp(e.what());
      busy = false;
    }
  }
}

void Tracer::giveUp(const std::string& reason) {
  picture_.reset();
  lens_.reset();
  {
    std::lock_guard lock(mutex_);
    state_.picture = state_.lens = State::Phase::idle;
    state_.error = reason;
  }
  wake_();
}

bool Tracer::goOn(News news) {
  take(std::move(news));
  switch (nextTurn(contender(picture_, spentBeforeLens_s_), contender(lens_, 0))) {
    case Turn::picture:
      tracePicture();
      return true;
    case Turn::lens:
      traceLens();
      return true;
    case Turn::none:
      return false;
  }
  return false;
}

Contender Tracer::contender(const std::optional<Refinement>& refinement, double spentBefore) const {
  if (!refinement) return {};
  return {!refinement->converged(), refinement->divider(), refinement->spent_s() - spentBefore};
}

void Tracer::take(News news) {
  if (news.fibres) fibres_ = std::move(*news.fibres);
  if (news.lens) lensWindow_ = *news.lens;
  if (news.request) begin(std::move(*news.request));
  if (news.request || news.fibres || news.lens) openLens();
}

void Tracer::begin(Request request) {
  const bool better = picture_ && request.generation == request_.generation && request.width == request_.width &&
                      request.height == request_.height;
  // What the old picture has, shown or not: a better one may itself be replaced before it was seen.
  samplesToBeat_ = better ? std::max(samplesToBeat_, picture_->samples()) : 0;
  const bool seenFine = better && samplesToBeat_ > 0;
  const double secondsPerPath = picture_ ? picture_->secondsPerPath() : 0;
  request_ = std::move(request);
  picturePending_.reset();
  if (request_.width <= 0 || request_.height <= 0) {
    picture_.reset();
    return;
  }
  picture_.emplace(request_.cloth, request_.width, request_.height, secondsPerPath);
  if (seenFine) picture_->skipCoarse();
  spentBeforeLens_s_ = 0;
  if (!better) {  // the lens is of another scene; openLens() makes a new one where the same fibres serve
    lens_.reset();
    difference_.reset();
  }
  std::lock_guard lock(mutex_);
  state_.picture = State::Phase::tracing;
  state_.error.clear();
}

/// Brings the lens in line with what is wanted of it and what it can look at.
void Tracer::openLens() {
  const bool possible = lensWindow_ && picture_ && fibres_.medium && sameMedium(*fibres_.scene, picture_->scene());
  const PixelRect window = possible ? within(*lensWindow_, request_.width, request_.height) : PixelRect{};
  if (window.width <= 0 || window.height <= 0) {
    lens_.reset();
    lensPending_.reset();
    difference_.reset();
    bool changed = false;
    {
      std::lock_guard lock(mutex_);
      changed = lensFrame_ != nullptr;
      lensFrame_.reset();
      state_.lens = State::Phase::idle;
    }
    if (changed) wake_();
    return;
  }
  if (!lens_) {
    lens_.emplace(Traceable{request_.cloth.scene, fibres_.scene, fibres_.medium}, request_.width, request_.height,
                  lensSecondsPerPath_);
    spentBeforeLens_s_ = picture_->spent_s();
  }
  if (window == lens_->window()) return;
  lens_->look(window);
  difference_.reset();
  if (lens_->begun()) showLens();  // it has been here before: what is there already is shown at once
}

void Tracer::showLens() {
  lookForDifference();
  auto frame = std::make_shared<Frame>(lens_->frame(false));
  frame->generation = request_.generation;
  lensPending_ = std::move(frame);
  publish();
}

std::optional<Task> Tracer::beginPass(const Refinement& refinement) {
  std::lock_guard lock(mutex_);
  passStop_ = std::stop_source();
  passMayBeCancelled_ = refinement.begun();
  if (ending_) return std::nullopt;
  if (passMayBeCancelled_ && (paused_ || !news_.empty())) return std::nullopt;
  return Task{passStop_.get_token(), {}, threads_};
}

void Tracer::tracePicture() {
  const auto task = beginPass(*picture_);
  if (!task || !picture_->advance(*task)) return;
  if (picture_->samples() >= samplesToBeat_) {
    samplesToBeat_ = 0;
    lookForDifference();
    auto frame = std::make_shared<Frame>(picture_->frame(true));
    frame->generation = request_.generation;
    picturePending_ = std::move(frame);
  }
  // The lens follows a moving camera together with the picture around it.
  if (!lens_ || lens_->begun()) publish();
}

void Tracer::traceLens() {
  const auto task = beginPass(*lens_);
  if (!task || !lens_->advance(*task)) return;
  lensSecondsPerPath_ = lens_->secondsPerPath();
  showLens();
}

void Tracer::lookForDifference() {
  if (samplesToBeat_ > 0) return;  // the picture that is shown has been measured; the next one is still too noisy
  difference_.reset();
  if (!lens_ || lens_->divider() != 1 || picture_->divider() != 1) return;
  if (auto found = differenceOf(picture_->film(), lens_->film(), lens_->window()))
    difference_ = std::make_shared<const Difference>(std::move(*found));
}

void Tracer::publish() {
  {
    std::lock_guard lock(mutex_);
    if (picturePending_) frame_ = std::move(picturePending_);
    if (lensPending_ || (lensFrame_ && lens_)) {
      auto frame = std::make_shared<LensFrame>();
      frame->fibres = lensPending_ ? std::move(lensPending_) : lensFrame_->fibres;
      frame->difference = difference_;
      lensFrame_ = std::move(frame);
    }
    const auto phase = [](const Refinement& r) {
      return r.converged() ? State::Phase::converged : State::Phase::tracing;
    };
    if (picture_) {
      state_.picture = phase(*picture_);
      if (picture_->secondsPerPath() > 0) state_.pathsPerSecond = 1 / picture_->secondsPerPath();
    }
    if (lens_) state_.lens = phase(*lens_);
  }
  wake_();
}

}  // namespace loomlight
