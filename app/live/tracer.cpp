#include "app/live/tracer.h"

#include <algorithm>
#include <utility>

#include "core/base/memory.h"
#include "render/display/patch.h"
#include "render/display/recolour.h"
#include "render/display/reframe.h"

// How it works. What is wanted is one value; each change of it stops the pass under way and is the next job's request.
// A job takes what is new in it, then traces pass by pass. A scene begins in begin(): other colours are answered from
// paths on record; the same scene made better goes on from what is shown; anything else begins coarse, helped by the
// last clear picture as far as that still shows the same (preview_policy.h), or, where only the camera has moved, by
// what the last picture shows from there (movedView). The viewport's picture and the inset take passes in turn
// (nextSubject); what is to be shown is pending until publish(), and bring() hands it to the window.

namespace loomlight {
namespace {

/// For the paths of one picture that recolouring needs: some 45 bytes a sample under a dome, 170 under sun and sky.
constexpr size_t kPathBytes = size_t{256} << 20;

}  // namespace

Tracer::Tracer(std::function<void()> wake, int threads)
    : threads_(threads),
      worker_(
          std::move(wake),
          [this](const Wanted& wanted, const Tracing::Job& job) {
            trace(wanted, job);
            return std::nullopt;
          },
          // A picture too large for the memory, say: the window goes on without.
          [this](const Wanted&, const std::string& problem) { return givenUp(problem); }, Backlog::newest,
          Priority::picture) {}

/// Changes what is wanted, and brings the thread to look at that: it leaves the pass under way where it may.
template <class Change>
void Tracer::want(const Change& change) {
  Wanted before;  // it may be the last to hold a scene, which then dies outside the lock
  const std::lock_guard lock(mutex_);
  before = wanted_;
  change(wanted_);
  if (passMayBeCancelled_) worker_.cancel();
  if (wanted_.requests != before.requests) passMayBeCancelled_ = false;
  worker_.ask(wanted_);
}

void Tracer::show(Request request) {
  want([&](Wanted& wanted) {
    wanted.request = std::move(request);
    ++wanted.requests;
  });
}

void Tracer::inset(std::optional<PixelRect> window) {
  want([&](Wanted& wanted) { wanted.inset = window; });
}

void Tracer::fibres(Traceable laid) {
  want([&](Wanted& wanted) { wanted.fibres = std::move(laid); });
}

void Tracer::pause(bool paused) {
  want([&](Wanted& wanted) { wanted.paused = paused; });
}

void Tracer::denoise(bool wanted) {
  want([&](Wanted& all) { all.denoised = wanted; });
}

void Tracer::restAt(uint32_t samples) {
  want([&](Wanted& wanted) { wanted.rest = samples; });
}

void Tracer::booth(bool wanted) {
  want([&](Wanted& all) { all.booth = wanted; });
}

void Tracer::shareLight(bool wanted) {
  want([&](Wanted& all) { all.shared = wanted; });
}

Tracer::State Tracer::state() const {
  Shown newest = shown();
  const std::lock_guard lock(mutex_);
  if (newest.requests != wanted_.requests) {
    newest.state.picture = State::Phase::tracing;
    newest.state.error.clear();
  }
  return newest.state;
}

/// Pass by pass, until there is nothing left to trace, or something else is wanted: that is the next job's.
void Tracer::trace(const Wanted& wanted, const Tracing::Job& job) {
  take(wanted);
  bring(job);
  const auto isWaitedFor = [this] { return worker_.isWaiting() && (!picture_ || picture_->begun()); };
  for (Subject next = nextToTrace(); mayGoOn(next) && !isWaitedFor(); next = nextToTrace()) {
    if (next == Subject::picture)
      tracePicture(job.stop());
    else
      traceInset(job.stop());
    bring(job);
    if (job.isStopped()) return;
  }
  // Cloths and pictures come and go with every edit; nobody waits for anything now.
  if (nextToTrace() == Subject::none && !taken_.request.sketch) releaseFreeMemory();
}

/// A scene that has come during a pause is shown all the same, by its first pass.
bool Tracer::mayGoOn(Subject next) const {
  return next != Subject::none && (!taken_.paused || (picture_ && !picture_->begun()));
}

Subject Tracer::nextToTrace() const {
  const auto contender = [](const std::optional<Refinement>& refinement, double spentBefore_s) {
    if (!refinement) return Contender{};
    return Contender{!refinement->converged(), refinement->divider(), refinement->spent_s() - spentBefore_s};
  };
  Contender picture = contender(picture_, spentBeforeInset_s_);
  if (picture.divider == 1 && picture_->samples() == 0) picture.divider = 2;  // another one stands in for it
  return nextSubject(picture, contender(inset_, 0));
}

Tracer::Shown Tracer::givenUp(const std::string& reason) {
  picture_.reset();
  recoloured_.reset();
  clear_.reset();
  detailed_.reset();
  inset_.reset();
  shown_.state.picture = shown_.state.inset = State::Phase::idle;
  shown_.state.error = reason;
  shown_.requests = taken_.requests;
  return shown_;
}

void Tracer::take(const Wanted& wanted) {
  const Wanted before = std::exchange(taken_, wanted);
  const bool isRequest = taken_.requests != before.requests;
  const bool isBooth = taken_.booth != before.booth, isDenoising = taken_.denoised != before.denoised;
  if (isBooth) booth_ = taken_.booth ? std::optional(BoothView{}) : std::nullopt;
  for (auto* picture : {&picture_, &recoloured_})
    if (*picture) (*picture)->denoise(taken_.denoised);
  for (auto* picture : {&picture_, &recoloured_, &inset_})
    if (*picture) (*picture)->restAt(taken_.rest);
  if (isRequest)
    begin(before.request);
  else if (isDenoising || isBooth)
    showOtherwise();
  if (isRequest || taken_.fibres.medium != before.fibres.medium || taken_.inset != before.inset) openInset();
}

/// The picture of the request that has been taken; `before` is the one that was taken last.
void Tracer::begin(const Request& before) {
  const Request& request = taken_.request;
  const bool sameSize = request.width == before.width && request.height == before.height;
  const bool better = picture_ && sameSize && request.generation == before.generation;
  const Fabric& fabric = *request.cloth.scene->fabric;
  // A sketch in light that is known says more than a finer pass would: the next sketch is seen in that light, too.
  const bool repeatsKnownLight = request.sketch && picture_ && picture_->showsKnownLight();
  PreviewHave have{better, sameSize, better && !repeatsKnownLight ? picture_->divider() : 0, {}, {}};
  if (picture_) have.sincePicture = changes(*picture_->scene().fabric, fabric);
  if (!better && sameSize && recolour(have.sincePicture)) return;
  if (clearFabric_) {
    const bool isPicture = picture_ && picture_->scene().fabric == clearFabric_;
    have.sinceClear = isPicture ? have.sincePicture : changes(*clearFabric_, fabric);
  }
  const PreviewStart start = previewStart(have);
  const double secondsPerPath = start.knowsCost ? picture_->secondsPerPath() : 0;
  const std::shared_ptr<const Frame> earlier = start.reached > 0 ? newestFrame() : nullptr;
  if (clear_) {
    clearHelp_ = clearHelp(*have.sinceClear,
                           {clear_->width, clear_->height, clearFabric_->weave.ends(), clearFabric_->weave.picks()},
                           {request.width, request.height, fabric.weave.ends(), fabric.weave.picks()});
    if (clearHelp_ == ClearHelp::none) clear_.reset();
  }
  if (detailed_ && !(sameSize && isOnlyMoved(changes(*detailedFabric_, fabric)))) detailed_.reset();
  std::unique_ptr<SharedLight> light = picture_ ? picture_->takeSharedLight() : nullptr;
  picturePending_.reset();
  recoloured_.reset();
  if (booth_) better ? booth_->renew() : booth_->forget();
  shown_.state.error.clear();
  if (request.width <= 0 || request.height <= 0) {
    picture_.reset();
    shown_.state.picture = State::Phase::idle;
    publish();
    return;
  }
  beginPicture(secondsPerPath, std::move(light), have.sincePicture.value_or(Changes{}));
  if (earlier) {
    picture_->standIn(earlier);
    picture_->skipCoarse(start.reached);
  } else {
    FirstPass first = start.first;
    if (booth_) first.finer = 1;  // lamps are told apart by the light of paths
    picture_->beginWith(first);
    if (detailed_ && !booth_) picture_->movedFrom(detailed_, detailedFabric_->camera);
  }
  spentBeforeInset_s_ = 0;
  if (!better) {  // the inset is of another scene; openInset() makes a new one where the same fibres serve
    inset_.reset();
    difference_.reset();
  }
}

/// What is shown, or about to be.
std::shared_ptr<const Frame> Tracer::newestFrame() const {
  return picturePending_ ? picturePending_ : shown_.frame;
}

/// Answers a change of colour from the paths that have been traced already, and begins to trace new ones behind. False
/// where they cannot tell.
bool Tracer::recolour(const std::optional<Changes>& sincePicture) {
  const Scene& wanted = *taken_.request.cloth.scene;
  std::optional<Refinement>& known = recoloured_ ? recoloured_ : picture_;
  if (!known || known->samples() == 0 || &known->medium() != taken_.request.cloth.medium.get()) return false;
  const Changes edit = recoloured_ ? changes(*recoloured_->scene().fabric, *wanted.fabric) : *sincePicture;
  auto recolouring = recolouringBetween(known->scene(), wanted, edit);
  if (!recolouring) return false;
  if (!edit.picture()) {
    if (recoloured_) {  // back to the colours that it was traced in
      picture_ = std::exchange(recoloured_, std::nullopt);
      clear_.reset();
      if (booth_) booth_->learn(*picture_, threads_);
    }
    showPicture();
  } else {
    clear_.reset();
    const double secondsPerPath = known->secondsPerPath();
    if (!recoloured_) recoloured_ = std::exchange(picture_, std::nullopt);
    recolouring_ = std::move(*recolouring);
    showRecoloured();
    beginPicture(secondsPerPath, nullptr, {});
    picture_->skipCoarse();
  }
  spentBeforeInset_s_ = 0;
  inset_.reset();
  difference_.reset();
  publish();
  return true;
}

/// `light`: what repeats shared in the picture before, and `edit` what came between.
void Tracer::beginPicture(double secondsPerPath, std::unique_ptr<SharedLight> light, const Changes& edit) {
  const Request& request = taken_.request;
  const Refinement::Options options{
      .secondsPerPath = secondsPerPath, .isSketch = request.sketch, .paths_bytes = kPathBytes};
  picture_.emplace(request.cloth, request.width, request.height, options);
  if (taken_.shared && SharedLight::serves(*request.cloth.scene, request.width, request.height))
    picture_->shareLight(std::move(light), edit);
  picture_->denoise(taken_.denoised);
  picture_->restAt(taken_.rest);
}

/// What there is with less noise, or as it is, at once; a picture that stands in for a better one stays as it is until
/// that comes.
void Tracer::showOtherwise() {
  if (!picture_) return;
  if (recoloured_) {
    showRecoloured();
  } else if (picture_->begun()) {
    showPicture();
  }
  publish();
}

/// The clear picture with what is new in this one.
Frame Tracer::cleared(Frame fresh) const {
  if (clearHelp_ == ClearHelp::reframed)
    return reframed(fresh, *clear_, taken_.request.width, taken_.request.height, threads_);
  const Fabric& fabric = *taken_.request.cloth.scene->fabric;
  return patched(std::move(fresh), *clear_, fabric.weave, clearFabric_->weave, fabric.crowding > 0);
}

std::shared_ptr<Frame> Tracer::framed(Frame frame) const {
  auto shared = std::make_shared<Frame>(std::move(frame));
  shared->generation = taken_.request.generation;
  if (taken_.request.sketch) shared->quality = PreviewQuality::sketch;
  return shared;
}

/// The viewport's picture, divided where that is asked for.
std::shared_ptr<Frame> Tracer::pictured(Frame frame) const {
  frame.booth.clear();  // of a clear picture that helps this one
  if (booth_) frame.booth = booth_->divided(frame);
  return framed(std::move(frame));
}

/// Brings the inset in line with what is wanted of it and what it can look at.
void Tracer::openInset() {
  const bool possible =
      taken_.inset && picture_ && taken_.fibres.medium && taken_.fibres.scene->cloth == picture_->scene().cloth;
  const PixelRect window = possible ? within(*taken_.inset, taken_.request.width, taken_.request.height) : PixelRect{};
  if (window.width <= 0 || window.height <= 0) {
    inset_.reset();
    insetPending_.reset();
    difference_.reset();
    if (std::exchange(shown_.insetFrame, nullptr)) isNews_ = true;
    shown_.state.inset = State::Phase::idle;
    return;
  }
  if (!inset_) {
    const Refinement::Options options{.secondsPerPath = insetSecondsPerPath_, .asTraced = true};
    inset_.emplace(Traceable{taken_.request.cloth.scene, taken_.fibres.medium}, taken_.request.width,
                   taken_.request.height, options);
    inset_->restAt(taken_.rest);
    spentBeforeInset_s_ = picture_->spent_s();
  }
  if (window == inset_->window()) return;
  inset_->look(window);
  difference_.reset();
  if (inset_->begun()) showInset();  // it has been here before: what is there already is shown at once
}

void Tracer::showInset() {
  lookForDifference();
  insetPending_ = framed(inset_->frame());
  publish();
}

std::optional<Task> Tracer::beginPass(const Refinement& refinement, const std::stop_token& stop) {
  const std::lock_guard lock(mutex_);
  if (refinement.begun() && worker_.isWaiting()) return std::nullopt;
  passMayBeCancelled_ = refinement.begun();
  return Task{stop, {}, threads_};
}

void Tracer::tracePicture(const std::stop_token& stop) {
  const auto task = beginPass(*picture_, stop);
  if (!task || !picture_->advance(*task) || !picture_->isNews()) return;
  if (worthShowing()) {
    recoloured_.reset();
    lookForDifference();
    showPicture();
  }
  // The inset follows a moving camera together with the picture around it.
  if (!inset_ || inset_->begun() || taken_.paused) publish();
}

void Tracer::showPicture() {
  Frame frame = picture_->frame();
  if (booth_) booth_->follow(*picture_, threads_);
  if (clear_ && wantsHelp(frame.samples, clear_->samples)) {
    picturePending_ = pictured(cleared(std::move(frame)));
    if (picturePending_->samples == 0) picture_->standIn(picturePending_);
    return;
  }
  picturePending_ = pictured(std::move(frame));
  if (picture_->hasDetail() && picturePending_->quality > PreviewQuality::sketch) {
    detailed_ = picturePending_;
    detailedFabric_ = taken_.request.cloth.scene->fabric;
  }
  if (picturePending_->quality <= PreviewQuality::coarse || !picture_->hasDetail()) return;
  clear_ = picturePending_;
  clearFabric_ = taken_.request.cloth.scene->fabric;
  clearHelp_ = ClearHelp::patched;
}

/// The old picture in the colours that are wanted.
void Tracer::showRecoloured() {
  if (booth_) booth_->learn(*recoloured_, *taken_.request.cloth.scene->fabric, recolouring_, threads_);
  picturePending_ = pictured(recoloured_->recoloured(recolouring_, threads_, varianceToBeat_));
}

/// Whether the picture is no worse than the one that stands in for it.
bool Tracer::worthShowing() const {
  return !recoloured_ || supersedes(picture_->samples(), meanVariance(picture_->film()),
                                    {recoloured_->worth_samples(), recoloured_->fading(), varianceToBeat_});
}

void Tracer::traceInset(const std::stop_token& stop) {
  const auto task = beginPass(*inset_, stop);
  if (!task || !inset_->advance(*task)) return;
  insetSecondsPerPath_ = inset_->secondsPerPath();
  showInset();
}

void Tracer::lookForDifference() {
  if (picture_->fadesFromSameView() || recoloured_)
    return;  // the picture that is shown has been measured; the next one is still too noisy
  difference_.reset();
  if (!inset_ || inset_->divider() != 1 || picture_->divider() != 1) return;
  if (auto found = differenceOf(picture_->film(), inset_->film(), inset_->window()))
    difference_ = std::make_shared<const Difference>(std::move(*found));
}

/// What is pending is shown from now on; bring() hands it out.
void Tracer::publish() {
  isNews_ = true;
  if (picturePending_) shown_.frame = std::move(picturePending_);
  if (insetPending_ || (shown_.insetFrame && inset_)) {
    auto frame = std::make_shared<InsetFrame>();
    frame->fibres = insetPending_ ? std::exchange(insetPending_, nullptr) : shown_.insetFrame->fibres;
    frame->difference = difference_;
    shown_.insetFrame = std::move(frame);
  }
  const auto phase = [](const Refinement& r) {
    return r.converged() ? State::Phase::converged : State::Phase::tracing;
  };
  State& state = shown_.state;
  if (picture_) state.picture = phase(*picture_);
  if (inset_) state.inset = phase(*inset_);
}

void Tracer::bring(const Tracing::Job& job) {
  if (!std::exchange(isNews_, false)) return;
  shown_.requests = taken_.requests;
  job.bring(shown_);
}

}  // namespace loomlight
