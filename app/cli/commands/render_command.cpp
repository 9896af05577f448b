#include "app/cli/commands/render_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/commands/render_stats.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/usage_error.h"
#include "app/export/picture.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/validate.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/scene.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

// Samples of two pictures may only be added where both ask for the same picture, but for the number of samples.
void expectSamePicture(const Fabric& wanted, Fabric begun, const std::string& file) {
  begun.render.samplesPerPixel = wanted.render.samplesPerPixel;
  const auto keptIn = [&](const Fabric& fabric) {
    return nlohmann::json::parse(fabricToJson(localNames(fabric, file)));
  };
  const auto differences = nlohmann::json::diff(keptIn(begun), keptIn(wanted));
  if (differences.empty()) return;
  throw InputError(
      fmt::format("{}: expected a picture of the same fabric with the same settings, but they differ at {}", file,
                  differences[0].at("path").get<std::string>()));
}

struct Job {
  std::shared_ptr<const Fabric> fabric;
  Film film;
  uint32_t samplesBegun = 0;  ///< in every pixel
};

Job prepare(const RenderCommand& command) {
  std::optional<UnfinishedPicture> begun;
  if (!command.resume.empty()) begun = readUnfinishedPicture(command.resume);
  Fabric fabric =
      withOptions(command.input.empty() ? begun->fabric : fabricFromFile(command.input, command.wif), command.options);
  validate(fabric, command.input.empty() ? command.resume : command.input);
  const RenderSettings settings = fabric.render;
  auto shared = std::make_shared<const Fabric>(std::move(fabric));
  if (!begun) return {shared, Film(settings.width, settings.height), 0};

  expectSamePicture(*shared, begun->fabric, command.resume);
  const uint32_t samples = fewestSamples(begun->film);
  if (samples >= static_cast<uint32_t>(settings.samplesPerPixel))
    throw UsageError(fmt::format("--spp: expected more than the {} samples that {} already has, got {}", samples,
                                 command.resume, settings.samplesPerPixel));
  return {shared, std::move(begun->film), samples};
}

/// Traces until every pixel has its samples. Returns false when stopped.
bool trace(const Scene& scene, const Medium& medium, Job& job, Task task, TraceCounts& counts) {
  const RenderSettings& settings = job.fabric->render;
  const CameraRays camera(job.fabric->camera, settings.width, settings.height);
  const auto samples = static_cast<uint32_t>(settings.samplesPerPixel);
  const uint32_t first = job.samplesBegun;
  Progress progress("rendering");
  // Batches of about half a second: often enough for the bar, seldom enough to cost nothing.
  constexpr double kBatch_s = 0.5;
  uint32_t batch = 1;
  for (uint32_t done = first; done < samples;) {
    batch = std::min(batch, samples - done);
    task.progress = [&progress, done, batch, first, samples](double fraction) {
      progress.update((done - first + fraction * batch) / (samples - first));
    };
    Stopwatch watch;
    const PassResult pass = renderUpTo(done + batch, scene, medium, camera, job.film, task);
    counts += pass.counts;
    if (!pass.complete) return false;
    done += batch;
    progress.update(static_cast<double>(done - first) / (samples - first));
    const double seconds = watch.lap();
    if (seconds < 0.5 * kBatch_s) batch *= 2;
    if (seconds > 2 * kBatch_s) batch = std::max(1u, batch / 2);
  }
  return true;
}

/// Null when stopped.
std::shared_ptr<const Scene> buildScene(const std::shared_ptr<const Fabric>& fabric, Task task) {
  Progress progress("voxelising");
  task.progress = [&progress](double fraction) { progress.update(fraction); };
  return makeScene(fabric, task);
}

/// What a reader of the picture must know where not all of the piece is laid.
std::string repeatText(const FibreSize& size) {
  if (size.bricks) return " at most, laid brick by brick as rays come to them";
  if (size.isWholePiece()) return "";
  return fmt::format(": a repeat of {} x {} crossings, {} x {} times side by side", size.ends, size.picks,
                     size.copies.x, size.copies.y);
}

/// Null when stopped. Says beforehand what fibres will take.
std::unique_ptr<const Medium> buildMedium(const Scene& scene, const FibreOptions& options, Task task,
                                          MediumCost& cost) {
  const RenderSettings& settings = scene.fabric->render;
  const bool fibres = settings.method == Method::fibres;
  if (!fibres && settings.estimator != Estimator::report) return makeMedium(scene, options, task, &cost);
  if (fibres) {
    const FibreSize size = planFibres(*scene.cloth, options);
    fmt::print(stderr, "loomlight: {:.3g} fibre segments will take about {:.2f} GB of memory{}\n", size.segments,
               size.bytes * 1e-9, repeatText(size));
  }
  Progress progress(fibres ? "laying fibres" : "baking visibility");
  task.progress = [&progress](double fraction) { progress.update(fraction); };
  return makeMedium(scene, options, task, &cost);
}

}  // namespace

int run(const RenderCommand& command) {
  Stopwatch whole;
  checkPictureName(command.output);
  if (!command.stats.empty()) expectWritable(command.stats);
  const Interrupt interrupt;
  Job job = prepare(command);
  const RenderSettings& settings = job.fabric->render;
  Task task = interrupt.task(command.threads);

  const auto scene = buildScene(job.fabric, task);
  MediumCost mediumCost;
  const auto medium =
      scene ? buildMedium(*scene, {command.memoryLimit_bytes, command.fibreExtent}, task, mediumCost) : nullptr;
  if (!medium) {
    fmt::print(stderr, "loomlight: stopped before the first sample; nothing was written\n");
    return Interrupt::kExitStatus;
  }
  for (const std::string& repair : scene->cloth->shell->repairs()) fmt::print(stderr, "loomlight: {}\n", repair);
  fmt::print(stderr, "loomlight: rendering {} x {}, {} samples per pixel, threads: {}\n", settings.width,
             settings.height, settings.samplesPerPixel, task.threads);
  TraceCounts counts;
  Stopwatch watch;
  const bool complete = trace(*scene, *medium, job, task, counts);
  const double render_s = watch.lap();

  // A stopped picture keeps its sums, so that hours of work can be gone on with.
  writePicture(command.output, job.film, *job.fabric, command.tone, command.keepSums || !complete);
  const double total_s = whole.lap();
  const auto samples = static_cast<int>(fewestSamples(job.film));
  if (!command.stats.empty()) {
    writeStats(command.stats, {settings.method, settings.width, settings.height, samples, task.threads, scene->seconds,
                               render_s, total_s, scene->cloth->volume->counts(), mediumCost, counts});
  }
  fmt::print("{}: {} x {}, {} samples per pixel{}, {}\n", command.output, settings.width, settings.height, samples,
             complete ? "" : fmt::format(" of {}, stopped", settings.samplesPerPixel), durationText(total_s));
  return complete ? 0 : Interrupt::kExitStatus;
}

}  // namespace loomlight
