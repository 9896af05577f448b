#include "core/fabric/wif/wif_yarns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/period.h"
#include "core/base/rgb.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_stand_ins.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"

// How it works. Every end and pick of a file is of a kind: which yarn of mine it is made from, of which colour, how
// many times as thick. Where that makes more kinds than a fabric has yarns, some stand in for others (wif_stand_ins,
// Gonzalez 1985), by their distance in colour and thickness. Each kind that is left becomes a yarn: dyed in its
// colour, with one fibre for each colour, and with a count that is larger by the square of its thickness. The
// sequences are cut to their shortest period. Cost: linear in ends and picks, and the number of kinds times that of
// yarns.

namespace loomlight {
namespace {

using Warnings = std::vector<WifWarning>;

/// A yarn of the fabric to be: one of mine, dyed in a colour of the palette, and perhaps thicker.
struct Kind {
  int base = 0;         ///< in mine.yarns
  int system = 0;       ///< 1 for the weft where its yarn is not that of the warp
  int colour = 0;       ///< 0: mine
  int permille = 1000;  ///< of the usual diameter
  auto key() const { return std::tie(base, system, colour, permille); }
  friend bool operator<(const Kind& a, const Kind& b) { return a.key() < b.key(); }
};

/// Sizes are those of the first `sized` threads; what the file says of others is not to be relied on.
std::vector<Kind> kindsOfThreads(const std::vector<int>& colours, const WifSizes& sizes, int sized, int base,
                                 int system) {
  std::vector<double> thick = relativeThickness(sizes, sized);
  thick.resize(colours.size(), 1.0);
  std::vector<Kind> kinds;
  for (size_t thread = 0; thread < colours.size(); ++thread) {
    constexpr double kMostRatio = 1000.0;
    const double held = std::clamp(thick[thread], 1.0 / kMostRatio, kMostRatio);
    kinds.push_back({base, system, colours[thread], static_cast<int>(std::lround(1000.0 * held))});
  }
  return kinds;
}

/// What the eye tells yarns by: colour; a doubling of the diameter counts as half the way from black to white; and
/// yarns that are spun otherwise, or are of the other system, stay apart.
YarnPoint pointOf(const Kind& kind, const WifPalette& palette) {
  const Rgb colour = kind.colour > 0 ? palette.srgb(palette.colours.at(kind.colour)) : Rgb(1.0f);
  return {colour.r, colour.g, colour.b, 0.5 * std::log2(kind.permille / 1000.0),
          static_cast<double>(kind.base + kind.system)};
}

/// Leaves at most kMaxKinds kinds of yarn: the others become the nearest of those.
void reduceKinds(std::vector<Kind>& warp, std::vector<Kind>& weft, const WifPalette& palette, Warnings& warnings) {
  std::map<Kind, int> counts;
  for (const auto* kinds : {&warp, &weft})
    for (const Kind& kind : *kinds) ++counts[kind];
  if (counts.size() <= static_cast<size_t>(kMaxKinds)) return;
  std::vector<Kind> all;
  for (const auto& [kind, count] : counts) all.push_back(kind);
  const auto commonest = std::max_element(all.begin(), all.end(),
                                          [&](const Kind& a, const Kind& b) { return counts.at(a) < counts.at(b); });
  std::iter_swap(all.begin(), commonest);
  std::vector<YarnPoint> points;
  for (const Kind& kind : all) points.push_back(pointOf(kind, palette));
  const std::vector<size_t> standIn = standIns(points, kMaxKinds);
  std::map<Kind, Kind> instead;
  double colourStep = 0, thicknessStep = 1;
  for (size_t i = 0; i < all.size(); ++i) {
    const size_t by = standIn[i];
    instead.emplace(all[i], all[by]);
    for (size_t channel = 0; channel < 3; ++channel)
      colourStep = std::max(colourStep, 255 * std::abs(points[i][channel] - points[by][channel]));
    thicknessStep = std::max(thicknessStep, std::exp2(2 * std::abs(points[i][3] - points[by][3])));
  }
  for (auto* kinds : {&warp, &weft})
    for (Kind& kind : *kinds) kind = instead.at(kind);
  warnings.push_back(
      {fmt::format(
           "The threads have {} combinations of colour and thickness, a fabric has at most {} yarns; the others "
           "become the nearest of these, which is off by {:.0f} of 255 in a channel of a colour and by a factor "
           "of {:.2f} in thickness at most.",
           all.size(), kMaxKinds, colourStep, thicknessStep),
       {},
       WifConcern::look});
}

/// The fibres of a fabric to be: mine, each in the colours of the palette that its yarns have.
class DyedFibres {
 public:
  DyedFibres(Fabric& fabric, const WifPalette& palette) : fabric_(fabric), palette_(palette), mine_(fabric.fibres) {
    fabric_.fibres.clear();
  }
  const std::vector<Fibre>& mine() const { return mine_; }
  /// Its number in the fabric; none where there is no room for another. `colour` 0: as it is.
  std::optional<int> in(int fibre, int colour) {
    const auto [known, isNew] = numbers_.emplace(std::pair(fibre, colour), static_cast<int>(fabric_.fibres.size()));
    if (!isNew) return known->second;
    if (fabric_.fibres.size() == kMaxKinds) {
      numbers_.erase(known);
      return std::nullopt;
    }
    Fibre given = mine_[fibre];
    if (colour > 0) {  // what I called mine says nothing of one of another colour
      given = dyed(given, linearFromSrgb(palette_.srgb(palette_.colours.at(colour))));
      given.name = fibreNameFor(fabric_, kindName(given.name));
    }
    fabric_.fibres.push_back(std::move(given));
    return known->second;
  }

 private:
  Fabric& fabric_;
  const WifPalette& palette_;
  const std::vector<Fibre> mine_;
  std::map<std::pair<int, int>, int> numbers_;  ///< of mine, and colour
};

/// Gives the fabric, which is a copy of mine, the yarns of these threads. A blend stays one, with both of its fibres in
/// the colour of the thread, as cloth that is dyed in the piece; where there is no room for its second fibres, of the
/// first alone.
std::vector<WifYarn> dress(Fabric& fabric, const std::vector<Kind>& warp, const std::vector<Kind>& weft,
                           const WifPalette& palette, Warnings& warnings) {
  const std::vector<Yarn> myYarns = fabric.yarns;
  DyedFibres fibres(fabric, palette);
  std::map<Kind, int> yarnOf;
  for (const auto* kinds : {&warp, &weft})
    for (const Kind& kind : *kinds) yarnOf.emplace(kind, 0);
  fabric.yarns.clear();
  std::vector<WifYarn> given;
  bool held = false;
  for (auto& [kind, index] : yarnOf) {
    index = static_cast<int>(fabric.yarns.size());
    Yarn yarn = myYarns[kind.base];
    const double diameters = kind.permille / 1000.0;
    if (kind.permille != 1000) yarn = heavier(yarn, meanFibre(yarn, fibres.mine()), diameters * diameters, held);
    yarn.fibre = fibres.in(yarn.fibre, kind.colour).value();          // there are no more of these than of yarns
    if (kind.colour > 0 || kind.permille != 1000) yarn.name.clear();  // it said nothing of another colour or thickness
    given.push_back({kind.colour, fabric.fibres[yarn.fibre].absorption_per_mm, {}});
    fabric.yarns.push_back(yarn);
  }
  int unblended = 0;
  for (const auto& [kind, index] : yarnOf) {
    Yarn& yarn = fabric.yarns[index];
    if (!yarn.blendFibre) continue;
    yarn.blendFibre = fibres.in(*yarn.blendFibre, kind.colour);
    if (yarn.blendFibre) continue;
    yarn.blendShare.reset();
    ++unblended;
  }
  if (unblended > 0)
    warnings.push_back(
        {fmt::format("A fabric has at most {} fibres; {} yarns are of the first fibre of your blend alone.", kMaxKinds,
                     unblended),
         {},
         WifConcern::look});
  if (held) warnings.push_back(heldYarns());
  const auto sequence = [&yarnOf](const std::vector<Kind>& kinds) {
    std::vector<int> yarns;
    for (const Kind& kind : kinds) yarns.push_back(yarnOf.at(kind));
    return shortestRepeat(std::move(yarns));
  };
  fabric.colourways.clear();         // they were of my fibres, by number
  fabric.mill.selvedgeYarn.reset();  // it was the number of one of my yarns
  fabric.warpSequence = sequence(warp);
  fabric.weftSequence = sequence(weft);
  return given;
}

}  // namespace

double tidy(double value) {
  return std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr);
}

Yarn heavier(Yarn yarn, const Fibre& fibre, double factor, bool& held) {
  const double inYarn = fibresInYarn(yarn, fibre);
  const double most = std::min(factor, 0.999 * kMaxFibresInYarn / inYarn);
  if (yarn.fibresPerPly) {
    const FieldInfo range = fieldInfo(&Yarn::fibresPerPly);
    const double wanted = std::floor(*yarn.fibresPerPly * most + 0.5);
    yarn.fibresPerPly = static_cast<int>(std::clamp(wanted, range.min, range.max));
    held = held || most < factor || wanted < range.min || wanted > range.max;
  } else {
    const FieldInfo range = fieldInfo(&Yarn::count_tex);
    const double wanted = yarn.count_tex * most;
    yarn.count_tex = tidy(std::clamp(wanted, range.min, range.max));
    held = held || most < factor || wanted < range.min || wanted > range.max;
  }
  return yarn;
}

std::vector<WifYarn> dressThreads(Fabric& fabric, const WifDocument& document, Warnings& warnings) {
  const WifRest& rest = document.rest;
  const int warpBase = fabric.warpYarn(0), weftBase = fabric.weftYarn(0);
  const int ends = sizedThreads(rest.warp, document.ends(), document.named.ends);
  const int picks = sizedThreads(rest.weft, document.picks(), document.named.picks);
  const bool apart = warpBase == weftBase && usualThickness_mm(rest.warp, ends) != usualThickness_mm(rest.weft, picks);
  std::vector<Kind> warp = kindsOfThreads(document.warpColours, rest.warp, ends, warpBase, 0);
  std::vector<Kind> weft = kindsOfThreads(document.weftColours, rest.weft, picks, weftBase, apart ? 1 : 0);
  reduceKinds(warp, weft, rest.palette, warnings);
  return dress(fabric, warp, weft, rest.palette, warnings);
}

WifWarning heldYarns() {
  return {"The file has yarns thicker or thinner than a yarn can be here; they are held to what it can.", {}};
}

std::shared_ptr<const WifOrigin> withSizesOf(WifOrigin origin, const Fabric& fabric) {
  origin.ends_per_cm = fabric.ends_per_cm;
  origin.picks_per_cm = fabric.picks_per_cm;
  origin.warpDiameter_mm = meanDiameter_mm(fabric, System::warp);
  origin.weftDiameter_mm = meanDiameter_mm(fabric, System::weft);
  const auto diameters = [&fabric](const WifSizes& sizes, System system) {
    return sizes.hasSingle() ? shortestRepeat(threadDiameters_mm(fabric, system)) : std::vector<double>();
  };
  origin.warpDiameters_mm = diameters(origin.rest.warp, System::warp);
  origin.weftDiameters_mm = diameters(origin.rest.weft, System::weft);
  origin.warpSpacing = fabric.warpSpacing;
  origin.weftSpacing = fabric.weftSpacing;
  return std::make_shared<const WifOrigin>(std::move(origin));
}

}  // namespace loomlight
