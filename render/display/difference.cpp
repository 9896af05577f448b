#include "render/display/difference.h"

#include <algorithm>
#include <cmath>

#include "core/base/rgb.h"
#include "render/film/film.h"
#include "render/metrics/heat_map.h"

namespace loomlight {
namespace {

constexpr int kReach = 2;  // of the average, pixels to each side

/// Sums over any rectangle of a window, from running sums over all that begin in its corner.
class AreaSums {
 public:
  template <class Value>
  AreaSums(int width, int height, Value&& value) : stride_(width + 1), sums_(pixelCount(stride_, height + 1)) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) at(x + 1, y + 1) = value(x, y) + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }
  double sum(int left, int top, int right, int bottom) const {
    return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  }

 private:
  double& at(int x, int y) { return sums_[pixelIndex(x, y, stride_)]; }
  double at(int x, int y) const { return sums_[pixelIndex(x, y, stride_)]; }

  int stride_;
  std::vector<double> sums_;
};

}  // namespace

std::vector<Rgb> differenceScale(int steps) {
  std::vector<Rgb> colours;
  for (int i = 0; i < steps; ++i) colours.push_back(heatColour(static_cast<double>(i) / (steps - 1)));
  return colours;
}

std::optional<Difference> differenceOf(const Film& picture, const Film& truth, const PixelRect& window) {
  constexpr uint32_t kFewest = 2;  // a spread can be seen
  if (picture.fewestSamples(window) < kFewest || truth.fewestSamples(window) < kFewest) return std::nullopt;
  const int width = window.width, height = window.height;
  double truthSum = 0;
  const AreaSums differences(width, height, [&](int x, int y) {
    const double there = luminance(truth.mean(window.x + x, window.y + y));
    truthSum += there;
    return luminance(picture.mean(window.x + x, window.y + y)) - there;
  });
  const AreaSums variances(width, height, [&](int x, int y) {
    return static_cast<double>(picture.variance(window.x + x, window.y + y)) +
           truth.variance(window.x + x, window.y + y);
  });
  if (!(truthSum > 0) || !std::isfinite(truthSum)) return std::nullopt;

  Difference difference;
  difference.width = width;
  difference.height = height;
  difference.mean_percent = 100 * differences.sum(0, 0, width, height) / truthSum;
  difference.error_percent = 100 * std::sqrt(variances.sum(0, 0, width, height)) / truthSum;
  const double truthMean = truthSum / (static_cast<double>(width) * height);
  constexpr int kShades = 256;
  const std::vector<Rgb> shades = differenceScale(kShades);
  difference.map.reserve(pixelCount(width, height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int left = std::max(0, x - kReach), right = std::min(width, x + kReach + 1);
      const int top = std::max(0, y - kReach), bottom = std::min(height, y + kReach + 1);
      const double count = (right - left) * (bottom - top);
      const double found = std::abs(differences.sum(left, top, right, bottom)) / count;
      const double noise = 2 * std::sqrt(std::max(0.0, variances.sum(left, top, right, bottom))) / count;
      const double shown = std::clamp(Difference::kGain * (found - noise) / truthMean, 0.0, 1.0);
      difference.map.emplace_back(shades[static_cast<size_t>(std::lround(shown * (kShades - 1)))], 1.0f);
    }
  return difference;
}

}  // namespace loomlight
