#include "app/cli/commands/render_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/commands/render_stats.h"
#include "app/cli/inputs.h"
#include "app/cli/usage_error.h"
#include "app/cli/version_text.h"
#include "app/export/picture.h"
#include "app/export/picture_part.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/validate.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/processor_kind.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// A picture to be traced, with what there is of it already.
struct Begun {
  std::shared_ptr<const Fabric> fabric;
  Film film;                 ///< of the whole picture
  SampleBox box;             ///< the samples that are wanted
  uint32_t samples = 0;      ///< in every pixel of its window
  SampleOrigin origin = {};  ///< of what there is
};

/// The file that the fabric is from.
const std::string& inputOf(const RenderCommand& command, const RenderOrder& job) {
  return job.input.empty() ? command.resume : job.input;
}

SampleBox boxOf(const PartChoice& choice, const RenderSettings& settings, const SampleBox& fallback) {
  const PixelRect window = choice.crop.value_or(fallback.window());
  expectWindowIn(settings.width, settings.height, window);
  const int first = choice.firstSample.value_or(fallback.low.z);
  const int samples = choice.samples.value_or(fallback.high.z - first);
  expectSamplesAmong(settings.samplesPerPixel, first, samples);
  return SampleBox::of(window, first, samples);
}

Begun goOn(const RenderCommand& command, PicturePart part, const std::shared_ptr<const Fabric>& fabric,
           const std::string& input) {
  const RenderSettings& settings = fabric->render;
  expectSameFabric(*fabric, input, part.info.fabric, command.resume);
  if (part.info.boxes.size() > 1)
    throw InputError(fmt::format(
        "{}: merged of parts that leave gaps; expected a picture or one part of it to go on with", command.resume));
  // A picture, or its end, grows with --spp; a part has its own end.
  SampleBox has = part.info.boxes.front();
  if (has.high.z == part.info.fabric.render.samplesPerPixel)
    has.high.z = std::max(settings.samplesPerPixel, has.low.z + 1);
  const SampleBox wanted = boxOf(command.part, settings, has);
  if (wanted.window() != has.window() || wanted.low.z != has.low.z)
    throw UsageError(fmt::format("--crop and --samples-from: expected those of {}, or neither: {}", command.resume,
                                 inWords(part.info.boxes.front())));
  const uint32_t samples = part.film.fewestSamples(part.film.window());
  if (static_cast<int>(samples) >= wanted.high.z - wanted.low.z)
    throw UsageError(fmt::format("--spp: expected more than the {} samples that {} already has, got {}", samples,
                                 command.resume, settings.samplesPerPixel));
  Film film(settings.width, settings.height);
  film.merge(part.film, part.window.x, part.window.y);
  return {fabric, std::move(film), wanted, samples, part.info.origin};
}

Begun begin(const RenderCommand& command, const RenderOrder& job) {
  std::optional<PicturePart> part;
  if (!command.resume.empty()) part = readPart(command.resume);
  const std::string& input = inputOf(command, job);
  Fabric fabric =
      withOptions(job.input.empty() ? part->info.fabric : fabricFrom({job.input, command.wif}), command.options, input);
  if (job.frame) fabric = inFrame(std::move(fabric), command.turn.value_or(Turntable{}), *job.frame);
  validate(fabric, input);
  const RenderSettings settings = fabric.render;
  auto shared = std::make_shared<const Fabric>(std::move(fabric));
  if (part) return goOn(command, std::move(*part), shared, input);
  const SampleBox whole = SampleBox::of({0, 0, settings.width, settings.height}, 0, settings.samplesPerPixel);
  const SampleBox box = boxOf(command.part, settings, whole);
  return {shared, Film(settings.width, settings.height), box};
}

/// Traces until every pixel has its samples. Returns false when stopped.
bool trace(const ReusableCloth& built, Begun& picture, Task task, ProgressStyle style, TraceCounts& counts) {
  const RenderSettings& settings = picture.fabric->render;
  const CameraRays camera(picture.fabric->camera, settings.width, settings.height);
  const auto firstSample = static_cast<uint32_t>(picture.box.low.z);
  const auto samples = static_cast<uint32_t>(picture.box.high.z - picture.box.low.z);
  const uint32_t first = picture.samples;
  Progress progress("rendering", style);
  // Batches of about half a second: often enough for the bar, seldom enough to cost nothing.
  constexpr double kBatch_s = 0.5;
  uint32_t batch = 1;
  for (uint32_t done = first; done < samples;) {
    batch = std::min(batch, samples - done);
    task.progress = [&progress, done, batch, first, samples](double fraction) {
      progress.update((done - first + fraction * batch) / (samples - first));
    };
    Stopwatch watch;
    const PassResult pass = renderUpTo(done + batch, *built.scene, *built.medium, camera, picture.film, task,
                                       {.window = picture.box.window(), .firstSample = firstSample});
    counts += pass.counts;
    // A stop that comes with the last path leaves nothing to go on with.
    if (!pass.complete) return picture.film.fewestSamples(picture.box.window()) >= samples;
    done += batch;
    progress.update(static_cast<double>(done - first) / (samples - first));
    const double seconds = watch.lap();
    if (seconds < 0.5 * kBatch_s) batch *= 2;
    if (seconds > 2 * kBatch_s) batch = std::max(1u, batch / 2);
  }
  return true;
}

/// What a reader of the picture must know where not all of the piece is laid.
std::string repeatText(const FibreSize& size) {
  if (size.bricks) return " at most, laid brick by brick as rays come to them";
  if (size.isWholePiece()) return "";
  return fmt::format(": a repeat of {} x {} crossings, {} x {} times side by side", size.ends, size.picks,
                     size.copies.x, size.copies.y);
}

/// Which fibres are laid, in a few words; empty where a volume is traced.
std::string fibresLaid(const Scene& scene, const FibreOptions& options) {
  if (scene.fabric->render.method != Method::fibres) return "";
  const FibreSize size = planFibres(*scene.cloth, options);
  if (size.bricks) return "bricks";
  return size.isWholePiece() ? "piece" : fmt::format("repeat {}x{}", size.ends, size.picks);
}

/// Null when stopped. Says beforehand what fibres will take.
std::shared_ptr<const Medium> buildMedium(const Scene& scene, const FibreOptions& options, const Task& task,
                                          ProgressStyle style, MediumCost& cost) {
  const RenderSettings& settings = scene.fabric->render;
  const bool fibres = settings.method == Method::fibres;
  if (!fibres && settings.estimator != Estimator::report) return makeMedium(scene, options, task, &cost);
  if (fibres) {
    const FibreSize size = planFibres(*scene.cloth, options);
    fmt::print(stderr, "loomlight: {:.3g} fibre segments will take about {:.2f} GB of memory{}\n", size.segments,
               size.bytes * 1e-9, repeatText(size));
  }
  Progress progress(fibres ? "laying fibres" : "baking visibility", style);
  return makeMedium(scene, options, progress.of(task), &cost);
}

/// Builds what differs from what was built before. False when stopped.
bool build(const std::shared_ptr<const Fabric>& fabric, const FibreOptions& options, const Task& task,
           ProgressStyle style, ReusableCloth& built) {
  std::shared_ptr<const Scene> scene;
  {
    Progress progress("voxelising", style);
    scene = makeScene(fabric, progress.of(task), built.scene.get());
  }
  if (!scene) return false;
  const bool sameCloth = built.scene && built.scene->cloth == scene->cloth;
  built.scene = scene;
  if (sameCloth && built.medium) return true;
  built.medium = nullptr;
  built.medium = buildMedium(*scene, options, task, style, built.cost);
  if (!built.medium) return false;
  for (const std::string& repair : scene->cloth->shell->repairs()) fmt::print(stderr, "loomlight: {}\n", repair);
  return true;
}

/// The kind of processor, where it shows: that of the tables of visibility, which may be from a folder that others
/// share, or this one's, which shows in a tree of all fibres. Empty elsewhere.
std::string kindOf(const MediumCost& medium) {
  if (medium.bvdfBytes > 0) return fmt::format("{:016x}", medium.bvdfChecksum);
  return medium.segments > 0 ? processorKind() : "";
}

/// Before it costs hours: samples that another kind of processor began have other last bits, so that a part would go
/// with no other part. A whole picture may be gone on with, which is said.
void expectKind(const std::string& kind, const Begun& picture, const std::string& resumed) {
  const std::string& begun = picture.origin.processor;
  if (begun.empty() || kind.empty() || begun == kind) return;
  const std::string others =
      fmt::format("{}: begun by {}, this one is {}", resumed,
                  begun == kSeveralKinds ? "several kinds of processor" : "another kind of processor, " + begun, kind);
  const RenderSettings& settings = picture.fabric->render;
  if (picture.box != SampleBox::of({0, 0, settings.width, settings.height}, 0, settings.samplesPerPixel))
    throw InputError(others + "; expected a part of this kind, as merge takes parts of one kind only");
  fmt::print(stderr, "loomlight: {}; its last bits will be of neither\n", others);
}

/// Of what there is and of what is added. Throws unless these are of the same files and fibres, whoever traced them; a
/// picture by a program that did not say is taken at its word.
SampleOrigin originWith(const SampleOrigin& before, const std::string& resumed, const Fabric& fabric,
                        const std::string& fibres, const std::string& file) {
  SampleOrigin origin = originOf(fabric, before.program, fibres);
  if (!before.program.empty()) expectSameOrigin(origin, file, before, resumed);
  if (origin.program.empty()) {
    origin.program = buildName();
  } else if (origin.program != buildName()) {
    origin.program += ", then " + buildName();
  }
  return origin;
}

void write(const std::string& output, const Begun& picture, const Tone& tone, bool keepSums,
           const SampleOrigin& origin) {
  const RenderSettings& settings = picture.fabric->render;
  const bool cropped = picture.box.window() != PixelRect{0, 0, settings.width, settings.height};
  if (lowerExtension(output) == ".exr" && keepSums) {
    writePart(output, picture.film, {*picture.fabric, origin, {picture.box}});
  } else {
    writePicture(output, cropped ? picture.film.cropped(picture.box.window()) : picture.film, *picture.fabric, tone);
  }
}

void tellWritten(const RenderOrder& job, uint32_t samples, bool complete, double seconds) {
  tellJson({{"stage", "written"},
            {"output", job.output},
            {"samples_per_pixel", samples},
            {"complete", complete},
            {"seconds", seconds}});
}

}  // namespace

void expectWindowIn(int width, int height, const PixelRect& window) {
  if (window.x + window.width > width || window.y + window.height > height)
    throw UsageError(fmt::format("--crop: expected pixels of the {} x {} of the picture, got {},{},{}x{}", width,
                                 height, window.x, window.y, window.width, window.height));
}

void expectSamplesAmong(int samplesPerPixel, int first, int samples) {
  const int most = samplesPerPixel - first;
  if (most < 1)
    throw UsageError(
        fmt::format("--samples-from: expected a number below the {} samples of --spp, got {}", samplesPerPixel, first));
  if (samples > most)
    throw UsageError(
        fmt::format("--samples: expected at most {}, which with those before makes the {} of --spp, got {}", most,
                    samplesPerPixel, samples));
}

int renderPicture(const RenderCommand& command, const RenderOrder& job, const Interrupt& interrupt,
                  ReusableCloth& built) {
  Stopwatch whole;
  checkPictureName(job.output);
  if (!job.stats.empty()) expectWritable(job.stats);
  Begun picture = begin(command, job);
  const RenderSettings& settings = picture.fabric->render;
  const Task task = interrupt.task(command.threads);
  const FibreOptions fibres(command.memoryLimit_bytes, command.fibreExtent);
  if (!build(picture.fabric, fibres, task, command.progress, built)) {
    fmt::print(stderr, "loomlight: stopped before the first sample; nothing was written\n");
    return Interrupt::kExitStatus;
  }
  SampleOrigin origin = originWith(picture.origin, command.resume, *picture.fabric, fibresLaid(*built.scene, fibres),
                                   inputOf(command, job));
  const std::string kind = kindOf(built.cost);  // may throw, which after the work would cost all of it
  expectKind(kind, picture, command.resume);
  const PixelRect window = picture.box.window();
  const int wanted = picture.box.high.z - picture.box.low.z;
  if (command.progress == ProgressStyle::plain)
    fmt::print(stderr, "loomlight: rendering {} x {}, {} samples per pixel, threads: {}\n", window.width, window.height,
               wanted, task.threads);
  TraceCounts counts;
  Stopwatch watch;
  const bool complete = trace(built, picture, task, command.progress, counts);
  const double render_s = watch.lap();
  origin.processor = withKind(picture.origin.processor, kind);

  // A stopped picture keeps its sums, so that hours of work can be gone on with.
  write(job.output, picture, command.tone, command.keepSums || !complete || !command.part.isWhole(), origin);
  const double total_s = whole.lap();
  const uint32_t samples = picture.film.fewestSamples(window);
  if (!job.stats.empty()) {
    writeStats(job.stats,
               {settings.method, window.width, window.height, static_cast<int>(samples), task.threads,
                built.scene->seconds, render_s, total_s, built.scene->cloth->volume->counts(), built.cost, counts});
  }
  fmt::print("{}: {} x {}, {} samples per pixel{}, {}\n", job.output, window.width, window.height, samples,
             complete ? "" : fmt::format(" of {}, stopped", wanted), durationText(total_s));
  if (command.progress == ProgressStyle::json) tellWritten(job, samples, complete, total_s);
  return complete ? 0 : Interrupt::kExitStatus;
}

}  // namespace loomlight
