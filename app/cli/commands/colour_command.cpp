#include "app/cli/commands/colour_command.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/swatches.h"
#include "render/colour/colour_difference.h"
#include "render/transport/dye_walks.h"

// How it works. Light is walked through the cloth once, and its reflectance in every band is read off the lengths that
// it has gone inside the fibres. All else is arithmetic on reflectances: CIELAB under each lamp, the differences
// between two, and how much of a difference is a lamp's doing (metamerism).

namespace loomlight {
namespace {

/// A cloth or a swatch, as it reflects.
struct Sample {
  std::string name;
  Reflectance reflectance;
};

struct Lamp {
  std::string name;
  TristimulusWeights weights;
};

/// What is said of a sample under one lamp.
struct Finding {
  Lab lab;
  std::optional<Judgement> beside;  ///< the standard, where there is one
};

/// nullopt when stopped.
std::optional<Sample> sampleFrom(const std::string& file, const FabricOptions& options, const ColourCommand& command) {
  if (isSwatchFile(file)) {
    const MeasuredSwatch swatch = swatchFrom(file);
    return Sample{swatch.name, {bandReflectance(swatch), {}}};
  }
  const Fabric fabric = withOptions(fabricFromFile(file, command.wif), options);
  const Interrupt interrupt;
  Progress progress("walking light through the cloth");
  Task task = interrupt.task(command.threads);
  task.progress = [&progress](double fraction) { progress.update(fraction); };
  const auto walks = walkForDyes(fabric, wholePiece(), task);
  if (!walks) return std::nullopt;
  return Sample{fabric.name, walks->reflectance(colouringInDaylight(fabric))};
}

Finding find(const Sample& sample, const Sample* standard, const Lamp& lamp, const Lamp& reference) {
  if (!standard) return {labUnder(lamp.weights, sample.reflectance.mean), {}};
  const Judgement judgement =
      judged(standard->reflectance.mean, sample.reflectance.mean, lamp.weights, reference.weights);
  return {judgement.sample, judgement};
}

nlohmann::ordered_json toJson(const Lab& lab) {
  return {{"L", lab.L}, {"a", lab.a}, {"b", lab.b}};
}

nlohmann::ordered_json toJson(const Sample& sample) {
  nlohmann::ordered_json json{{"name", sample.name},
                              {"from_nm", kFirstBand_nm},
                              {"step_nm", kBandStep_nm},
                              {"reflectance", sample.reflectance.mean}};
  if (sample.reflectance.standardError != Spectrum{}) json["standard_error"] = sample.reflectance.standardError;
  return json;
}

void printJson(const Sample& sample, const Sample* standard, const std::vector<Lamp>& lamps,
               const std::vector<Finding>& findings, const ColourCommand& command) {
  nlohmann::ordered_json json = toJson(sample);
  json["observer_degrees"] = command.observer == Observer::degrees2 ? 2 : 10;
  if (standard) json["standard"] = toJson(*standard);
  if (standard) json["tolerance_cmc_2_1"] = command.tolerance;
  for (size_t i = 0; i < lamps.size(); ++i) {
    nlohmann::ordered_json under{{"name", lamps[i].name}, {"lab", toJson(findings[i].lab)}};
    if (const auto& beside = findings[i].beside) {
      under["standard_lab"] = toJson(beside->standard);
      under["ciede2000"] = beside->ciede2000;
      under["cmc_2_1"] = beside->cmc;
      under["metamerism_index"] = beside->metamerism;
      under["passes"] = beside->passes(command.tolerance);
    }
    json["illuminants"].push_back(std::move(under));
  }
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string text(const Lab& lab) {
  return fmt::format("L* {:5.1f}  a* {:6.1f}  b* {:6.1f}", lab.L, lab.a, lab.b);
}

void printTable(const Sample& sample, const Sample* standard, const std::vector<Lamp>& lamps,
                const std::vector<Finding>& findings, const ColourCommand& command) {
  fmt::print("{}, by the CIE observer for {} degrees, lit from everywhere and seen from above\n", sample.name,
             command.observer == Observer::degrees2 ? 2 : 10);
  fmt::print("reflectance, %:");
  for (size_t j = 2; j < kBands; j += 4)
    fmt::print("  {:.1f} at {}", 100 * sample.reflectance.mean[j], bandWavelength_nm(j));
  fmt::print(" nm\n");
  for (size_t i = 0; i < lamps.size(); ++i) fmt::print("{:8} {}\n", lamps[i].name, text(findings[i].lab));
  if (!standard) return;
  fmt::print("against {}, tolerance {} CMC(2:1)\n", standard->name, command.tolerance);
  for (size_t i = 0; i < lamps.size(); ++i) {
    const Judgement& of = *findings[i].beside;
    fmt::print("{:8} {}   CIEDE2000 {:.2f}  CMC(2:1) {:.2f}  {}", lamps[i].name, text(of.standard), of.ciede2000,
               of.cmc, of.passes(command.tolerance) ? "pass" : "FAIL");
    if (i > 0) fmt::print("  metamerism {:.2f} from {}", of.metamerism, lamps[0].name);
    fmt::print("\n");
  }
}

}  // namespace

int run(const ColourCommand& command) {
  std::vector<Lamp> lamps;
  for (const std::string& name : command.illuminants)
    lamps.push_back({name, tristimulusWeights(illuminantCalled(name), command.observer)});
  const auto sample = sampleFrom(command.input, command.options, command);
  if (!sample) return Interrupt::kExitStatus;
  std::optional<Sample> standard;
  if (!command.standard.empty()) {
    standard = sampleFrom(command.standard, command.standardOptions, command);
    if (!standard) return Interrupt::kExitStatus;
  }
  const Sample* const against = standard ? &*standard : nullptr;
  std::vector<Finding> findings;
  for (const Lamp& lamp : lamps) findings.push_back(find(*sample, against, lamp, lamps[0]));
  if (command.json)
    printJson(*sample, against, lamps, findings, command);
  else
    printTable(*sample, against, lamps, findings, command);
  const auto& underFirst = findings[0].beside;
  return !underFirst || underFirst->passes(command.tolerance) ? 0 : 1;
}

}  // namespace loomlight
