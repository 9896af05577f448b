#include "render/transport/dye_paths.h"

#include <algorithm>
#include <cmath>

#include "render/colour/colour_space.h"
#include "render/transport/colour_patch.h"

namespace loomlight {
namespace {

/// What comes back of white light where all fibres absorb alike.
double greyOf(const PathLengthTally& paths, double absorption_per_mm) {
  double sum = 0;
  for (size_t i = 0; i < paths.lengths_mm.size(); i += paths.materials) {
    double length_mm = 0;
    for (size_t k = 0; k < paths.materials; ++k) length_mm += paths.lengths_mm[i + k];
    sum += std::exp(-absorption_per_mm * length_mm);
  }
  return sum / static_cast<double>(paths.count);
}

/// Channels with less of a dye and with more of it.
struct TwoDepths {
  double light = 0, dark = 0;                     ///< means of what comes back
  double byBoth = 0, darkByBoth = 0, byDark = 0;  ///< one standard error of the light ones, what the dark ones err with
                                                  ///< it, and what they err by themselves
};

/// The light of a path in one dye times its light in another is that in both together.
TwoDepths depthsOf(const PathLengthTally& paths, double less_per_mm, double more_per_mm) {
  const auto n = static_cast<double>(paths.count);
  TwoDepths depths{greyOf(paths, less_per_mm), greyOf(paths, more_per_mm)};
  const auto covariance = [&](double one_per_mm, double other_per_mm, double means) {
    return (greyOf(paths, one_per_mm + other_per_mm) - means) / (n - 1);
  };
  depths.byBoth = std::sqrt(std::max(0.0, covariance(less_per_mm, less_per_mm, depths.light * depths.light)));
  if (depths.byBoth > 0)
    depths.darkByBoth = covariance(less_per_mm, more_per_mm, depths.light * depths.dark) / depths.byBoth;
  const double variance = covariance(more_per_mm, more_per_mm, depths.dark * depths.dark);
  depths.byDark = std::sqrt(std::max(0.0, variance - depths.darkByBoth * depths.darkByBoth));
  return depths;
}

/// CIEDE2000, root of the mean square, of a colour with these channels in the dark.
double errorOf(const TwoDepths& depths, const glm::bvec3& isDark) {
  const auto colour = [&isDark](double light, double dark) {
    return glm::mix(glm::dvec3(light), glm::dvec3(dark), isDark);
  };
  const glm::dvec3 mean = colour(depths.light, depths.dark);
  const auto off = [&](const glm::dvec3& by) { return ciede2000(labFromLinear(mean), labFromLinear(mean + by)); };
  return std::hypot(off(colour(depths.byBoth, depths.darkByBoth)), off(colour(0, depths.byDark)));
}

void append(PathLengthTally& tally, const PathLengthTally& more) {
  tally.materials = more.materials;
  tally.count += more.count;
  tally.lengths_mm.insert(tally.lengths_mm.end(), more.lengths_mm.begin(), more.lengths_mm.end());
}

}  // namespace

double colourError(const PathLengthTally& paths) {
  constexpr double kDarkest = 1.0 / 16, kFirst_per_mm = 1, kMost_per_mm = 1024;  // there surfaces alone are left
  if (paths.lit() == 0 || paths.count < 2) return 0;
  const double undyed = greyOf(paths, 0);
  double worst = 0, dark = undyed;
  for (double more_per_mm = kFirst_per_mm; dark > kDarkest * undyed && more_per_mm <= kMost_per_mm; more_per_mm *= 2)
    for (const double less_per_mm : {0.0, more_per_mm / 8}) {
      const TwoDepths depths = depthsOf(paths, less_per_mm, more_per_mm);
      dark = depths.dark;
      for (int channels = 0; channels < 8; ++channels)
        worst =
            std::max(worst, errorOf(depths, glm::bvec3((channels & 1) != 0, (channels & 2) != 0, (channels & 4) != 0)));
    }
  return worst;
}

std::optional<PathLengthTally> tracePathsForDyes(const Scene& scene, const Medium& medium, const ClothPart& part,
                                                 const Task& task, DyePaths use, double error) {
  constexpr double kFirstShare = 0.2;  // of the progress that is shown
  PathLengthTally tally;
  for (uint64_t round = 0; round < kMostDyePaths / kFirstDyePaths; ++round) {
    size_t wanted = kFirstDyePaths;
    if (round > 0) {
      const double missing = colourError(tally) / error;
      const double needed = std::ceil(static_cast<double>(tally.count) * missing * missing);
      if (needed <= static_cast<double>(tally.count) || tally.count >= kMostDyePaths) break;
      wanted = std::min(kMostDyePaths, static_cast<size_t>(needed)) - tally.count;
    }
    Task more = task;
    more.progress = [&](double fraction) {
      task.report(round == 0 ? kFirstShare * fraction
                             : kFirstShare + (1 - kFirstShare) * (round == 1 ? fraction : 1.0));
    };
    const auto traced =
        tallyPathLengths(scene, medium, part, wanted, more, 2 * round + (use == DyePaths::toJudge ? 1 : 0));
    if (!traced) return std::nullopt;
    append(tally, *traced);
    if (traced->count < wanted / 2) break;  // hardly any meets it
  }
  return tally;
}

std::optional<PathLengthTally> tracePathsForDyes(const Fabric& fabric, const ClothPart& part, const Task& task,
                                                 DyePaths use, double error) {
  const auto patch = makeColourPatch(fabric, task);
  return patch ? tracePathsForDyes(*patch->scene, *patch->medium, part, task, use, error) : std::nullopt;
}

}  // namespace loomlight
