#include "app/cli/commands/tile_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/export/file_name.h"
#include "app/export/tile.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"

namespace loomlight {
int run(const TileCommand& command) {
  Stopwatch whole;
  Fabric fabric = fabricFrom(command.input);
  fabric.render.samplesPerPixel = TileCommand::kSamples;
  fabric = withOptions(std::move(fabric), command.options, command.input.file);
  std::error_code failed;
  std::filesystem::create_directories(command.folder, failed);
  if (failed)
    throw InputError(fmt::format("{}: expected a folder that can be made, got: {}", command.folder, failed.message()));
  const std::string stem = (std::filesystem::path(command.folder) / portableFileName(fabric.name)).string();
  const Interrupt interrupt;
  Progress progress("rendering the tile");
  const Task task = progress.of(interrupt.task(command.threads));
  const auto tile = makeTile(fabric, stem, command.order, command.memoryLimit_bytes, task);
  if (!tile) return Interrupt::kExitStatus;
  fmt::print("{}.json and {} maps, {}\n", stem, tile->files.size() - 1, durationText(whole.lap()));
  return 0;
}

}  // namespace loomlight
