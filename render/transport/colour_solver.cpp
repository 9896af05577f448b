#include "render/transport/colour_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/colour/nearest_colour.h"

namespace loomlight {
namespace {

constexpr double kMostAbsorption = 10000;  // of a valid fabric
constexpr float kTolerance = 1e-3f;        // of reflectance: less is not seen

/// One channel of the walks as a function of one absorption: mean of weight exp(-sigma length).
class Channel {
 public:
  Channel(const PathLengthTally& walks, const std::vector<Rgb>& absorption_per_mm, size_t material, int channel)
      : walks_(walks), material_(material) {
    weights_.reserve(walks.lit());
    for (size_t i = 0; i < walks.lengths_mm.size(); i += walks.materials) {
      double exponent = 0;
      for (size_t k = 0; k < walks.materials; ++k)
        if (k != material) exponent += absorption_per_mm[k][channel] * walks.lengths_mm[i + k];
      weights_.push_back(std::exp(-exponent) / static_cast<double>(walks.count));
    }
  }

  struct Value {
    double colour = 0, slope = 0;  ///< and its derivative, < 0
  };
  Value at(double sigma) const {
    Value value;
    for (size_t i = 0; i < weights_.size(); ++i) {
      const double length = walks_.lengths_mm[i * walks_.materials + material_];
      const double light = weights_[i] * std::exp(-sigma * length);
      value.colour += light;
      value.slope -= light * length;
    }
    return value;
  }

 private:
  const PathLengthTally& walks_;
  size_t material_;
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

}  // namespace

SolvedColour solveColour(const PathLengthTally& walks, std::vector<Rgb> absorption_per_mm, int material,
                         const Rgb& wanted) {
  assert(walks.lit() > 0 && absorption_per_mm.size() == walks.materials);
  SolvedColour solved;
  const auto own = static_cast<size_t>(material);
  std::vector<Channel> channels;
  Rgb darkest, lightest;
  for (int c = 0; c < 3; ++c) {
    channels.emplace_back(walks, absorption_per_mm, own, c);
    lightest[c] = static_cast<float>(channels.back().at(0).colour);
    darkest[c] = static_cast<float>(channels.back().at(kMostAbsorption).colour);
    solved.tooLight |= wanted[c] > lightest[c] + kTolerance;
    solved.tooDark |= wanted[c] < darkest[c] - kTolerance;
    // As dark as can be asks for no more dye than makes a difference.
    darkest[c] = std::min(darkest[c] + kTolerance, lightest[c]);
  }
  // Each channel has a dye of its own, so all between the two can be had.
  const Rgb target = nearestColour(wanted, darkest, lightest);
  for (int c = 0; c < 3; ++c)
    if (target[c] < lightest[c])
      solved.absorption_per_mm[c] = static_cast<float>(absorptionFor(channels[static_cast<size_t>(c)], target[c]));
  absorption_per_mm[own] = solved.absorption_per_mm;
  solved.reached = walks.colour(absorption_per_mm);
  return solved;
}

}  // namespace loomlight
