#include "core/fabric/wif/wif_thickness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/period.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/wif/wif_entries.h"
#include "core/fabric/wif/wif_most_common.h"

namespace loomlight {
namespace {

using Lengths = std::vector<double>;

/// Of every thread; empty where not all of them have one.
template <class LengthOf>
Lengths lengths(int threads, LengthOf&& lengthOf) {
  Lengths all;
  for (int thread = 1; thread <= threads; ++thread)
    if (const std::optional<double> length = lengthOf(thread)) all.push_back(*length);
  return all.size() == static_cast<size_t>(threads) ? all : Lengths();
}

Lengths thicknesses(const WifSizes& sizes, int threads) {
  const std::optional<double> usual = usualThickness_mm(sizes, threads);
  return lengths(threads, [&](int thread) {
    const auto own = sizes.thickness_mm(thread);
    return own ? own : usual;
  });
}

Lengths spacings(const WifSizes& sizes, int threads) {
  return lengths(threads, [&](int thread) { return sizes.spacing_mm(thread); });
}

bool varies(const Lengths& lengths) {
  return std::adjacent_find(lengths.begin(), lengths.end(), std::not_equal_to<>()) != lengths.end();
}

/// Whether spacing is how the file says that threads are thick and thin: not where it gives single ones a thickness.
bool saysThicknessBySpacing(const WifSizes& sizes, const Lengths& thick, const Lengths& apart) {
  if (!sizes.thicknesses.empty() || varies(thick) || !varies(apart)) return false;
  return thick.empty() || thick[0] > *std::min_element(apart.begin(), apart.end());
}

int howMany(const std::map<int, double>& single, int threads) {
  return static_cast<int>(std::distance(single.begin(), single.upper_bound(threads)));
}

/// Whether single threads have a length, and nothing gives that of the others.
bool hasGaps(const std::map<int, double>& single, const std::optional<double>& common, int threads) {
  return !single.empty() && !common && howMany(single, threads) < threads;
}

Lengths relative(Lengths lengths) {
  const double usual = mostCommon(lengths);
  for (double& length : lengths) length /= usual;
  return lengths;
}

}  // namespace

std::optional<double> usualThickness_mm(const WifSizes& sizes, int threads) {
  Lengths known;
  for (int thread = 1; thread <= threads; ++thread)
    if (const auto thickness = sizes.thickness_mm(thread)) known.push_back(*thickness);
  // Those that a file lists by themselves are the odd ones; the others may be of any thickness.
  const bool areMost = 2 * known.size() > static_cast<size_t>(threads);
  return areMost ? std::optional(mostCommon(known)) : std::nullopt;
}

std::vector<double> relativeThickness(const WifSizes& sizes, int threads) {
  const Lengths thick = thicknesses(sizes, threads), apart = spacings(sizes, threads);
  if (varies(thick)) return relative(thick);
  if (saysThicknessBySpacing(sizes, thick, apart)) return relative(apart);
  return Lengths(static_cast<size_t>(threads), 1.0);
}

bool hasGaps(const WifSizes& sizes, int threads) {
  return hasGaps(sizes.spacings, sizes.spacing, threads) || hasGaps(sizes.thicknesses, sizes.thickness, threads);
}

int sizedThreads(const WifSizes& sizes, int threads, int named) {
  return named > 0 && hasGaps(sizes, threads) ? named : threads;
}

void noteGaps(const WifSizes& sizes, System system, int threads, WifWarnings& warnings) {
  const char* const thread = system == System::warp ? "end" : "pick";
  const auto note = [&](const char* section, const std::map<int, double>& single, const char* what,
                        const std::string& instead) {
    warnings.add(0, sectionName(system, section), "",
                 fmt::format("Only {} of {} {}s have a {}, and none is said for the others; {}.",
                             howMany(single, threads), threads, thread, what, instead));
  };
  const std::string kept = "it is only kept for export";
  if (hasGaps(sizes.thicknesses, sizes.thickness, threads))
    note(" THICKNESS", sizes.thicknesses, "thickness",
         usualThickness_mm(sizes, threads) ? "they get the usual yarn"
                                           : fmt::format("{}, and makes no {} thick or thin", kept, thread));
  if (hasGaps(sizes.spacings, sizes.spacing, threads))
    note(" SPACING", sizes.spacings, "spacing", fmt::format("{}, and all {}s lie at one distance", kept, thread));
}

std::vector<double> spacingOf(const WifSizes& sizes, int threads) {
  Lengths apart = spacings(sizes, threads);
  if (!varies(apart)) return {};
  if (saysThicknessBySpacing(sizes, thicknesses(sizes, threads), apart)) {
    const Lengths rooms = apart;
    for (size_t i = 0; i < rooms.size(); ++i) apart[i] = 0.5 * (rooms[i] + rooms[(i + 1) % rooms.size()]);
  }
  apart = relative(std::move(apart));
  const double most = *std::max_element(apart.begin(), apart.end()), fitting = std::max(1.0, most / kSpacingRange.max);
  for (double& distance : apart) {
    const double rounded = std::round(1000 * distance / fitting) / 1000;  // files round their lengths
    distance = std::clamp(rounded, kSpacingRange.min, kSpacingRange.max);
  }
  apart = shortestRepeat(std::move(apart));
  if (apart.size() == 1 || apart.size() > static_cast<size_t>(kMostSpacing)) return {};
  return apart;
}

std::optional<WifWarning> unevenSpacing(const WifSizes& sizes, int threads, const char* what, bool isWoven) {
  const Lengths thick = thicknesses(sizes, threads), apart = spacings(sizes, threads);
  if (!varies(apart)) return std::nullopt;
  const Lengths ratios = relative(apart);
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  const char* const yarns =
      saysThicknessBySpacing(sizes, thick, apart) ? "; taken as thick and thin, they have yarns of such diameters" : "";
  const char* const places = isWoven ? "so too, as far as they can" : "at one distance, the mean";
  return WifWarning{fmt::format("{} lie {:.3g} to {:.3g} times the usual distance apart in the file{}; here they lie "
                                "{}. The file's own spacing is kept for export.",
                                what, *least, *most, yarns, places),
                    {}};
}

}  // namespace loomlight
