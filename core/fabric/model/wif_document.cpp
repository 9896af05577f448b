#include "core/fabric/model/wif_document.h"

#include <algorithm>
#include <cmath>

namespace loomlight {

Rgb WifPalette::srgb(const glm::ivec3& colour) const {
  const auto span = static_cast<double>(high - low);
  Rgb srgb;
  for (int i = 0; i < 3; ++i) srgb[i] = static_cast<float>((colour[i] - low) / span);
  return srgb;
}

glm::ivec3 WifPalette::nearest(const Rgb& srgb) const {
  const auto span = static_cast<double>(high - low);
  glm::ivec3 colour;
  for (int i = 0; i < 3; ++i)
    colour[i] = low + static_cast<int>(std::lround(span * std::clamp(static_cast<double>(srgb[i]), 0.0, 1.0)));
  return colour;
}

std::optional<int> freeWifNumber(const std::set<int>& taken) {
  const int behind = taken.empty() ? 1 : *taken.rbegin() + 1;
  if (behind <= kMaxWifNumber) return behind;
  int free = kMaxWifNumber;
  for (auto number = taken.rbegin(); number != taken.rend() && *number == free; ++number) --free;
  return free > 0 ? std::optional(free) : std::nullopt;
}

double millimetres(double value, WifUnit unit) {
  switch (unit) {
    case WifUnit::decipoints:
      return value * kMmPerInch / 720.0;
    case WifUnit::inches:
      return value * kMmPerInch;
    case WifUnit::centimeters:
      break;
  }
  return value * 10.0;
}

std::optional<double> WifSizes::meanSpacing_mm(int threads) const {
  double sum = 0;
  int own = 0;
  for (const auto& [thread, value] : spacings) {
    if (thread > threads) break;
    sum += value;
    ++own;
  }
  if (own < threads && !spacing) return std::nullopt;
  if (own < threads) sum += *spacing * (threads - own);
  return millimetres(sum / threads, unit);
}

std::optional<double> WifSizes::spacing_mm(int thread) const {
  const auto own = spacings.find(thread);
  const std::optional<double> value = own != spacings.end() ? own->second : spacing;
  return value ? std::optional(millimetres(*value, unit)) : std::nullopt;
}

std::optional<double> WifSizes::thickness_mm(int thread) const {
  const auto own = thicknesses.find(thread);
  const std::optional<double> value = own != thicknesses.end() ? own->second : thickness;
  return value ? std::optional(millimetres(*value, unit)) : std::nullopt;
}

}  // namespace loomlight
