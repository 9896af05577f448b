#include "render/transport/colour_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "render/colour/nearest_colour.h"
#include "render/transport/path_light.h"

// How it works. A walk through the cloth is known by its lengths inside each material, so its light is a product of
// exponentials of the absorptions, and the colour of the cloth a mean of those over all walks. As a function of one
// absorption, in one channel or band, that mean falls from what undyed fibres give to what black ones do: so each
// wanted value between the two has one absorption, found by Newton's method on the logarithm. Where a fibre is dyed
// in several materials at once, their lengths add up. Wanted values out of reach are first brought to the nearest
// that is.

namespace loomlight {
namespace {

constexpr double kMostAbsorption = 10000;  // of a valid fabric
constexpr float kTolerance = 1e-3f;        // of reflectance: less is not seen

/// The length of each walk inside the materials that are dyed, mm.
std::vector<double> lengthsInside(const PathLengthTally& walks, std::span<const int> dyed) {
  std::vector<double> lengths;
  for (size_t i = 0; i < walks.lengths_mm.size(); i += walks.materials) {
    double length = 0;
    for (const int material : dyed) length += walks.lengths_mm[i + static_cast<size_t>(material)];
    lengths.push_back(length);
  }
  return lengths;
}

/// One channel or band of the walks as a function of one absorption: mean of weight exp(-sigma length).
class Channel {
 public:
  /// `lengths_mm`: of each walk inside what is dyed. `weights`: what the other materials leave of its light. `count`:
  /// of all walks, those that did not come out too.
  Channel(const std::vector<double>& lengths_mm, std::vector<double> weights, size_t count)
      : lengths_mm_(lengths_mm), weights_(std::move(weights)) {
    for (double& weight : weights_) weight /= static_cast<double>(count);
  }

  struct Value {
    double colour = 0, slope = 0;  ///< and its derivative, < 0
  };
  Value at(double sigma) const {
    Value value;
    for (size_t i = 0; i < weights_.size(); ++i) {
      const double light = weights_[i] * std::exp(-sigma * lengths_mm_[i]);
      value.colour += light;
      value.slope -= light * lengths_mm_[i];
    }
    return value;
  }

 private:
  const std::vector<double>& lengths_mm_;
  std::vector<double> weights_;
};

/// Newton's method on the logarithm, which is convex and falls: from the left it never steps too far.
double absorptionFor(const Channel& channel, double wanted) {
  constexpr int kMostSteps = 200;
  constexpr double kExact = 1e-6;
  double sigma = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const Channel::Value value = channel.at(sigma);
    const double excess = std::log(value.colour / wanted);
    if (excess < kExact || value.slope == 0) break;
    sigma -= excess * value.colour / value.slope;
    if (sigma >= kMostAbsorption) return kMostAbsorption;
  }
  return sigma;
}

std::vector<double> channelWeights(const PathLengthTally& walks, const std::vector<Rgb>& absorption_per_mm,
                                   int channel) {
  std::vector<double> weights;
  for (size_t i = 0; i < walks.lengths_mm.size(); i += walks.materials) {
    double exponent = 0;
    for (size_t k = 0; k < walks.materials; ++k) exponent += absorption_per_mm[k][channel] * walks.lengths_mm[i + k];
    weights.push_back(std::exp(-exponent));
  }
  return weights;
}

/// What a channel can be.
struct Range {
  double darkest = 0, lightest = 1;

  explicit Range(const Channel& channel)
      : darkest(channel.at(kMostAbsorption).colour), lightest(channel.at(0).colour) {}
  /// As dark as can be asks for no more dye than makes a difference.
  double darkestWorthwhile() const { return std::min(darkest + kTolerance, lightest); }
  bool isTooLight(double wanted) const { return wanted > lightest + kTolerance; }
  bool isTooDark(double wanted) const { return wanted < darkest - kTolerance; }
};

}  // namespace

SolvedColour solveColour(const PathLengthTally& walks, std::vector<Rgb> absorption_per_mm, std::span<const int> dyed,
                         const Rgb& wanted) {
  assert(walks.lit() > 0 && absorption_per_mm.size() == walks.materials);
  SolvedColour solved;
  const std::vector<double> lengths_mm = lengthsInside(walks, dyed);
  for (const int material : dyed) absorption_per_mm[static_cast<size_t>(material)] = Rgb(0.0f);
  std::vector<Channel> channels;
  Rgb darkest, lightest;
  for (int c = 0; c < 3; ++c) {
    channels.emplace_back(lengths_mm, channelWeights(walks, absorption_per_mm, c), walks.count);
    const Range range(channels.back());
    solved.tooLight |= range.isTooLight(wanted[c]);
    solved.tooDark |= range.isTooDark(wanted[c]);
    lightest[c] = static_cast<float>(range.lightest);
    darkest[c] = static_cast<float>(range.darkestWorthwhile());
  }
  // Each channel has a dye of its own, so all between the two can be had.
  const Rgb target = nearestColour(wanted, darkest, lightest);
  for (int c = 0; c < 3; ++c)
    if (target[c] < lightest[c])
      solved.absorption_per_mm[c] = static_cast<float>(absorptionFor(channels[static_cast<size_t>(c)], target[c]));
  for (const int material : dyed) absorption_per_mm[static_cast<size_t>(material)] = solved.absorption_per_mm;
  solved.reached = walks.colour(absorption_per_mm);
  return solved;
}

SolvedReflectance solveReflectance(const PathLengthTally& walks, Colouring colouring, std::span<const int> dyed,
                                   const Spectrum& wanted) {
  assert(walks.lit() > 0 && colouring.primaries_per_mm.size() == walks.materials);
  const std::vector<double> lengths_mm = lengthsInside(walks, dyed);
  for (const int material : dyed) colouring.setBands(static_cast<size_t>(material), Spectrum{});
  std::array<std::vector<double>, kBands> weights;
  for (size_t i = 0; i < walks.lengths_mm.size(); i += walks.materials) {
    const Spectrum left = leftInBands(std::span(walks.lengths_mm).subspan(i, walks.materials), colouring);
    for (size_t j = 0; j < kBands; ++j) weights[j].push_back(left[j]);
  }
  SolvedReflectance solved;
  for (size_t j = 0; j < kBands; ++j) {
    const Channel band(lengths_mm, std::move(weights[j]), walks.count);
    const Range range(band);
    solved.tooLight += range.isTooLight(wanted[j]);
    solved.tooDark += range.isTooDark(wanted[j]);
    const double target = std::max(static_cast<double>(wanted[j]), range.darkestWorthwhile());
    if (target < range.lightest) solved.absorption_per_mm[j] = static_cast<float>(absorptionFor(band, target));
  }
  for (const int material : dyed) colouring.setBands(static_cast<size_t>(material), solved.absorption_per_mm);
  solved.reached = walks.reflectance(colouring).mean;
  return solved;
}

}  // namespace loomlight
