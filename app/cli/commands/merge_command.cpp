#include "app/cli/commands/merge_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/interrupt.h"
#include "app/export/merge_parts.h"
#include "app/export/picture.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"

namespace loomlight {
namespace {

/// The first few of what is missing, and how many there are.
std::string missingText(const std::vector<SampleBox>& missing) {
  constexpr size_t kMostTold = 8;
  std::string text;
  for (size_t i = 0; i < std::min(missing.size(), kMostTold); ++i) text += "\n  " + inWords(missing[i]);
  if (missing.size() > kMostTold) text += fmt::format("\n  and {} more such ranges", missing.size() - kMostTold);
  return text;
}

}  // namespace

int run(const MergeCommand& command) {
  Stopwatch watch;
  checkPictureName(command.output);
  const MergePlan plan = planMerge(command.parts);
  const RenderSettings& settings = plan.info.fabric.render;
  const std::string whole =
      fmt::format("{} x {}, {} samples per pixel", settings.width, settings.height, settings.samplesPerPixel);
  if (!plan.missing.empty() && !command.partial)
    throw InputError(
        fmt::format("{}: not written: of {} these are missing:{}\nwith --partial what there is is merged "
                    "into a larger part",
                    command.output, whole, missingText(plan.missing)));
  const Interrupt interrupt;
  std::optional<Film> film;
  {
    Progress progress("merging", command.progress);
    film = mergeParts(plan, command.parts, progress.of(interrupt.task(0)));
  }
  if (!film) return Interrupt::kExitStatus;
  if (command.keepSums || !plan.missing.empty())
    writePart(command.output, *film, plan.info);
  else
    writePicture(command.output, *film, plan.info.fabric, command.tone);
  fmt::print("{}: {} parts, {}{}, {}\n", command.output, command.parts.size(), whole,
             plan.missing.empty() ? "" : fmt::format(", of which these are missing:{}", missingText(plan.missing)),
             durationText(watch.lap()));
  return 0;
}

}  // namespace loomlight
