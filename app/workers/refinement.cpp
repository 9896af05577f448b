#include "app/workers/refinement.h"

#include <algorithm>

#include "app/workers/denoise.h"
#include "app/workers/despeckle.h"
#include "app/workers/recolour.h"

namespace loomlight {
namespace {

/// Samples at which the viewport goes to sleep.
constexpr uint32_t kMostSamples = 1024;
/// From here on pictures are shown as they are.
constexpr uint32_t kClearSamples = 16;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int coarser(int pixels, int divider) {
  return (pixels + divider - 1) / divider;
}

/// The pixels of a coarse film that cover the window.
PixelRect covering(const PixelRect& window, int divider) {
  const int left = window.x / divider, top = window.y / divider;
  return {left, top, coarser(window.x + window.width, divider) - left,
          coarser(window.y + window.height, divider) - top};
}

glm::vec4 light(const Film& film, int x, int y) {
  return glm::vec4(film.mean(x, y), film.alpha(x, y));
}

}  // namespace

Refinement::Refinement(Traceable cloth, int width, int height, double secondsPerPath)
    : cloth_(std::move(cloth)), fine_(width, height), window_{0, 0, width, height}, start_(Clock::now()) {
  history_.width = width;
  history_.height = height;
  history_.secondsPerPath = secondsPerPath;
}

void Refinement::look(const PixelRect& window) {
  if (window == window_) return;
  window_ = window;
  history_.width = window.width;
  history_.height = window.height;
  history_.samples = fineBegun_ ? fewestSamples(fine_, window) : 0;
  history_.divider = history_.samples > 0 ? 1 : 0;
  start_ = Clock::now();
}

void Refinement::keepPaths(size_t bytes) {
  records_ =
      std::make_unique<PathRecords>(fine_.width(), fine_.height(), static_cast<int>(scene().materials.size()), bytes);
}

bool Refinement::converged() const {
  return nextPass(history_, kMostSamples).samples == 0;
}

Film& Refinement::filmFor(int divider) {
  if (divider == 1) {
    fineBegun_ = true;
    return fine_;
  }
  if (divider != coarseDivider_) {
    coarse_.emplace(coarser(fine_.width(), divider), coarser(fine_.height(), divider));
    coarseDivider_ = divider;
  }
  return *coarse_;
}

bool Refinement::advance(const Task& task) {
  history_.seconds = secondsSince(start_);
  const PassPlan plan = nextPass(history_, kMostSamples);
  if (plan.samples == 0) return true;
  Film& film = filmFor(plan.divider);
  const CameraRays camera(scene().fabric->camera, film.width(), film.height());
  const auto start = Clock::now();
  PathRecords* records = plan.divider == 1 ? records_.get() : nullptr;
  const PassResult result = renderUpTo(plan.samples, scene(), *cloth_.medium, camera, film,
                                       covering(window_, plan.divider), task, 0, records);
  const double seconds = secondsSince(start);
  spent_s_ += seconds;
  if (!result.complete) return false;
  if (result.counts.paths > 0) history_.secondsPerPath = seconds / static_cast<double>(result.counts.paths);
  history_.divider = plan.divider;
  if (plan.divider == 1) history_.samples = plan.samples;
  return true;
}

void Refinement::finish(Frame& frame) const {
  frame.samples = history_.divider == 1 ? static_cast<int>(history_.samples) : 0;
  frame.divider = fineBegun_ ? 1 : history_.divider;
  frame.seconds = secondsSince(start_);
  if (denoisingThreads_ > 0 && !frame.hits.empty()) takeNoise(frame);
  // One lucky path to the sun must not stand as a block in a coarse picture: its light goes to its neighbours. In a
  // fine one it is held back until samples come.
  const uint32_t samples = std::max(1u, history_.samples);
  if (frame.divider > 1) {
    if (!frame.hits.empty()) loomlight::denoise(frame.rgba, {frame.hits, {}}, frame.width, frame.height, 1);
    soften(frame.rgba, frame.width, frame.height);
  } else if (samples < kClearSamples) {
    despeckle(frame.rgba, frame.width, frame.height, 1.5f + static_cast<float>(samples));
  }
}

/// Of all the light that was traced: what stands out is spread here, where despeckle() would take it away.
void Refinement::takeNoise(Frame& frame) const {
  const auto luminance = [](Rgb c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; };
  std::vector<float> variances;
  const bool fine = history_.divider == 1 || fineBegun_;
  if (fine && history_.samples > 1) {
    variances.reserve(frame.rgba.size());
    for (int y = window_.y; y < window_.y + window_.height; ++y)
      for (int x = window_.x; x < window_.x + window_.width; ++x) {
        // In other colours noise is in proportion.
        const float shown = luminance(Rgb(frame.rgba[variances.size()])), traced = luminance(fine_.mean(x, y));
        const float scale = traced > 0 ? shown / traced : 1.0f;
        variances.push_back(scale * scale * fine_.variance(x, y));
      }
  }
  frame.denoised = frame.rgba;
  loomlight::denoise(frame.denoised, {frame.hits, variances}, frame.width, frame.height, denoisingThreads_);
}

Frame Refinement::frame(bool withHits) const {
  Frame frame = history_.divider == 1 || fineBegun_ ? fineFrame(withHits) : coarseFrame(withHits);
  finish(frame);
  return frame;
}

Frame Refinement::recoloured(const Dye& dye, int threads, double& variance) const {
  Recoloured picture = recolour(fine_, *records_, dye, threads);
  variance = picture.variance;
  Frame frame = fineFrame(true);
  frame.rgba = std::move(picture.rgba);
  frame.recoloured = true;
  finish(frame);
  return frame;
}

Frame Refinement::coarseFrame(bool withHits) const {
  const PixelRect pixels = covering(window_, coarseDivider_);
  Frame frame;
  frame.width = pixels.width;
  frame.height = pixels.height;
  frame.window = {pixels.x * coarseDivider_, pixels.y * coarseDivider_, pixels.width * coarseDivider_,
                  pixels.height * coarseDivider_};
  for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
    for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
      frame.rgba.push_back(light(*coarse_, x, y));
      if (withHits) frame.hits.push_back(coarse_->hit(x, y));
    }
  return frame;
}

Frame Refinement::fineFrame(bool withHits) const {
  Frame frame;
  frame.width = window_.width;
  frame.height = window_.height;
  frame.window = window_;
  frame.rgba.reserve(static_cast<size_t>(frame.width) * frame.height);
  for (int y = window_.y; y < window_.y + window_.height; ++y)
    for (int x = window_.x; x < window_.x + window_.width; ++x) {
      // Where the window has just come to, coarse pixels stand in.
      const bool standIn = coarse_ && fine_.samples(x, y) == 0;
      frame.rgba.push_back(standIn ? light(*coarse_, x / coarseDivider_, y / coarseDivider_) : light(fine_, x, y));
      if (withHits)
        frame.hits.push_back(standIn ? coarse_->hit(x / coarseDivider_, y / coarseDivider_) : fine_.hit(x, y));
    }
  return frame;
}

}  // namespace loomlight
