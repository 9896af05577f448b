#include "app/cli/commands/handover_command.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/export/file_name.h"
#include "app/export/handover/handover.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/colourways.h"

namespace loomlight {
namespace {

void makeFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw InputError(fmt::format("{}: expected a folder that can be made, got: {}", folder, failed.message()));
}

/// One cloth into one folder. False when interrupted.
bool handOver(const Fabric& fabric, const std::string& folder, const HandoverCommand& command,
              const Interrupt& interrupt) {
  Stopwatch whole;
  makeFolder(folder);
  std::optional<DigitalCloth> cloth;
  {
    Progress progress("handing over");
    Task task = interrupt.task(command.threads);
    task.progress = [&progress](double fraction) { progress.update(fraction); };
    cloth = makeDigitalCloth(fabric, command.order, command.memoryLimit_bytes, task);
  }
  if (!cloth) return false;
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const std::string name = portableFileName(fabric.name);
  const HandoverReport report = writeHandover(folder, name, *cloth, now);
  for (const std::string& line : report.lines) fmt::print("{}\n", line);
  fmt::print("{}: {} files, {}\n", (std::filesystem::path(folder) / (name + ".handover.json")).string(),
             report.files.size(), durationText(whole.lap()));
  return true;
}

}  // namespace

int run(const HandoverCommand& command) {
  Fabric fabric = fabricFromFile(command.input);
  fabric.render.samplesPerPixel = HandoverCommand::kSamples;
  fabric = withOptions(std::move(fabric), command.options);
  const Interrupt interrupt;
  if (!handOver(fabric, command.folder, command, interrupt)) return Interrupt::kExitStatus;
  if (!command.allColourways) return 0;
  for (const Colourway& colourway : fabric.colourways) {
    Fabric other = inColourway(fabric, colourway);
    other.name += " " + colourway.name;
    const std::string folder = (std::filesystem::path(command.folder) / portableFileName(colourway.name)).string();
    if (!handOver(other, folder, command, interrupt)) return Interrupt::kExitStatus;
  }
  return 0;
}

}  // namespace loomlight
