#include "app/export/sheet/face_colours.h"

#include <algorithm>

#include "app/export/task_part.h"
#include "core/fabric/yarn/band_colour.h"
#include "render/colour/colour_difference.h"
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

int facesToTell(const Fabric& fabric) {
  constexpr int kMostFibres = 3;
  const int fibres = static_cast<int>(fabric.fibres.size());
  return 1 + (fibres > 1 ? std::min(fibres, kMostFibres) : 0);
}

std::optional<std::vector<FaceColour>> faceColours(const ColourPatch& patch, const Task& task) {
  const Fabric& fabric = *patch.scene->fabric;
  const Colouring colouring = colouringInDaylight(fabric);
  std::vector<FaceColour> colours;
  const int faces = facesToTell(fabric);
  for (int face = 0; face < faces; ++face) {
    const bool isAll = face == 0;
    const int material = face - 1;
    const auto paths =
        tracePathsForDyes(*patch.scene, *patch.medium, isAll ? wholePiece() : partOfFibre(material),
                          partOf(task, static_cast<double>(face) / faces, static_cast<double>(face + 1) / faces),
                          DyePaths::toJudge, kToldError);
    if (!paths) return std::nullopt;
    if (paths->lit() > 0)
      colours.push_back(
          colourOf(isAll ? "Cloth" : fabric.fibres[static_cast<size_t>(material)].name, *paths, colouring));
  }
  return colours;
}

}  // namespace loomlight
