#include "app/live/refinement.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/rgb.h"
#include "core/base/stopwatch.h"
#include "render/display/denoise.h"
#include "render/display/despeckle.h"

// How it works. advance() does what the scheduler plans: a pass at a fraction of the resolution into a film of its own,
// or further samples of the fine film, bucket by bucket. What came before stands in (StandIn) and gives way sample by
// sample, so that every frame is a mean of what is traced and what was shown; so does what the view before shows of
// this one (movedView). A frame is read off the film, given the light that repeats share, then less noise, and is
// labelled with its PreviewQuality last.

namespace loomlight {
namespace {

/// The side of a bucket, in pixels: whole tiles of the film, each of which one thread records, and so many that it
/// takes no longer than a pass may; but not so few that lanes run empty. Those of a coarse pass are as large as any:
/// the few paths that it is told its cost by were traced in lanes that did run empty.
int bucketSide(double pixelsInBudget, int divider) {
  constexpr int kFewest = 4, kMost = 8;  // tiles a side
  const int tiles = std::clamp(static_cast<int>(std::sqrt(pixelsInBudget)) / PathRecords::kTile, kFewest, kMost);
  return PathRecords::kTile * (divider > 1 ? kMost : tiles);
}

glm::vec4 light(const Film& film, int x, int y) {
  return glm::vec4(film.mean(x, y), film.alpha(x, y));
}

}  // namespace

Refinement::Refinement(Traceable cloth, int width, int height, const Options& options)
    : cloth_(std::move(cloth)),
      options_(options),
      fine_(width, height),
      window_{0, 0, width, height},
      start_(Clock::now()) {
  history_.width = width;
  history_.height = height;
  history_.secondsPerPath = options.secondsPerPath;
  if (options.paths_bytes > 0) records_ = recordsFor(fine_);
}

void Refinement::look(const PixelRect& window) {
  if (window == window_) return;
  window_ = window;
  history_.width = window.width;
  history_.height = window.height;
  pass_.reset();
  standIn_.reset();
  history_.samples = fineBegun_ ? fine_.fewestSamples(window) : 0;
  history_.divider = history_.samples > 0 ? 1 : 0;
  start_ = Clock::now();
}

std::unique_ptr<PathRecords> Refinement::recordsFor(const Film& film) const {
  return std::make_unique<PathRecords>(film.width(), film.height(), static_cast<int>(scene().cloth->materials.size()),
                                       options_.paths_bytes);
}

Refinement::Paths Refinement::paths() const {
  const auto has = [](const std::unique_ptr<PathRecords>& records) { return records && records->bytes() > 0; };
  if (history_.samples > 0 && has(records_)) return {&fine_, records_.get()};
  // No finer pass is under way in it.
  const bool isFilled = !coarse_.empty() && history_.divider > 0 && history_.divider <= coarse_.back().divider;
  return isFilled && has(coarseRecords_) ? Paths{&coarse_.back().film, coarseRecords_.get()} : Paths{};
}

void Refinement::shareLight(std::unique_ptr<SharedLight> earlier, const Changes& edit) {
  shared_ = std::move(earlier);
  if (shared_)
    shared_->moveTo(cloth_.scene, cloth_.medium, fine_.width(), fine_.height(), edit);
  else
    shared_ = std::make_unique<SharedLight>(cloth_.scene, cloth_.medium, fine_.width(), fine_.height());
  knowsLight_ = shared_->knows();
  history_.waitsForFibres = shared_->waitsForFibres();
}

void Refinement::beginWith(const FirstPass& first) {
  history_.first = first;
  if (knowsLight_ && first.finer > 1) history_.first.coarsest = std::max(first.coarsest, FirstPass::kInMotion);
}

bool Refinement::converged() const {
  if (pass_) return false;
  if (options_.isSketch && spent_s_ > 0 && (known_ || history_.divider < kCoarseEnough)) return true;
  return nextPass(history_, samplesWanted()).samples == 0;
}

/// What stands in gives way to as many samples as it has itself, even if fewer are wanted by now.
uint32_t Refinement::samplesWanted() const {
  return fading() ? std::max(rest_, standIn_->samples()) : rest_;
}

Film& Refinement::filmFor(int divider) {
  if (divider == 1) {
    fineBegun_ = true;
    return fine_;
  }
  if (coarse_.empty() || divider != coarse_.back().divider) {
    coarse_.push_back({Film(coarser(fine_.width(), divider), coarser(fine_.height(), divider)), divider});
    if (options_.paths_bytes > 0) coarseRecords_ = recordsFor(coarse_.back().film);
  }
  return coarse_.back().film;
}

/// The first pass of all is not split: there is nothing that could be seen around its buckets.
Refinement::Pass Refinement::beginPass() const {
  constexpr uint32_t kFadeSteps = 8;  // at least, however quick the machine
  PassPlan plan = nextPass(history_, samplesWanted());
  if (fading() && plan.divider == 1)
    plan.samples = std::min(plan.samples, history_.samples + std::max(1u, standIn_->samples() / kFadeSteps));
  const PixelRect all = coarser(window_, plan.divider);
  if (shared_ && plan.divider == 1 && history_.samples < SharedLight::kEnough)
    plan.samples = std::min(plan.samples, history_.samples + SharedLight::samplesAtOnce(all.width, all.height));
  const uint32_t more = plan.divider == 1 ? plan.samples - history_.samples : 1;
  const double secondsPerPixel = more * history_.secondsPerPath, budget_s = passBudget_s(history_);
  const bool split = begun() && static_cast<double>(all.width) * all.height * secondsPerPixel > 2 * budget_s;
  return {plan, PictureBuckets(all, split ? bucketSide(budget_s / secondsPerPixel, plan.divider) : 0)};
}

/// Of every pixel: no more than it keeps, as others would be nothing new.
uint32_t Refinement::hitsWanted() const {
  return std::min(loomlight::hitsWanted(history_), shared_->mostHits(history_.samples));
}

/// First fibres come before any fine pass, which takes seconds. They come in turn with coarse ones, which are quick and
/// seen at once; or before them, where the light that they are seen in is known and the picture is legible until then.
bool Refinement::hitsAreNext() const {
  if (!shared_ || options_.isSketch || shared_->hits() >= hitsWanted()) return false;
  const bool isLegible = known_ || showsMoved() || history_.divider < FirstPass::kLegible + history_.first.finer;
  return (knowsLight_ && isLegible) || isHitsTurn_ || nextPass(history_, samplesWanted()).divider == 1;
}

bool Refinement::advance(const Task& task) {
  constexpr uint32_t kHitsAtOnce = 2;  // of a large picture more would take seconds in which nothing new is seen
  threads_ = task.threads;
  if (converged()) return true;
  isNews_ = true;
  history_.seconds = secondsSince(start_);
  const bool hitsNext = !pass_ && hitsAreNext();
  isHitsTurn_ = !hitsNext;
  if (hitsNext) {
    const uint32_t before = shared_->hits();
    const bool showed = shared_->shows();
    const bool complete = shared_->addHits(std::min(hitsWanted(), before + kHitsAtOnce), task, passBudget_s(history_));
    isNews_ = shared_->hits() > before || shared_->shows() != showed;
    spent_s_ += secondsSince(start_) - history_.seconds;
    return complete;
  }
  if (!pass_) pass_ = beginPass();
  const PassPlan& plan = pass_->plan;
  Film& film = filmFor(plan.divider);
  const CameraRays camera(scene().fabric->camera, fine_.width(), fine_.height(), plan.divider);
  PathRecords* records = plan.divider == 1 ? records_.get() : coarseRecords_.get();
  const auto start = Clock::now();
  const double budget = passBudget_s(history_);
  uint64_t paths = 0;
  double seconds = 0;
  bool complete = true;
  FirstFibreSink* const first = shared_ ? shared_->listener(history_.samples, plan.divider) : nullptr;
  while (complete && !pass_->buckets.finished() && seconds < budget) {
    const PassResult result = renderUpTo(plan.samples, scene(), *cloth_.medium, camera, film, task,
                                         {.window = pass_->buckets.next(), .records = records, .first = first});
    if (first) shared_->settle();
    seconds = secondsSince(start);
    paths += result.counts.paths;
    complete = result.complete;
    if (complete) pass_->buckets.finishNext();
  }
  spent_s_ += seconds;
  if (!complete) return false;
  if (paths > 0) history_.secondsPerPath = seconds / static_cast<double>(paths);
  const bool isFirst = history_.divider == 0;
  if (pass_->buckets.finished()) endPass();
  return !isFirst || showDetail(task);
}

/// Gives the first pass the detail that was known before it: of the picture before, where that shows nearly all of this
/// view, or else also of light that is known. False when stopped.
bool Refinement::showDetail(const Task& task) {
  constexpr float kFewMissing = 0.02f;  // of the cloth
  // What is missing stays as coarse as it is until the first whole sample.
  constexpr float kMostMissing = 0.2f, kMostMissingInKnownLight = 0.5f;
  const auto start = Clock::now();
  std::optional<MovedView> view = moved(task.threads);
  const float missing = view ? missingIn(*view, coarse_.back().film, history_.divider) : 1;
  const bool complete = missing <= kFewMissing || !knowsLight_ || showKnownLight(task);
  if (complete && missing <= (known_ ? kMostMissingInKnownLight : kMostMissing)) {
    brightenTo(*view, coarse_.back().film, history_.divider, task.threads);
    showMoved(std::move(*view));
  }
  spent_s_ += secondsSince(start);
  return complete;
}

/// The picture before, if it is needed and there is one; then it is let go.
std::optional<MovedView> Refinement::moved(int threads) {
  const auto before = std::exchange(seenBefore_, std::nullopt);
  if (!before || history_.divider == 1) return std::nullopt;
  const CameraRays from(before->camera, fine_.width(), fine_.height());
  const CameraRays to(scene().fabric->camera, fine_.width(), fine_.height());
  return movedView(*before->frame, from, to, scene().cloth->shell->thickness_mm(), threads);
}

/// The view as a stand-in, and around it what there is of this one. Coarse passes do nothing for it but bring light to
/// the cells of what is shared.
void Refinement::showMoved(MovedView view) {
  // The picture before may be clear, but its sheen is not that of this view.
  constexpr int kLeastWorth_samples = 4;
  const auto worth_samples = static_cast<uint32_t>(std::clamp(view.samples, kLeastWorth_samples, kClearSamples));
  Frame frame = filledFrom(known_ ? inKnownLight() : this->frame(), view, threads_);
  frame.quality = PreviewQuality::coarse;
  known_.reset();
  standIn_.emplace(std::make_shared<const Frame>(std::move(frame)), worth_samples, std::move(view.kept));
  if (!knowsLight_) skipCoarse();
}

/// The first pass with its pixels in light that is known from another view. False when stopped.
bool Refinement::showKnownLight(const Task& task) {
  const int finer = history_.first.finer;
  if (finer == 1 || history_.divider == 1) return true;
  auto view = shared_->known(coarse_.back(), finer, task);
  if (!view) return false;
  const SharedPicture& picture = view->picture;
  Frame frame;
  frame.divider = history_.divider / finer;
  frame.width = picture.width;
  frame.height = picture.height;
  frame.window = {0, 0, fine_.width(), fine_.height()};
  for (size_t i = 0; i < picture.light.size(); ++i) frame.rgba.emplace_back(picture.light[i], picture.alpha[i]);
  frame.hits = std::move(view->hits);
  frame.helped = frame.rgba;
  frame.shared = true;
  known_ = std::move(frame);
  return true;
}

Frame Refinement::inKnownLight() const {
  Frame frame = *known_;
  finish(frame);
  frame.quality = PreviewQuality::coarse;
  return frame;
}

void Refinement::endPass() {
  const PassPlan plan = pass_->plan;
  pass_.reset();
  known_.reset();
  history_.divider = plan.divider;
  history_.coarseSamples = plan.divider > 1 ? plan.samples : 0;
  if (!coarse_.empty()) coarse_.erase(coarse_.begin(), coarse_.end() - 1);
  if (plan.divider == 1) {
    history_.samples = plan.samples;
    if (shared_) shared_->wholeSampleTraced();
    if (records_ && records_->bytes() > 0) coarseRecords_.reset();
    if (!fading()) standIn_.reset();
  } else {
    if (standIn_ && standIn_->outlastsCoarse() && (standIn_->isMoved() || !sharesLight())) return;
    Frame coarse = traced(coarse_.back().film, plan.divider);
    finish(coarse);
    coarse.quality = PreviewQuality::coarse;  // each of its own pixels has a sample: nothing is left of a sketch
    standIn_.emplace(std::make_shared<const Frame>(std::move(coarse)));
  }
}

void Refinement::finish(Frame& frame) const {
  frame.samples = history_.divider == 1 ? static_cast<int>(history_.samples) : 0;
  if (standIn_ && frame.divider == 1)
    frame.samples += static_cast<int>(
        std::lround(standIn_->share(history_.samples) * static_cast<float>(standIn_->frame().samples)));
  frame.seconds = secondsSince(start_);
  if (options_.asTraced) {
    // One lucky path to the sun is held back until samples come.
    if (frame.divider == 1 && frame.samples < kClearSamples)
      despeckle(frame.rgba, frame.width, frame.height, 1.5f + static_cast<float>(std::max(1, frame.samples)));
  } else {
    takeNoise(frame);
  }
  const bool sketched = standIn_ && standIn_->frame().quality == PreviewQuality::sketch;
  frame.quality = std::min(frame.quality, sketched                        ? PreviewQuality::sketch
                                          : frame.samples == 0            ? PreviewQuality::coarse
                                          : frame.samples < kClearSamples ? PreviewQuality::young
                                                                          : PreviewQuality::clear);
  if (frame.divider > 1) soften(frame.helped.empty() ? frame.rgba : frame.helped, frame.width, frame.height);
}

/// From 1 without samples to 0 where a picture is clear. What is kept of a moved picture has no noise.
float Refinement::youth(const Frame& frame, bool isKept) const {
  const float clear = isKept ? standIn_->share(history_.samples) : 0;
  return std::max(0.0f, 1 - clear - static_cast<float>(frame.samples) / kClearSamples);
}

/// Noise darkens a picture, as what is brighter than white is lost to the eye: a young one is shown denoised, which
/// keeps all light, and less and less so until it is clear. What was traced stays beside it.
void Refinement::takeNoise(Frame& frame) const {
  // As long as nothing is traced at full resolution, what stands in for it is seen, whose noise has been taken; a drag
  // has no time for taking it again.
  const bool isTraced = fineBegun_ || frame.divider > 1;
  const bool isYoung = isTraced && !frame.shared && youth(frame, false) > 0;
  if (!isYoung && !denoised_) return;
  frame.variances = variances(frame);
  std::vector<glm::vec4> quiet(frame.plain().begin(), frame.plain().end());
  loomlight::denoise(quiet, {frame.hits, frame.variances}, frame.width, frame.height, threads_);
  if (isYoung && frame.helped.empty()) frame.helped = frame.rgba;
  for (size_t i = 0; isYoung && i < quiet.size(); ++i) {
    const auto width = static_cast<size_t>(frame.width);
    const bool isKept =
        standIn_ && standIn_->isMoved() && standIn_->isFineAt(static_cast<int>(i % width), static_cast<int>(i / width));
    frame.helped[i] = glm::mix(frame.helped[i], quiet[i], youth(frame, isKept));
  }
  if (denoised_) frame.denoised = std::move(quiet);
}

/// Of the luminance of a fine picture; empty where nothing is known of it.
std::vector<float> Refinement::variances(const Frame& frame) const {
  const bool mixed = standIn_ && standIn_->knowsVariance() && !known_;
  std::vector<float> variances;
  if (frame.divider > 1 || (!mixed && history_.samples < 2)) return variances;
  variances.reserve(frame.rgba.size());
  for (int y = window_.y; y < window_.y + window_.height; ++y)
    for (int x = window_.x; x < window_.x + window_.width; ++x) {
      // In other colours noise is in proportion.
      const float shown = luminance(Rgb(frame.rgba[variances.size()]));
      const float traced = luminance(Rgb(faded(light(fine_, x, y), x, y, LightChange{})));
      const float scale = frame.quality == PreviewQuality::recoloured && traced > 0 ? shown / traced : 1.0f;
      const float own = fine_.variance(x, y);
      variances.push_back(scale * scale * (mixed ? standIn_->variance(x, y, fine_.samples(x, y), own) : own));
    }
  return variances;
}

Frame Refinement::frame() const {
  const bool shared = sharesLight();
  if (known_ && !shared) return inKnownLight();
  const bool keepsDetail = standIn_ && standIn_->outlastsCoarse();
  const bool isWhole = shared || keepsDetail || fineBegun_ || history_.divider == 1 || coarse_.empty();
  Frame frame = isWhole ? traced(fine_, 1) : traced(coarse_.back().film, coarse_.back().divider);
  if (shared) share(frame);
  if (keepsDetail && !fineBegun_) frame.shared |= standIn_->frame().shared;
  finish(frame);
  return frame;
}

/// A moved picture that was young itself gives way to the first sample of each pixel, or to light that is shared of as
/// many coarse paths: it says more than that light does of fewer, and less than it does of paths of this view.
bool Refinement::showsMoved() const {
  if (!standIn_ || !standIn_->isMoved()) return false;
  const auto coarse = static_cast<uint32_t>(history_.divider * history_.divider);
  const bool knowsLittle = history_.samples == 0 && history_.coarseSamples < coarse;
  return !standIn_->isYoungView() || !sharesLight() || knowsLittle;
}

/// How much of a pixel what stands in still is, where light is shared.
float Refinement::standInShare(int x, int y) const {
  if (!standIn_->isFineAt(x, y)) return 0;
  if (!standIn_->isYoungView()) return standIn_->shareAt(x, y, fine_.samples(x, y));
  return pass_ && pass_->plan.divider == 1 ? 1 - pass_->buckets.shown(x, y) : 1;
}

bool Refinement::hasDetail() const {
  if (showsMoved()) return standIn_->share(history_.samples) < 0.5f;
  return history_.samples > 0 || sharesLight();
}

/// What a moved picture shows is finer than first fibres of some pixels.
bool Refinement::sharesLight() const {
  const bool isMoved = standIn_ && standIn_->isMoved();
  return shared_ && shared_->shows() && (shared_->hits() > 0 || !isMoved) && history_.samples < SharedLight::kFilmAlone;
}

/// For the display, light that repeats share; a fine picture that stands in gives way to it as to the film.
void Refinement::share(Frame& frame) const {
  frame.shared = true;
  std::span<const CoarseFilm> coarser = coarse_;
  if (history_.samples > 0) coarser = {};  // every pixel has samples of its own
  frame.helped = shared_->picture(fine_, coarser, threads_);
  if (!standIn_ || (standIn_->isMoved() && !showsMoved())) return;
  size_t i = 0;
  for (int y = 0; y < fine_.height(); ++y)
    for (int x = 0; x < fine_.width(); ++x, ++i)
      if (const float share = standInShare(x, y); share > 0)
        frame.helped[i] = glm::mix(frame.helped[i], standIn_->helped(x, y, 1), share);
}

Frame Refinement::recoloured(const Recolouring& recolouring, int threads, double& variance) const {
  Recoloured picture = recolour(fine_, *records_, recolouring, threads);
  variance = picture.variance;
  Frame frame = traced(fine_, 1);
  frame.helped.clear();
  frame.rgba = std::move(picture.rgba);
  if (sharesLight()) {
    share(frame);
    for (size_t i = 0; i < frame.helped.size(); ++i) frame.helped[i] = picture.change[i](frame.helped[i]);
  }
  for (int y = 0; fading() && y < fine_.height(); ++y)
    for (int x = 0; x < fine_.width(); ++x) {
      const size_t i = static_cast<size_t>(y) * static_cast<size_t>(fine_.width()) + static_cast<size_t>(x);
      frame.rgba[i] = faded(frame.rgba[i], x, y, picture.change[i]);
    }
  frame.quality = PreviewQuality::recoloured;
  finish(frame);
  return frame;
}

/// A pixel at full resolution with its share of what stands in for it, whose light changes so.
glm::vec4 Refinement::faded(const glm::vec4& own, int x, int y, const LightChange& change) const {
  const float share = standIn_ ? standIn_->shareAt(x, y, fine_.samples(x, y)) : 0;
  return share > 0 ? glm::mix(own, change(standIn_->light(x, y, 1)), share) : own;
}

/// The window as it has been traced so far, with what stands in for it.
Frame Refinement::traced(const Film& film, int divider) const {
  const PixelRect pixels = coarser(window_, divider);
  // Later passes and those that fade in change too little for borders to be seen.
  const bool first = history_.samples == 0 && pass_ && pass_->plan.divider == divider && standIn_ &&
                     (standIn_->samples() == 1 || standIn_->isMoved());
  Frame frame;
  frame.divider = divider;
  frame.width = pixels.width;
  frame.height = pixels.height;
  frame.window = within(finer(pixels, divider), fine_.width(), fine_.height());
  frame.rgba.resize(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height));
  if (!options_.asTraced) frame.hits.resize(frame.rgba.size());
  if (standIn_ && !standIn_->frame().helped.empty()) frame.helped.resize(frame.rgba.size());
  parallelFor(static_cast<size_t>(frame.height), threads_, [&](size_t row) {
    const int y = pixels.y + static_cast<int>(row);
    size_t i = row * static_cast<size_t>(frame.width);
    for (int x = pixels.x; x < pixels.x + pixels.width; ++x, ++i) {
      const uint32_t samples = film.samples(x, y);
      float share = standIn_ ? standIn_->shareAt(divider * x, divider * y, samples) : 0;
      if (first) share = std::max(share, 1 - pass_->buckets.shown(x, y));
      const glm::vec4 own = light(film, x, y);
      frame.rgba[i] = share > 0 ? glm::mix(own, standIn_->light(x, y, divider), share) : own;
      if (!frame.helped.empty())
        frame.helped[i] = share > 0 ? glm::mix(own, standIn_->helped(x, y, divider), share) : own;
      if (!options_.asTraced) frame.hits[i] = samples == 0 && standIn_ ? standIn_->hit(x, y, divider) : film.hit(x, y);
    }
  });
  return frame;
}

}  // namespace loomlight
