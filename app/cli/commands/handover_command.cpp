#include "app/cli/commands/handover_command.h"

#include <fmt/format.h>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/export/handover/cloth_handover.h"
#include "core/base/stopwatch.h"

namespace loomlight {
namespace {

/// False when interrupted.
bool handOver(const HandoverPart& part, const HandoverCommand& command, const Interrupt& interrupt) {
  Stopwatch whole;
  std::optional<HandoverReport> report;
  {
    Progress progress("handing over");
    const Task task = progress.of(interrupt.task(command.threads));
    report = loomlight::handOver(part, command.order, command.memoryLimit_bytes, task);
  }
  if (!report) return false;
  for (const std::string& line : report->lines) fmt::print("{}\n", line);
  fmt::print("{}: {} files, {}\n", handoverSidecar(part.fabric, part.folder), report->files.size(),
             durationText(whole.lap()));
  return true;
}

}  // namespace

int run(const HandoverCommand& command) {
  Fabric fabric = fabricFrom(command.input);
  fabric.render.samplesPerPixel = HandoverCommand::kSamples;
  fabric = withOptions(std::move(fabric), command.options, command.input.file);
  const Interrupt interrupt;
  for (const HandoverPart& part : handoverParts(fabric, command.folder, command.allColourways))
    if (!handOver(part, command, interrupt)) return Interrupt::kExitStatus;
  return 0;
}

}  // namespace loomlight
