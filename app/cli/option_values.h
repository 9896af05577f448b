#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/progress.h"
#include "app/cli/view.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/yarn/yarn_need.h"
#include "render/film/pixel_rect.h"
#include "render/scene/fibre_extent.h"
#include "render/transport/half_dome.h"

namespace loomlight {

// The values of options, from the words of the command line. Every function throws UsageError naming `option`, what it
// expected and what it got.

/// A whole number from `lowest` to `highest`.
int64_t parseWhole(const std::string& option, const std::string& text, int64_t lowest, int64_t highest);
/// Every 64-bit number.
uint64_t parseSeed(const std::string& option, const std::string& text);
/// A number, infinities excluded, from `lowest` to `highest`.
double parseNumber(const std::string& option, const std::string& text, double lowest, double highest);

struct PictureSize {
  int width = 0, height = 0;
};
/// 640x480
PictureSize parseSize(const std::string& option, const std::string& text);

/// A pixel of a picture, from its top left, counted from 0.
struct PixelChoice {
  int x = 0, y = 0;
};
/// 320,240
PixelChoice parsePixel(const std::string& option, const std::string& text);

/// 100,80,320x240: from the top left, counted from 0.
PixelRect parseCrop(const std::string& option, const std::string& text);

/// One of 1, 2, 4, 8, 16.
int parseResolution(const std::string& option, const std::string& text);
/// Several of 1, 2, 4, 8, 16, with commas between them.
std::vector<int> parseResolutions(const std::string& option, const std::string& text);

Method parseMethod(const std::string& option, const std::string& text);
FibreExtent parseFibreExtent(const std::string& option, const std::string& text);
Estimator parseEstimator(const std::string& option, const std::string& text);
/// 64x16: azimuths and inclinations, each from 1 to 256.
HalfDomeGrid parseHalfDome(const std::string& option, const std::string& text);

/// 10x150: length in metres and width in cm, in the ranges of core/fabric/yarn/yarn_need.h.
PieceSize parsePieceSize(const std::string& option, const std::string& text);

/// The spectrum that white light is to have; the temperature is a black body's.
struct IlluminantChoice {
  StandardIlluminant illuminant = StandardIlluminant::d65;
  std::optional<double> temperature_K;
  std::string file;
};
/// What lampFromName() knows, or the name of a file, which has a dot.
IlluminantChoice parseIlluminant(const std::string& option, const std::string& text);
/// 2 or 10, degrees.
Observer parseObserver(const std::string& option, const std::string& text);

EventLaw parseEventLaw(const std::string& option, const std::string& text);
ProgressStyle parseProgress(const std::string& option, const std::string& text);
/// plain or filmic: whether what is bright is bent to fit.
bool parseIsFilmic(const std::string& option, const std::string& text);
WifSizeChoice parseWifSizes(const std::string& option, const std::string& text);
WifThreadChoice parseWifThreads(const std::string& option, const std::string& text);

/// front, top, close, macro, side, or AZ,EL[,DISTANCE] in degrees and mm.
ViewChoice parseView(const std::string& option, const std::string& text);

/// flat, cylinder, sphere, folds, cushion, skirt, or the name of a mesh. Kind and file; the rest is the drape's own.
struct DrapeChoice {
  DrapeKind kind = DrapeKind::flat;
  std::string file;
};
DrapeChoice parseDrape(const std::string& option, const std::string& text);

/// ibl[:FILE], sky[:AZ,EL], directional[:AZ,EL], overcast, window, booth, dome, point, back or furnace.
struct LightChoice {
  LightKind kind = LightKind::sky;
  std::string file;
  struct Angles {
    double azimuth_deg = 0, elevation_deg = 0;
  };
  std::optional<Angles> angles;
};
LightChoice parseLight(const std::string& option, const std::string& text);

}  // namespace loomlight
