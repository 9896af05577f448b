#include "render/transport/colour_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "render/colour/nearest_colour.h"
#include "render/colour/nearest_reflectance.h"
#include "render/colour/primaries.h"
#include "render/transport/path_light.h"

// How it works. A path through the cloth is known by its lengths inside each material, so its light is a product of
// exponentials of the absorptions, and the colour of the cloth a mean of those over all paths. As a function of one
// absorption, in one channel or band, that mean falls from what undyed fibres give to what black ones do: so each
// wanted value between the two has one absorption, found by Newton's method on the logarithm. Where a fibre is dyed
// in several materials at once, their lengths add up. Wanted values out of reach are first brought to the nearest
// that is.
//
// A dye of three numbers among fibres known in bands makes no three channels apart: what is left of a primary's
// spectrum shows a little in the others too. That little changes slowly, so the channels are solved in turn, each with
// what the others last added to it, until they settle.

namespace loomlight {
namespace {

constexpr double kMostAbsorption = 10000;  // of a valid fabric

/// The length of each path inside the materials that are dyed, mm.
std::vector<double> lengthsInside(const PathLengthTally& paths, std::span<const int> dyed) {
  std::vector<double> lengths;
  for (size_t i = 0; i < paths.lengths_mm.size(); i += paths.materials) {
    double length = 0;
    for (const int material : dyed) length += paths.lengths_mm[i + static_cast<size_t>(material)];
    lengths.push_back(length);
  }
  return lengths;
}

/// One channel or band of the paths as a function of one absorption: mean of weight exp(-sigma length).
class Channel {
 public:
  /// `lengths_mm`: of each path inside what is dyed. `weights`: what the other materials leave of its light. `count`:
  /// of all paths, those that did not come out too.
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

/// What a channel can be.
struct Range {
  double darkest = 0, lightest = 1;

  explicit Range(const Channel& channel)
      : darkest(channel.at(kMostAbsorption).colour), lightest(channel.at(0).colour) {}
  /// As dark as can be asks for no more dye than makes a difference.
  double darkestWorthwhile() const { return std::min(darkest + unseen(darkest), lightest); }
  bool isTooLight(double wanted) const { return wanted > lightest + unseen(lightest); }
  bool isTooDark(double wanted) const { return wanted < darkest - unseen(darkest); }

 private:
  /// By how much a reflectance may be off: below 0.2 of lightness. In the dark that is a share of it.
  static double unseen(double reflectance) { return std::min(1e-3, 0.01 * reflectance); }
};

/// What each primary of the dyed fibres' light adds to each channel of what is seen.
class PrimaryChannels {
 public:
  /// `colouring`: without the dye.
  PrimaryChannels(const PathLengthTally& paths, const Colouring& colouring, const std::vector<double>& lengths_mm) {
    const bool isApart = !colouring.isSpectral() && !colouring.eye.whole;
    std::array<std::vector<double>, 9> weights;
    for (size_t i = 0; i < paths.lengths_mm.size(); i += paths.materials) {
      const auto lengths = std::span(paths.lengths_mm).subspan(i, paths.materials);
      for (int c = 0; c < 3; ++c) {
        Rgb primary(0.0f);
        primary[c] = 1;
        const Rgb seen = colourOf({primary}, lengths, colouring);
        for (int o = 0; o < 3; ++o)
          if (o == c || !isApart) weights[at(o, c)].push_back(seen[o]);
      }
    }
    for (std::vector<double>& of : weights) channels_.emplace_back(lengths_mm, std::move(of), paths.count);
  }
  /// What primary c gives to its own channel.
  const Channel& own(int c) const { return channels_[at(c, c)]; }
  /// What the other two give to channel `o` with these absorptions.
  double others(int o, const Rgb& absorption_per_mm) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
      if (c != o) sum += channels_[at(o, c)].at(absorption_per_mm[c]).colour;
    return sum;
  }

 private:
  static size_t at(int o, int c) { return 3 * static_cast<size_t>(o) + static_cast<size_t>(c); }
  std::vector<Channel> channels_;
};

/// The materials forget what they absorb.
void bleach(Colouring& colouring, std::span<const int> materials) {
  for (const int material : materials) {
    const auto k = static_cast<size_t>(material);
    colouring.primaries_per_mm[k] = Rgb(0.0f);
    if (!colouring.isSpectral(k)) continue;
    colouring.bands_per_mm[k] = Spectrum{};
    colouring.knownInBands &= ~(uint64_t{1} << k);
  }
}

}  // namespace

SolvedColour solveColour(const PathLengthTally& paths, Colouring colouring, std::span<const int> dyed,
                         const Rgb& wanted) {
  constexpr int kMostRounds = 30;
  constexpr float kSettled = 1e-5f;  // of the colour
  constexpr float kBlack = 1e-4f;    // darker has no logarithm
  assert(paths.lit() > 0 && colouring.primaries_per_mm.size() == paths.materials);
  SolvedColour solved;
  const std::vector<double> lengths_mm = lengthsInside(paths, dyed);
  bleach(colouring, dyed);
  const PrimaryChannels primaries(paths, colouring, lengths_mm);
  Rgb before(0.0f);
  for (int round = 0; round < kMostRounds; ++round) {
    Rgb darkest(0.0f), lightest(0.0f), others(0.0f);
    solved.tooLight = solved.tooDark = false;
    for (int c = 0; c < 3; ++c) {
      const Range range(primaries.own(c));
      others[c] = static_cast<float>(primaries.others(c, solved.absorption_per_mm));
      solved.tooLight |= range.isTooLight(wanted[c] - others[c]);
      solved.tooDark |= range.isTooDark(wanted[c] - others[c]);
      lightest[c] = std::max(static_cast<float>(range.lightest) + others[c], kBlack);
      darkest[c] = std::clamp(static_cast<float>(range.darkestWorthwhile()) + others[c], kBlack, lightest[c]);
    }
    // Each channel has a dye of its own, so all between the two can be had.
    const Rgb target = nearestColour(wanted, darkest, lightest);
    for (int c = 0; c < 3; ++c)
      solved.absorption_per_mm[c] =
          target[c] < lightest[c] ? static_cast<float>(absorptionFor(primaries.own(c), target[c] - others[c])) : 0.0f;
    if (glm::all(glm::lessThan(glm::abs(others - before), Rgb(kSettled)))) break;
    before = others;
  }
  for (const int material : dyed) colouring.primaries_per_mm[static_cast<size_t>(material)] = solved.absorption_per_mm;
  solved.reached = paths.colour(colouring);
  return solved;
}

SolvedReflectance solveReflectance(const PathLengthTally& paths, Colouring colouring, std::span<const int> dyed,
                                   const Spectrum& wanted, const TristimulusWeights& lamp) {
  assert(paths.lit() > 0 && colouring.primaries_per_mm.size() == paths.materials);
  const std::vector<double> lengths_mm = lengthsInside(paths, dyed);
  for (const int material : dyed) colouring.setBands(static_cast<size_t>(material), Spectrum{});
  std::array<std::vector<double>, kBands> weights;
  for (size_t i = 0; i < paths.lengths_mm.size(); i += paths.materials) {
    const Spectrum left = leftInBands(std::span(paths.lengths_mm).subspan(i, paths.materials), colouring);
    for (size_t j = 0; j < kBands; ++j) weights[j].push_back(left[j]);
  }
  SolvedReflectance solved;
  std::vector<Channel> bands;
  Spectrum darkest, lightest;
  for (size_t j = 0; j < kBands; ++j) {
    bands.emplace_back(lengths_mm, std::move(weights[j]), paths.count);
    const Range range(bands.back());
    solved.tooLight += range.isTooLight(wanted[j]);
    solved.tooDark += range.isTooDark(wanted[j]);
    lightest[j] = static_cast<float>(range.lightest);
    darkest[j] = static_cast<float>(range.darkestWorthwhile());
  }
  // Each band has a dye of its own, so all between the two can be had.
  Spectrum target;
  if (solved.tooLight + solved.tooDark > 0)
    target = nearestReflectance(wanted, darkest, lightest, lamp);
  else
    for (size_t j = 0; j < kBands; ++j) target[j] = std::clamp(wanted[j], darkest[j], lightest[j]);
  for (size_t j = 0; j < kBands; ++j)
    if (target[j] < lightest[j]) solved.absorption_per_mm[j] = static_cast<float>(absorptionFor(bands[j], target[j]));
  for (const int material : dyed) colouring.setBands(static_cast<size_t>(material), solved.absorption_per_mm);
  solved.reached = paths.reflectance(colouring).mean;
  return solved;
}

}  // namespace loomlight
