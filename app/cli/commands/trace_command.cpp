#include "app/cli/commands/trace_command.h"

#include <fmt/format.h>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/path_transcript.h"
#include "app/cli/usage_error.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/validate.h"
#include "render/transport/path_tracer.h"
#include "render/transport/yarn_names.h"

namespace loomlight {

int run(const TraceCommand& command) {
  auto fabric =
      std::make_shared<const Fabric>(withOptions(fabricFrom(command.input), command.options, command.input.file));
  validate(*fabric, command.input.file);
  const RenderSettings& settings = fabric->render;
  const PixelChoice pixel = command.pixel;
  if (pixel.x >= settings.width || pixel.y >= settings.height)
    throw UsageError(fmt::format("--pixel: expected X from 0 to {} and Y from 0 to {}, got {},{}", settings.width - 1,
                                 settings.height - 1, pixel.x, pixel.y));
  const Interrupt interrupt;
  const Task task = interrupt.task(command.threads);
  const auto scene = makeScene(fabric, task);
  const auto medium = scene ? makeMedium(*scene, {command.memoryLimit_bytes, command.fibreExtent}, task) : nullptr;
  auto names = medium ? yarnNames(*fabric, task) : std::nullopt;
  if (!names) return Interrupt::kExitStatus;

  PathTranscript transcript(*scene, std::move(*names));
  TraceCounts counts;
  tracePath(*scene, *medium, CameraRays(fabric->camera, settings.width, settings.height), pixel.x, pixel.y,
            command.sample, counts, &transcript);
  fmt::print("pixel {},{} of {} x {}, sample {}, seed {}: {}\n{}cost: {} rays, {} voxels\n", pixel.x, pixel.y,
             settings.width, settings.height, command.sample, settings.seed,
             settings.method == Method::fibres ? choiceName(settings.method) : choiceName(settings.estimator),
             transcript.text(), counts.rays, counts.steps);
  return 0;
}

}  // namespace loomlight
