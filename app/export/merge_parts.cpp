#include "app/export/merge_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace loomlight {
namespace {

/// Throws unless every pixel has the samples that the boxes promise.
void expectFinished(const PicturePart& part, const std::string& file) {
  const PixelRect& window = part.window;
  std::vector<uint32_t> promised(static_cast<size_t>(window.width) * static_cast<size_t>(window.height));
  for (const SampleBox& box : part.info.boxes)
    for (int y = box.low.y; y < box.high.y; ++y)
      for (int x = box.low.x; x < box.high.x; ++x)
        promised[static_cast<size_t>(y - window.y) * static_cast<size_t>(window.width) +
                 static_cast<size_t>(x - window.x)] += static_cast<uint32_t>(box.high.z - box.low.z);
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x) {
      const uint32_t wanted =
          promised[static_cast<size_t>(y) * static_cast<size_t>(window.width) + static_cast<size_t>(x)];
      if (const uint32_t samples = part.film.samples(x, y); samples < wanted)
        throw InputError(
            fmt::format("{}: not finished: pixel {}, {} has {} of {} samples; render --resume goes on with it", file,
                        window.x + x, window.y + y, samples, wanted));
      else if (samples > wanted)
        throw InputError(fmt::format("{}: pixel {}, {} has {} samples, expected {} as its metadata says", file,
                                     window.x + x, window.y + y, samples, wanted));
    }
}

}  // namespace

MergePlan planMerge(std::span<const std::string> files) {
  MergePlan plan;
  std::vector<size_t> fileOf;  // the place in the list of the file that each box is of
  size_t showsProcessor = 0;   // the place of the first file that does, as far as there is one
  for (size_t i = 0; i < files.size(); ++i) {
    PartInfo info = readPartInfo(files[i]);
    if (info.origin.program.empty())
      throw InputError(fmt::format("{}: expected a part that says which program made it; found none", files[i]));
    if (i == 0) {
      plan.info.fabric = info.fabric;
      plan.info.origin = info.origin;
    }
    expectSameFabric(plan.info.fabric, files[0], info.fabric, files[i]);
    expectSameOrigin(plan.info.origin, files[0], info.origin, files[i]);
    if (plan.info.origin.processor.empty()) {
      plan.info.origin.processor = info.origin.processor;
      showsProcessor = i;
    }
    expectSameProcessor(plan.info.origin, files[showsProcessor], info.origin, files[i]);
    int& samples = plan.info.fabric.render.samplesPerPixel;
    samples = std::max(samples, info.fabric.render.samplesPerPixel);
    plan.info.boxes.insert(plan.info.boxes.end(), info.boxes.begin(), info.boxes.end());
    fileOf.resize(plan.info.boxes.size(), i);
    if (plan.info.boxes.size() > kMaxSampleBoxes)
      throw InputError(fmt::format("{}: with it there are more than {} parts", files[i], kMaxSampleBoxes));
  }
  if (const auto pair = findOverlap(plan.info.boxes))
    throw InputError(fmt::format("{}: {} overlap those of {}: {}", files[fileOf[pair->second]],
                                 inWords(plan.info.boxes[pair->second]), files[fileOf[pair->first]],
                                 inWords(plan.info.boxes[pair->first])));
  const RenderSettings& settings = plan.info.fabric.render;
  plan.missing =
      missingFrom(SampleBox::of({0, 0, settings.width, settings.height}, 0, settings.samplesPerPixel), plan.info.boxes);
  plan.info.boxes = joined(std::move(plan.info.boxes));
  return plan;
}

std::optional<Film> mergeParts(const MergePlan& plan, std::span<const std::string> files, const Task& task) {
  const RenderSettings& settings = plan.info.fabric.render;
  Film film(settings.width, settings.height);
  for (size_t i = 0; i < files.size(); ++i) {
    if (task.stopped()) return std::nullopt;
    const PicturePart part = readPart(files[i]);
    if (part.info.fabric.render.width != settings.width || part.info.fabric.render.height != settings.height)
      throw InputError(fmt::format("{}: has become another picture in the meantime", files[i]));
    expectFinished(part, files[i]);
    film.merge(part.film, part.window.x, part.window.y);
    task.report(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  return film;
}

}  // namespace loomlight
