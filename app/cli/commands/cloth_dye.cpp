#include "app/cli/commands/cloth_dye.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/cli/interrupt.h"
#include "app/cli/judging_lamp.h"
#include "app/cli/part_names.h"
#include "app/cli/progress.h"
#include "app/cli/swatches.h"
#include "core/base/error.h"
#include "core/base/rgb.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/band_colour.h"
#include "core/fabric/yarn/dyeing.h"
#include "render/colour/colour_difference.h"
#include "render/transport/colour_patch.h"
#include "render/transport/colour_solver.h"
#include "render/transport/dye_paths.h"

namespace loomlight {
namespace {

/// A wanted colour on its way.
struct Dyeing {
  ClothPart part;                          ///< a fibre, or the piece
  std::string name;                        ///< of that, before it was dyed
  Rgb wanted{0};                           ///< linear
  std::optional<Spectrum> measured;        ///< wanted in bands
  PathLengthTally paths, judging;          ///< that the dye is solved with, and others
  bool tooLight = false, tooDark = false;  ///< for this cloth
};

/// What is beyond the gamut of Rec. 709 is cut off.
Rgb linearColour(const NamedColour& colour) {
  if (!colour.lab) return colour.linear;
  const Lab lab{colour.lab->L, colour.lab->a, colour.lab->b};
  return glm::clamp(Rgb(linearFromLab(lab)), Rgb(0.0f), Rgb(1.0f));
}

std::string textOf(const Rgb& linear) {
  const Rgb shown = 255.0f * clippedSrgbFromLinear(linear);
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(shown.r), std::lround(shown.g), std::lround(shown.b));
}

std::vector<Dyeing> dyeingsOf(const Fabric& fabric, const std::vector<ClothColour>& wanted, const std::string& source) {
  std::vector<Dyeing> dyeings;
  for (const ClothColour& wish : wanted) {
    const ClothPart part = partNamed(wish.fibre, fabric, NamedParts::fibres, fmt::format("{}: --cloth-colour", source));
    for (const Dyeing& other : dyeings)
      if (other.part == part || other.part == wholePiece() || part == wholePiece())
        throw InputError(fmt::format("{}: --cloth-colour: expected one colour for each fibre, got two for {}", source,
                                     partText(std::max(part, other.part), fabric)));
    Dyeing& dyeing = dyeings.emplace_back();
    dyeing.part = part;
    dyeing.name = part == wholePiece() ? "the piece" : fabric.fibres[static_cast<size_t>(part.index)].name;
    dyeing.wanted = linearColour(wish.colour);
    if (wish.swatch.empty()) continue;
    dyeing.measured = reflectanceFrom(wish.swatch);
    dyeing.wanted = linearFromReflectance(*dyeing.measured);
  }
  return dyeings;
}

/// Traces light through the cloth for each. False when stopped.
bool tracePaths(const Fabric& fabric, std::vector<Dyeing>& dyeings) {
  const Interrupt interrupt;
  Progress progress("tracing light through the cloth");
  // Of the progress, the construction and each fibre's paths have equal parts.
  const double parts = 1.0 + 2 * static_cast<double>(dyeings.size());
  size_t done = 0;
  Task task;
  task.stop = interrupt.token();
  task.progress = [&](double fraction) { progress.update((static_cast<double>(done) + fraction) / parts); };
  const auto patch = makeColourPatch(fabric, task);
  if (!patch) return false;
  for (Dyeing& dyeing : dyeings) {
    for (const DyePaths use : {DyePaths::toSolve, DyePaths::toJudge}) {
      ++done;
      const double error = dyeing.measured && use == DyePaths::toSolve ? kDyeError : kToldError;
      auto paths = tracePathsForDyes(*patch->scene, *patch->medium, dyeing.part, task, use, error);
      if (!paths) return false;
      (use == DyePaths::toSolve ? dyeing.paths : dyeing.judging) = std::move(*paths);
    }
  }
  return true;
}

/// Dyes one fibre, the others as they are, or all alike. Whether that changed what is seen.
bool dye(Fabric& fabric, Dyeing& dyeing, const JudgingLamp& lamp) {
  constexpr float kSettled = 1e-3f;  // of a dye
  const std::vector<int> dyed = fibresOf(fabric, dyeing.part);
  Absorption absorption = fabric.fibres[static_cast<size_t>(dyed.front())].absorption_per_mm;
  bool settled = absorption.isSpectral() == dyeing.measured.has_value();
  if (dyeing.measured) {
    const SolvedReflectance solved =
        solveReflectance(dyeing.paths, colouringInDaylight(fabric), dyed, *dyeing.measured, lamp.weights);
    const Spectrum now = solved.absorption_per_mm, before = absorption.inBands();
    for (size_t j = 0; j < kBands; ++j) settled &= std::abs(now[j] - before[j]) <= kSettled * now[j];
    dyeing.tooLight = solved.tooLight > 0;
    dyeing.tooDark = solved.tooDark > 0;
    absorption = Absorption(now);
  } else {
    const SolvedColour solved = solveColour(dyeing.paths, colouringInDaylight(fabric), dyed, dyeing.wanted);
    const Rgb now = solved.absorption_per_mm, before = absorption.primaries;
    settled &= glm::all(glm::lessThanEqual(glm::abs(now - before), kSettled * now));
    dyeing.tooLight = solved.tooLight;
    dyeing.tooDark = solved.tooDark;
    absorption = now;
  }
  fabric = dyedAlike(std::move(fabric), dyeing.part, absorption);
  return !settled;
}

/// Light that met one fibre goes through others too: each is dyed anew until no dye changes what is seen.
void solve(Fabric& fabric, std::vector<Dyeing>& dyeings, const JudgingLamp& lamp) {
  constexpr int kMostRounds = 50;
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (Dyeing& dyeing : dyeings) changed |= dye(fabric, dyeing, lamp);
    if (!changed) break;
  }
}

std::string whyNot(const Dyeing& dyeing) {
  if (dyeing.tooLight && dyeing.tooDark) return "lighter and darker than this fibre can be in this cloth";
  return dyeing.tooLight ? "lighter than this cloth can be" : "darker than fibres can be, as their surface reflects";
}

/// What the cloth shows, told by paths that its dyes were not solved with.
void tell(const Dyeing& dyeing, const Colouring& colouring, const JudgingLamp& lamp) {
  const Rgb shown = dyeing.judging.colour(colouring);
  double difference = ciede2000(labFromLinear(glm::dvec3(dyeing.wanted)), labFromLinear(glm::dvec3(shown)));
  if (dyeing.measured)
    difference = ciede2000(labUnder(lamp.weights, *dyeing.measured),
                           labUnder(lamp.weights, dyeing.judging.reflectance(colouring).mean));
  const std::string by = dyeing.measured ? fmt::format("CIEDE2000 under {}, 10 degrees", lamp.name) : "CIEDE2000";
  const std::string reached = fmt::format("{}, off by {:.1f} ({})", textOf(shown), difference, by);
  const std::string wanted = textOf(dyeing.wanted);
  if (dyeing.tooLight || dyeing.tooDark)
    fmt::print("{}: {} cannot be had, it is {}: the nearest under {} is {}\n", dyeing.name, wanted, whyNot(dyeing),
               dyeing.measured ? lamp.name : "D65", reached);
  else
    fmt::print("{}: {} is wanted, the cloth shows {}\n", dyeing.name, wanted, reached);
}

}  // namespace

std::optional<Fabric> dyed(Fabric fabric, const std::vector<ClothColour>& wanted, const std::string& illuminant,
                           const std::string& source) {
  validate(fabric, source);
  const JudgingLamp lamp = judgingLamp(illuminant, Observer::degrees10);
  std::vector<Dyeing> dyeings = dyeingsOf(fabric, wanted, source);
  if (!tracePaths(fabric, dyeings)) return std::nullopt;
  for (const Dyeing& dyeing : dyeings)
    if (dyeing.paths.lit() == 0 || dyeing.judging.lit() == 0)
      throw InputError(
          fmt::format("{}: --cloth-colour: expected a fibre that lies on the face, where it shows its colour, got {}",
                      source, partText(dyeing.part, fabric)));
  solve(fabric, dyeings, lamp);
  const Colouring colouring = colouringInDaylight(fabric);
  for (const Dyeing& dyeing : dyeings) tell(dyeing, colouring, lamp);
  return fabric;
}

}  // namespace loomlight
