#include "app/export/face_colours.h"

#include <algorithm>

#include "core/fabric/yarn/band_colour.h"
#include "render/colour/colour_difference.h"
#include "render/transport/colour_patch.h"
#include "render/transport/dye_paths.h"

namespace loomlight {
namespace {

FaceColour colourOf(const std::string& name, const PathLengthTally& paths, const Colouring& colouring) {
  const Spectrum reflectance = paths.reflectance(colouring).mean;
  const auto under = [&](const char* lamp) {
    return labUnder(tristimulusWeights(illuminantNamed(lamp), Observer::degrees10), reflectance);
  };
  FaceColour colour{name, linearFromReflectance(reflectance), under("D65"), under("A"), 0};
  colour.inconstancy = ciede2000(colour.daylight, colour.bulb);
  return colour;
}

}  // namespace

std::optional<std::vector<FaceColour>> faceColours(const Fabric& fabric, const Task& task) {
  constexpr int kMostFibres = 3;
  const auto patch = makeColourPatch(fabric, task);
  if (!patch) return std::nullopt;
  const Colouring colouring = colouringInDaylight(fabric);
  std::vector<FaceColour> colours;
  const int fibres = fabric.fibres.size() > 1 ? std::min(static_cast<int>(fabric.fibres.size()), kMostFibres) : 0;
  for (int material = -1; material < fibres; ++material) {
    const bool isAll = material < 0;
    const auto paths = tracePathsForDyes(*patch->scene, *patch->medium, isAll ? wholePiece() : partOfFibre(material),
                                         task, DyePaths::toJudge, kToldError);
    if (!paths) return std::nullopt;
    if (paths->lit() > 0)
      colours.push_back(
          colourOf(isAll ? "Cloth" : fabric.fibres[static_cast<size_t>(material)].name, *paths, colouring));
  }
  return colours;
}

}  // namespace loomlight
