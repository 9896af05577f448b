#include "render/display/stand_in.h"

#include <algorithm>

#include "render/display/resample.h"

namespace loomlight {

StandIn::StandIn(std::shared_ptr<const Frame> earlier)
    : earlier_(std::move(earlier)), samples_(static_cast<uint32_t>(std::clamp(earlier_->samples, 1, kMostSamples))) {}

StandIn::StandIn(std::shared_ptr<const Frame> moved, uint32_t samples, std::vector<uint8_t> kept)
    : earlier_(std::move(moved)), samples_(samples), kept_(std::move(kept)) {}

bool StandIn::isFineAt(int x, int y) const {
  return isMoved() ? kept_[nearest(x, y, 1)] != 0 : earlier_->samples > 0;
}

float StandIn::shareAt(int x, int y, uint32_t samples) const {
  if (isMoved() && !isFineAt(x, y)) return samples == 0 ? 1.0f : 0.0f;
  return share(samples);
}

float StandIn::share(uint32_t samples) const {
  return samples >= samples_ ? 0.0f : 1 - static_cast<float>(samples) / static_cast<float>(samples_);
}

glm::vec4 StandIn::light(int x, int y, int divider) const {
  return between(earlier_->rgba, x, y, divider);
}

glm::vec4 StandIn::helped(int x, int y, int divider) const {
  return between(earlier_->plain(), x, y, divider);
}

glm::vec4 StandIn::between(std::span<const glm::vec4> pixels, int x, int y, int divider) const {
  const Frame& f = *earlier_;
  const auto own = static_cast<float>(f.divider);
  const float ratio = static_cast<float>(divider) / own;
  const Between u(x, ratio, -static_cast<float>(f.window.x) / own, f.width);
  const Between v(y, ratio, -static_cast<float>(f.window.y) / own, f.height);
  return resampled(pixels, f.width, u, v);
}

Film::Hit StandIn::hit(int x, int y, int divider) const {
  return earlier_->hits.empty() ? Film::Hit{} : earlier_->hits[nearest(x, y, divider)];
}

float StandIn::variance(int x, int y, uint32_t samples, float own) const {
  const float old = earlier_->variances[nearest(x, y, 1)], share = this->share(samples);
  const float each = old * static_cast<float>(samples_);
  const float fresh = samples > 1 ? own : each;
  return share * share * old + (1 - share) * (1 - share) * fresh;
}

size_t StandIn::nearest(int x, int y, int divider) const {
  const Frame& f = *earlier_;
  const auto along = [&](int pixel, int first, int count) {
    return std::clamp((pixel * divider + divider / 2 - first) / f.divider, 0, count - 1);
  };
  return pixelIndex(along(x, f.window.x, f.width), along(y, f.window.y, f.height), f.width);
}

}  // namespace loomlight
