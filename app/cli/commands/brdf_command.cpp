#include "app/cli/commands/brdf_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/cli/half_dome_picture.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/usage_error.h"
#include "app/export/file_set.h"
#include "app/export/picture.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/fabric/model/validate.h"
#include "render/media/fibre_medium.h"

namespace loomlight {
namespace {

/// The common part of the three files' names.
std::string stemOf(const std::string& output) {
  const std::string ending = lowerExtension(output);
  const bool ours = ending == ".exr" || ending == ".png" || ending == ".csv";
  return ours ? output.substr(0, output.size() - ending.size()) : output;
}

Fabric patch(const BrdfCommand& command) {
  Fabric fabric = withOptions(fabricFrom(command.input), command.options, command.input.file);
  if (!command.options.light) {
    fabric.light = Light{};
    fabric.light.kind = LightKind::directional;
    // Azimuth 0 and beyond the zenith to the other side: 135 degrees from the normal is light from behind.
    fabric.light.azimuth_deg = 0;
    fabric.light.elevation_deg = 90 - command.lightAngle_deg.value_or(0);
  }
  fabric.light.temperature_K = Light{}.temperature_K;  // reflectance is not tinted
  const LightKind kind = fabric.light.kind;
  if (kind != LightKind::directional && kind != LightKind::dome && kind != LightKind::back &&
      kind != LightKind::furnace)
    throw UsageError("--light: expected directional, dome, back or furnace, whose irradiance is known");
  if (paperRadiance(fabric.light) < 1e-3)
    throw UsageError("--light-angle: expected light that does not graze the cloth, got almost 90 degrees or darkness");
  validate(fabric, command.input.file);
  return halfDomePatch(std::move(fabric), command.grid);
}

}  // namespace

int run(const BrdfCommand& command) {
  Stopwatch whole;
  const std::string stem = stemOf(command.output);
  for (const char* ending : {".exr", ".png", ".csv"}) expectWritable(stem + ending);
  const Interrupt interrupt;
  const auto fabric = std::make_shared<const Fabric>(patch(command));
  Progress progress("measuring");
  const Task task = interrupt.task(command.threads);
  const auto scene = makeScene(fabric, task);
  const auto medium = scene ? makeMedium(*scene, {command.memoryLimit_bytes, command.fibreExtent}, task) : nullptr;
  const int samples = command.options.samplesPerPixel.value_or(BrdfCommand::kSamples);
  const auto measure =
      medium ? measureHalfDome(*scene, *medium, command.grid, samples, progress.of(task)) : std::nullopt;
  if (!measure) return Interrupt::kExitStatus;

  const double unit = paperRadiance(fabric->light);
  const std::filesystem::path path(stem);
  const std::string name = path.filename().string();
  FileSet set(path.parent_path().string(), name);
  writeExr(set.add(name + ".exr"), halfDomeImage(*measure, unit));
  writePng(set.add(name + ".png"), halfDomePicture(*measure, unit, command.tone));
  writeFileAtomically(set.add(name + ".csv"), halfDomeCsv(*measure, unit));
  set.place();
  fmt::print("{0}.exr, {0}.png, {0}.csv: {1} x {2} cameras, {3} paths each, {4}\n", stem, command.grid.azimuths,
             command.grid.inclinations, measure->counts.paths / command.grid.size(), durationText(whole.lap()));
  return 0;
}

}  // namespace loomlight
