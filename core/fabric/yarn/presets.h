#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Where the numbers of a fibre are from, and how well they are known: measured, handbook, or guess.
struct FibreSources {
  const char* fineness;  ///< and with it the radius
  const char* density;
  const char* refractiveIndex;
  const char* roughness;
  const char* scaleTilt;
  const char* colour;
};

/// A fibre to start from, undyed.
struct FibrePreset {
  Fibre fibre;
  double fineness_dtex = 0;  ///< what the radius was computed from
  FibreSources sources;
};

/// A yarn to start from. Its `yarn.fibre` is 0: put `fibre` into the fabric and point to it.
struct YarnPreset {
  Yarn yarn;
  Fibre fibre;
  std::string provenance;
};

/// Cotton, wool, silk, linen, viscose, polyester, nylon, acrylic, mohair, alpaca, cashmere. Indices are (parallel + 2
/// perpendicular) / 3, which is what a ray sees on average of a birefringent fibre; absorptions are those of undyed
/// stock.
std::vector<FibrePreset> fibrePresets();
std::vector<YarnPreset> yarnPresets();

/// A single of the usual count, spun or drawn as the fibre of that name mostly is: with the twist multiplier, packing,
/// straying, hairiness H and evenness (as a multiple of the least there can be) of the first yarn preset of that fibre.
/// Hair and acrylic, of which there is none, are spun like worsted wool.
Yarn usuallySpun(const Fibre& fibre);

/// What is woven where a draft or a bitmap says how, and nothing of yarns: undyed cotton of the first of these.
Fabric plainCotton();

/// The same fibre with the absorption that shows this colour (linear reflectance of a thick mass of it, colour.h).
Fibre dyed(Fibre fibre, const Rgb& colour);
/// The fibre in the colour of another one: with its very absorption where that was measured or is a recipe, else so
/// that a thick mass of it looks alike.
Fibre dyedLike(Fibre fibre, const Fibre& other);

/// Turns per metre for a twist multiplier (turns per inch over the square root of the cotton count, as spinners give
/// it: warp yarns 3.8 to 4.5): 957 TM / sqrt(tex).
double twist_per_m(double twistMultiplier, double tex);
double twistMultiplier(double twist_per_m, double tex);

}  // namespace loomlight
