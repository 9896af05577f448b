#pragma once

#include <span>
#include <vector>

#include "app/export/handover/principled.h"

namespace loomlight {

/// Parallel light that a patch of cloth sends on. Directions are unit, point away from the cloth, and are in the frame
/// of the side's picture: x right, y up, z towards the eye. `in`.z is below 0 for light from behind.
struct Observation {
  glm::vec3 in{0, 0, 1}, out{0, 0, 1};
  Rgb factor{0};       ///< radiance over that of white paper in this light from its own side
  float weight = 0;    ///< share of the directions `out`, by projected solid angle; those of one light sum to 1
  float variance = 0;  ///< that noise left in the factor, mean of the channels
};

/// A pixel of the maps that stands for many.
struct SurfaceSample {
  PrincipledPoint point;
  float opacity = 1;
};

struct FitError {
  double mean = 0;   ///< of the factors that were measured, over channels, lights and, by weight, directions
  double rms = 0;    ///< of the factors of the fit minus those, likewise; what noise adds to it is taken away
  double noise = 0;  ///< RMS of the noise in the factors that were measured
};

/// The principled surface that stands for one side of a cloth, and how well it does.
struct SurfaceFit {
  Principled surface;
  /// What the slopes of the normals are multiplied by: geometry is steeper than what a surface without shadows can
  /// show.
  float normalStrength = 1;
  /// What the maps of reflected and transmitted light are multiplied by to be those of the diffuse parts.
  Rgb reflectedWeight{1}, transmittedWeight{1};
  FitError reflected, transmitted;
  FitError matt;      ///< of reflected light, were the surface matt and as bright in even light: what a fit is to beat
  FitError fromAfar;  ///< of reflected light, where all pixels are seen as one: their mean normal and mean colour
  /// What the fit shows straight from above in even light over what was measured there, pixel by pixel and as one. The
  /// mean of the two is 1, or above where gloss alone is brighter than a dark cloth.
  Rgb evenLight{1}, evenLightFromAfar{1};
};

/// Where the fit begins: the sum of squares has more than one valley.
struct FitStart {
  double roughness = 0.6, anisotropy = 0.3;
  double sheen = 0.02;
};
/// Wide and narrow gloss, the same every way and drawn out, with little sheen and with much.
inline constexpr FitStart kFitStarts[] = {
    {0.6, 0.3, 0.02}, {0.35, 0.3, 0.02}, {0.9, 0.3, 0.2}, {0.35, 0.8, 0.02}, {0.6, 0.8, 0.2}};

/// Fits a surface to what was measured, the best of those that it comes to from the starts. Seen straight from above in
/// even light the surface is as bright as the colours of `samples`, which were measured in such light, in each channel;
/// among those that are, it is the one that fits by least squares of logarithms over directions (least_squares.h). What
/// the fit predicts of a patch is the mean over `samples`, each as a surface of its own, and, with as much weight, all
/// of them seen as one: garments are looked at from so far that programs average the maps. `samples`, `reflected`,
/// `transmitted`, `starts`: at least one of each.
SurfaceFit fitSurface(std::span<const SurfaceSample> samples, std::span<const Observation> reflected,
                      std::span<const Observation> transmitted, int threads = 0,
                      std::span<const FitStart> starts = kFitStarts);

/// What a fitted patch sends on, as observations of it would be; their in, out alone are read. The normals of `samples`
/// are taken as they are.
std::vector<Rgb> predictedFactors(const SurfaceFit& fit, const SheenAlbedo& sheen,
                                  std::span<const SurfaceSample> samples, std::span<const Observation> seen);

/// What `is` is to be multiplied by in each channel to be `wanted`; 1 where it is black.
Rgb quotient(const Rgb& wanted, const Rgb& is);

}  // namespace loomlight
