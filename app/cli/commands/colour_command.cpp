#include "app/cli/commands/colour_command.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/judging_lamp.h"
#include "app/cli/part_names.h"
#include "app/cli/progress.h"
#include "app/cli/swatches.h"
#include "core/base/error.h"
#include "core/fabric/json/json_text.h"
#include "render/colour/colour_difference.h"
#include "render/transport/dye_paths.h"

// How it works. Light is traced through the cloth once, and its reflectance in every band is read off the lengths that
// it has gone inside the fibres. All else is arithmetic on reflectances: CIELAB under each lamp, the differences
// between two, and how much of a difference is a lamp's doing (metamerism).

namespace loomlight {
namespace {

/// A cloth, a part of one or a swatch, as it reflects.
struct Sample {
  std::string name;
  std::string part;  ///< of a cloth: "yarn 2 'navy'"; empty: the piece
  Reflectance reflectance;
  bool isMeasured = false;
  SpecularComponent specular = SpecularComponent::unknown;  ///< of what was measured

  std::string text() const {
    std::string more = part.empty() ? "" : ", " + part;
    if (const std::string_view specularly = specularText(specular); !specularly.empty())
      more += fmt::format(" ({})", specularly);
    return name + more;
  }
};

/// What is said of a sample under one lamp.
struct Finding {
  Lab lab;
  std::optional<Judgement> beside;  ///< the standard, where there is one
};

Sample measuredSample(const ColourSide& side) {
  if (!side.part.empty())
    throw InputError(
        fmt::format("{}: expected a fabric, which has yarns and fibres, for the part '{}', got a measured "
                    "swatch",
                    side.file, side.part));
  const MeasuredSwatch swatch = swatchFrom(side.file);
  return {swatch.name, "", {bandReflectance(swatch), {}}, true, swatch.specular};
}

/// nullopt when stopped.
std::optional<Sample> wovenSample(const ColourSide& side, const ColourCommand& command) {
  const Fabric fabric = withOptions(fabricFrom({side.file, command.wif}), side.options, side.file);
  const ClothPart part =
      side.part.empty() ? wholePiece() : partNamed(side.part, fabric, NamedParts::yarnsAndFibres, side.file);
  const Interrupt interrupt;
  Progress progress("tracing light through the cloth");
  const Task task = progress.of(interrupt.task(command.threads));
  const auto paths = tracePathsForDyes(fabric, part, task, DyePaths::toJudge, kToldError);
  if (!paths) return std::nullopt;
  if (paths->lit() == 0)
    throw InputError(fmt::format("{}: expected a part that lies on the face, where it shows its colour, got {}",
                                 side.file, partText(part, fabric)));
  return Sample{fabric.name, part == wholePiece() ? "" : partText(part, fabric),
                paths->reflectance(colouringInDaylight(fabric))};
}

std::optional<Sample> sampleFrom(const ColourSide& side, const ColourCommand& command) {
  return isSwatch(side.file) ? measuredSample(side) : wovenSample(side, command);
}

/// What is not said of the standard is as it is of the sample, where both are of one cloth. Without a file: there is
/// none.
ColourSide standardOf(const ColourCommand& command) {
  ColourSide standard = command.standard;
  if (!standard.file.empty() || (standard.part.empty() && standard.options.colourway.empty())) return standard;
  standard.file = command.sample.file;
  if (standard.part.empty()) standard.part = command.sample.part;
  if (standard.options.colourway.empty()) standard.options = command.sample.options;
  return standard;
}

/// Instruments that count the mirrored light and those that do not differ by more than dyers tolerate.
void warnOfSpecular(const Sample& sample, const Sample& standard) {
  const bool known = sample.specular != SpecularComponent::unknown && standard.specular != SpecularComponent::unknown;
  if (known && sample.specular != standard.specular)
    fmt::print(stderr, "{} and {} were measured in different ways: expect a difference that is not one of dyes\n",
               sample.text(), standard.text());
}

Finding find(const Sample& sample, const Sample* standard, const JudgingLamp& lamp, const JudgingLamp& reference) {
  if (!standard) return {labUnder(lamp.weights, sample.reflectance.mean), {}};
  const Judgement judgement =
      judged(standard->reflectance.mean, sample.reflectance.mean, lamp.weights, reference.weights);
  return {judgement.sample, judgement};
}

nlohmann::ordered_json toJson(const Lab& lab) {
  return {{"L", lab.L}, {"a", lab.a}, {"b", lab.b}};
}

nlohmann::ordered_json toJson(const Sample& sample) {
  nlohmann::ordered_json json{{"name", sample.name}};
  if (!sample.part.empty()) json["part"] = sample.part;
  if (sample.specular != SpecularComponent::unknown)
    json["specular"] = sample.specular == SpecularComponent::included ? "included" : "excluded";
  json["from_nm"] = kFirstBand_nm;
  json["step_nm"] = kBandStep_nm;
  json["reflectance"] = sample.reflectance.mean;
  if (sample.reflectance.standardError != Spectrum{}) json["standard_error"] = sample.reflectance.standardError;
  return json;
}

void printJson(const Sample& sample, const Sample* standard, const std::vector<JudgingLamp>& lamps,
               const std::vector<Finding>& findings, const ColourCommand& command) {
  nlohmann::ordered_json json = toJson(sample);
  json["observer_degrees"] = command.observer == Observer::degrees2 ? 2 : 10;
  if (standard) json["standard"] = toJson(*standard);
  if (standard) json["tolerance_cmc_2_1"] = command.tolerance;
  for (size_t i = 0; i < lamps.size(); ++i) {
    nlohmann::ordered_json under{{"name", lamps[i].name}, {"lab", toJson(findings[i].lab)}};
    if (const auto& beside = findings[i].beside) {
      under["standard_lab"] = toJson(beside->standard);
      const LchDifference by = lchDifference(beside->standard, beside->sample);
      under["delta"] = {{"L", by.L}, {"C", by.C}, {"H", by.H}};
      under["ciede2000"] = beside->ciede2000;
      under["cmc_2_1"] = beside->cmc;
      under["metamerism_index"] = beside->metamerism;
      under["passes"] = beside->passes(command.tolerance);
    }
    json["illuminants"].push_back(std::move(under));
  }
  fmt::print("{}\n", jsonText(json, 2));
}

std::string text(const Lab& lab) {
  return fmt::format("L* {:5.1f}  a* {:6.1f}  b* {:6.1f}", lab.L, lab.a, lab.b);
}

void printTable(const Sample& sample, const Sample* standard, const std::vector<JudgingLamp>& lamps,
                const std::vector<Finding>& findings, const ColourCommand& command) {
  fmt::print("{}, by the CIE observer for {} degrees{}\n", sample.text(),
             command.observer == Observer::degrees2 ? 2 : 10,
             sample.isMeasured ? "" : ", lit from everywhere and seen from above");
  fmt::print("reflectance, %:");
  for (size_t j = 2; j < kBands; j += 4)
    fmt::print("  {:.1f} at {}", 100 * sample.reflectance.mean[j], bandWavelength_nm(j));
  fmt::print(" nm\n");
  for (size_t i = 0; i < lamps.size(); ++i) fmt::print("{:8} {}\n", lamps[i].name, text(findings[i].lab));
  if (!standard) return;
  fmt::print("against {}, tolerance {} CMC(2:1)\n", standard->text(), command.tolerance);
  for (size_t i = 0; i < lamps.size(); ++i) {
    const Judgement& of = *findings[i].beside;
    const LchDifference by = lchDifference(of.standard, of.sample);
    fmt::print("{:8} {}   dL* {:+.2f}  dC* {:+.2f}  dH* {:+.2f}\n", lamps[i].name, text(of.standard), by.L, by.C, by.H);
    fmt::print("{:8} CIEDE2000 {:.2f}  CMC(2:1) {:.2f}  {}", "", of.ciede2000, of.cmc,
               of.passes(command.tolerance) ? "pass" : "FAIL");
    if (i > 0) fmt::print("  metamerism {:.2f} from {}", of.metamerism, lamps[0].name);
    fmt::print("\n");
  }
}

}  // namespace

int run(const ColourCommand& command) {
  std::vector<JudgingLamp> lamps;
  for (const std::string& name : command.illuminants) lamps.push_back(judgingLamp(name, command.observer));
  const auto sample = sampleFrom(command.sample, command);
  if (!sample) return Interrupt::kExitStatus;
  std::optional<Sample> standard;
  if (const ColourSide side = standardOf(command); !side.file.empty()) {
    standard = sampleFrom(side, command);
    if (!standard) return Interrupt::kExitStatus;
    warnOfSpecular(*sample, *standard);
  }
  const Sample* const against = standard ? &*standard : nullptr;
  std::vector<Finding> findings;
  for (const JudgingLamp& lamp : lamps) findings.push_back(find(*sample, against, lamp, lamps[0]));
  if (command.json)
    printJson(*sample, against, lamps, findings, command);
  else
    printTable(*sample, against, lamps, findings, command);
  const auto& underFirst = findings[0].beside;
  return !underFirst || underFirst->passes(command.tolerance) ? 0 : ColourCommand::kFails;
}

}  // namespace loomlight
