#include "render/transport/standard_match.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/fabric/yarn/band_colour.h"
#include "render/transport/dye_paths.h"

namespace loomlight {
namespace {

StandardMatch matchOf(const ClothStandard& standard, const Spectrum& reflectance) {
  const auto weights = [](const char* lamp) { return tristimulusWeights(illuminantNamed(lamp), Observer::degrees10); };
  const TristimulusWeights daylight = weights("D65");
  return {standard.partName,
          standard.name,
          linearFromReflectance(standard.reflectance),
          linearFromReflectance(reflectance),
          judged(standard.reflectance, reflectance, daylight, daylight),
          judged(standard.reflectance, reflectance, weights("A"), daylight)};
}

}  // namespace

std::optional<std::vector<StandardMatch>> standardMatches(const ColourPatch& patch,
                                                          const std::vector<ClothStandard>& standards,
                                                          const Task& task) {
  std::vector<StandardMatch> matches;
  const Colouring colouring = colouringInDaylight(*patch.scene->fabric);
  for (const ClothStandard& standard : standards) {
    const auto paths =
        tracePathsForDyes(*patch.scene, *patch.medium, standard.part, task, DyePaths::toJudge, kToldError);
    if (!paths) return std::nullopt;
    if (paths->lit() == 0)
      throw InputError(
          fmt::format("{}: expected a standard of a part that lies on the face, where it shows its colour, "
                      "got one of {}",
                      standard.name, standard.partName));
    matches.push_back(matchOf(standard, paths->reflectance(colouring).mean));
  }
  return matches;
}

}  // namespace loomlight
