#include "app/cli/commands/sheet_command.h"

#include <fmt/format.h>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "core/base/stopwatch.h"

namespace loomlight {

int run(const SheetCommand& command) {
  Stopwatch whole;
  const Fabric fabric = fabricFromFile(command.input);
  const Interrupt interrupt;
  Progress progress("rendering the cloth");
  Task task = interrupt.task(command.threads);
  task.progress = [&progress](double fraction) { progress.update(fraction); };
  const auto write = command.colourways ? writeColourwaySheet : writeClothSheet;
  if (!write(command.output, fabric, command.options, task)) return Interrupt::kExitStatus;
  fmt::print("{}, {}\n", command.output, durationText(whole.lap()));
  return 0;
}

}  // namespace loomlight
