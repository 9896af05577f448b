#include "render/transport/reached_colours.h"

#include <algorithm>
#include <utility>

#include "render/transport/colour_patch.h"

namespace loomlight {
namespace {

/// Fewer paths that meet a yarn tell nothing of its colour.
constexpr size_t kFewestPaths = 64;

Fabric plainClothOf(Fabric fabric, int yarn) {
  fabric.weave = Weave(std::vector<Weave::Row>{{1, 0}, {0, 1}});
  fabric.draft.reset();
  fabric.warpSequence = fabric.weftSequence = {yarn};
  return fabric;
}

}  // namespace

std::optional<std::vector<PathLengthTally>> tracePathsToYarns(const Fabric& fabric, size_t count, const Task& task,
                                                              std::shared_ptr<const Scene>* shared) {
  const auto patch = makeColourPatch(fabric, task, shared);
  auto paths = patch ? tallyYarns(*patch->scene, *patch->medium, count, task) : std::nullopt;
  if (!paths) return std::nullopt;
  std::shared_ptr<const Scene> plain = patch->scene;  // the next is to find the cloth itself, not these
  for (size_t i = 0; i < paths->size(); ++i) {
    if ((*paths)[i].count >= kFewestPaths) continue;
    const auto alone = makeColourPatch(plainClothOf(fabric, static_cast<int>(i)), task, &plain);
    auto seen = alone ? tallyPathLengths(*alone->scene, *alone->medium, wholePiece(), count, task) : std::nullopt;
    if (!seen) return std::nullopt;
    (*paths)[i] = std::move(*seen);
  }
  return paths;
}

std::vector<Rgb> reachedColours(const std::vector<PathLengthTally>& paths, const Colouring& colouring) {
  std::vector<Rgb> colours;
  colours.reserve(paths.size());
  for (const PathLengthTally& yarn : paths) colours.push_back(yarn.colour(colouring));
  return colours;
}

std::vector<Rgb> coloursForNames(const std::vector<PathLengthTally>& paths, std::vector<Rgb> reached) {
  for (size_t i = 0; i < reached.size(); ++i) {
    const PathLengthTally& yarn = paths[i];
    if (yarn.lit() == 0) continue;
    const float white = static_cast<float>(yarn.lit()) / static_cast<float>(yarn.count);
    reached[i] = glm::min(reached[i] / white, Rgb(1.0f));
  }
  return reached;
}

std::optional<std::vector<Rgb>> reachedColours(const Fabric& fabric, const Task& task, size_t paths) {
  const auto traced = tracePathsToYarns(fabric, paths, task);
  return traced ? std::optional(reachedColours(*traced, colouringOf(fabric))) : std::nullopt;
}

std::optional<std::vector<Rgb>> soonReachedColours(Fabric fabric, const Task& task) {
  constexpr int kCoarse = 4;
  fabric.render.resolution = std::min(fabric.render.resolution, kCoarse);
  return reachedColours(fabric, task, kChipPaths / 4);
}

}  // namespace loomlight
