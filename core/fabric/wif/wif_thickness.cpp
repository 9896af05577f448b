#include "core/fabric/wif/wif_thickness.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Whether spacing is how the file says that threads are thick and thin.
bool saysThicknessBySpacing(const Lengths& thick, const Lengths& apart) {
  if (varies(thick) || !varies(apart)) return false;
  return thick.empty() || thick[0] > *std::min_element(apart.begin(), apart.end());
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
  return known.empty() ? std::nullopt : std::optional(mostCommon(known));
}

std::vector<double> relativeThickness(const WifSizes& sizes, int threads) {
  const Lengths thick = thicknesses(sizes, threads), apart = spacings(sizes, threads);
  if (varies(thick)) return relative(thick);
  if (saysThicknessBySpacing(thick, apart)) return relative(apart);
  return Lengths(static_cast<size_t>(threads), 1.0);
}

std::optional<WifWarning> unevenSpacing(const WifSizes& sizes, int threads, const char* what) {
  const Lengths thick = thicknesses(sizes, threads), apart = spacings(sizes, threads);
  if (!varies(apart)) return std::nullopt;
  const Lengths ratios = relative(apart);
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  const char* const yarns = saysThicknessBySpacing(thick, apart)
                                ? "; taken as thick and thin, they have yarns of such diameters, and lie"
                                : "; here they lie";
  return WifWarning{fmt::format("{} lie {:.3g} to {:.3g} times the usual distance apart in the file{} at one distance, "
                                "the mean. The file's own spacing is kept for export.",
                                what, *least, *most, yarns),
                    {}};
}

}  // namespace loomlight
