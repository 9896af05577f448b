#include "app/live/tracer.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "render/display/patch.h"
#include "render/display/recolour.h"
#include "render/display/reframe.h"

namespace loomlight {
namespace {

/// For the paths of one picture that recolouring needs: some 45 bytes a sample under a dome, 170 under sun and sky.
constexpr size_t kPathBytes = size_t{256} << 20;

PixelRect within(const PixelRect& rect, int width, int height) {
  const int left = std::clamp(rect.x, 0, width), top = std::clamp(rect.y, 0, height);
  return {left, top, std::clamp(rect.x + rect.width, left, width) - left,
          std::clamp(rect.y + rect.height, top, height) - top};
}

}  // namespace

Tracer::Tracer(std::function<void()> wake, int threads) : wake_(std::move(wake)), threads_(threads) {
  thread_ = std::jthread([this](const std::stop_token& stop) { loop(stop); });
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

void Tracer::denoise(bool wanted) {
  std::lock_guard lock(mutex_);
  news_.denoise = wanted;
  interrupt();
}

void Tracer::shareLight(bool wanted) {
  std::lock_guard lock(mutex_);
  news_.share = wanted;
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

void Tracer::loop(const std::stop_token& stop) {
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
  dyed_.reset();
  clear_.reset();
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
  if (news.denoise) changeDenoising(*news.denoise);
  if (news.share) shared_ = *news.share;
  if (news.request) begin(std::move(*news.request));
  if (news.request || news.fibres || news.lens) openLens();
}

void Tracer::begin(Request request) {
  const bool sameSize = request.width == request_.width && request.height == request_.height;
  const bool better = picture_ && sameSize && request.generation == request_.generation;
  if (!better && sameSize && recolour(request)) return;
  const Fabric& fabric = *request.cloth.scene->fabric;
  PreviewHave have{better, sameSize, better ? picture_->divider() : 0, {}, {}};
  if (picture_) have.sincePicture = changes(*picture_->scene().fabric, fabric);
  if (clearFabric_) have.sinceClear = changes(*clearFabric_, fabric);
  const PreviewStart start = previewStart(have);
  const double secondsPerPath = start.knowsCost ? picture_->secondsPerPath() : 0;
  const std::shared_ptr<const Frame> earlier = start.reached > 0 ? newestFrame() : nullptr;
  if (clear_) {
    clearHelp_ = clearHelp(*have.sinceClear,
                           {clear_->width, clear_->height, clearFabric_->weave.ends(), clearFabric_->weave.picks()},
                           {request.width, request.height, fabric.weave.ends(), fabric.weave.picks()});
    if (clearHelp_ == ClearHelp::none) clear_.reset();
  }
  std::unique_ptr<SharedLight> light = picture_ ? picture_->takeSharedLight() : nullptr;
  request_ = std::move(request);
  picturePending_.reset();
  dyed_.reset();
  if (request_.width <= 0 || request_.height <= 0) {
    picture_.reset();
    return;
  }
  beginPicture(secondsPerPath, std::move(light), have.sincePicture.value_or(Changes{}));
  if (earlier) {
    picture_->standIn(earlier);
    picture_->skipCoarse(start.reached);
  } else {
    picture_->beginAt(start.coarsest, start.patience_s);
  }
  spentBeforeLens_s_ = 0;
  if (!better) {  // the lens is of another scene; openLens() makes a new one where the same fibres serve
    lens_.reset();
    difference_.reset();
  }
  std::lock_guard lock(mutex_);
  state_.picture = State::Phase::tracing;
  state_.error.clear();
}

/// What is shown, or about to be.
std::shared_ptr<const Frame> Tracer::newestFrame() const {
  return picturePending_ ? picturePending_ : frame();
}

/// Answers a change of colour from the paths that have been traced already, and begins to trace new ones behind. False
/// where they cannot tell.
bool Tracer::recolour(const Request& request) {
  std::optional<Refinement>& known = dyed_ ? dyed_ : picture_;
  if (!known || known->samples() == 0 || &known->medium() != request.cloth.medium.get()) return false;
  const auto dye = dyeBetween(known->scene(), *request.cloth.scene);
  if (!dye) return false;
  request_ = request;
  clear_.reset();
  if (dye->light == Rgb(1) && dye->absorption_per_mm == known->scene().absorption_per_mm) {
    if (dyed_) picture_ = std::exchange(dyed_, std::nullopt);  // back to the colours that it was traced in
    picturePending_ = framed(picture_->frame());
  } else {
    const double secondsPerPath = known->secondsPerPath();
    if (!dyed_) dyed_ = std::exchange(picture_, std::nullopt);
    picturePending_ = framed(dyed_->recoloured(*dye, threads_, varianceToBeat_));
    beginPicture(secondsPerPath, nullptr, {});
    picture_->skipCoarse();
  }
  spentBeforeLens_s_ = 0;
  lens_.reset();
  difference_.reset();
  publish();
  return true;
}

/// `light`: what repeats shared in the picture before, and `edit` what came between.
void Tracer::beginPicture(double secondsPerPath, std::unique_ptr<SharedLight> light, const Changes& edit) {
  picture_.emplace(request_.cloth, request_.width, request_.height, secondsPerPath);
  const Scene& scene = *request_.cloth.scene;
  if (shared_ && SharedLight::serves(scene, request_.width, request_.height))
    picture_->shareLight(std::move(light), edit);
  picture_->keepPaths(kPathBytes);
  picture_->denoise(denoised_);
}

/// Shows what there is otherwise, at once; a picture that stands in for a better one stays as it is until that comes.
void Tracer::changeDenoising(bool wanted) {
  denoised_ = wanted;
  for (auto* picture : {&picture_, &dyed_})
    if (*picture) (*picture)->denoise(wanted);
  if (!picture_) return;
  if (dyed_) {
    const auto dye = dyeBetween(dyed_->scene(), picture_->scene());
    picturePending_ = framed(dyed_->recoloured(*dye, threads_, varianceToBeat_));
  } else if (picture_->begun() && worthShowing()) {
    showPicture();
  }
  publish();
}

/// The clear picture with what is new in this one.
Frame Tracer::cleared(Frame fresh) const {
  if (clearHelp_ == ClearHelp::reframed) return reframed(fresh, *clear_, request_.width, request_.height, threads_);
  return patched(std::move(fresh), *clear_, request_.cloth.scene->fabric->weave, clearFabric_->weave);
}

std::shared_ptr<Frame> Tracer::framed(Frame frame) const {
  auto shared = std::make_shared<Frame>(std::move(frame));
  shared->generation = request_.generation;
  if (request_.sketch) shared->quality = Quality::sketch;
  return shared;
}

/// Brings the lens in line with what is wanted of it and what it can look at.
void Tracer::openLens() {
  const bool possible = lensWindow_ && picture_ && fibres_.medium && fibres_.scene->cloth == picture_->scene().cloth;
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
    lens_.emplace(Traceable{request_.cloth.scene, fibres_.medium}, request_.width, request_.height,
                  lensSecondsPerPath_);
    lens_->asTraced();
    spentBeforeLens_s_ = picture_->spent_s();
  }
  if (window == lens_->window()) return;
  lens_->look(window);
  difference_.reset();
  if (lens_->begun()) showLens();  // it has been here before: what is there already is shown at once
}

void Tracer::showLens() {
  lookForDifference();
  lensPending_ = framed(lens_->frame());
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
  if (worthShowing()) {
    dyed_.reset();
    lookForDifference();
    showPicture();
  }
  // The lens follows a moving camera together with the picture around it.
  if (!lens_ || lens_->begun()) publish();
}

void Tracer::showPicture() {
  Frame frame = picture_->frame();
  if (clear_ && wantsHelp(frame.samples, clear_->samples)) {
    picturePending_ = framed(cleared(std::move(frame)));
    if (picturePending_->samples == 0) picture_->standIn(picturePending_);
    return;
  }
  picturePending_ = framed(std::move(frame));
  if (picturePending_->quality <= Quality::coarse) return;
  clear_ = picturePending_;
  clearFabric_ = request_.cloth.scene->fabric;
  clearHelp_ = ClearHelp::patched;
}

/// Whether the picture is no worse than the one that stands in for it.
bool Tracer::worthShowing() const {
  return !dyed_ || supersedes(picture_->samples(), meanVariance(picture_->film()),
                              {dyed_->worth_samples(), dyed_->fading(), varianceToBeat_});
}

void Tracer::traceLens() {
  const auto task = beginPass(*lens_);
  if (!task || !lens_->advance(*task)) return;
  lensSecondsPerPath_ = lens_->secondsPerPath();
  showLens();
}

void Tracer::lookForDifference() {
  if (picture_->fading() || dyed_)
    return;  // the picture that is shown has been measured; the next one is still too noisy
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
      frame->fibres = lensPending_ ? std::exchange(lensPending_, nullptr) : lensFrame_->fibres;
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
