#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/metrics/flip.h"
#include "render/metrics/linear_picture.h"

namespace loomlight {

/// A picture and what it ought to look like.
struct PicturePair {
  LinearPicture picture, reference;
  std::string pictureName, referenceName;  ///< for messages
};

/// Reads both files. Throws InputError, also when their sizes differ.
PicturePair readPair(const std::string& picture, const std::string& reference);

/// How far a picture A is from its reference R. A ratio is NaN where it has no denominator, as when the reference is
/// all black.
struct Comparison {
  double relMse = 0;   ///< mean over pixels and channels of (A - R)^2 / (R^2 + eps), eps = 1e-2 <R>^2
  double rmse = 0;     ///< of radiance, over pixels and channels
  glm::dvec3 mean{0};  ///< of A
  glm::dvec3 referenceMean{0};
  double ciede2000 = 0;  ///< between the means, at the exposure of the viewing
  double flipMean = 0, flipLargest = 0;
  std::vector<float> flip;  ///< of every pixel, for a heat map

  size_t nonFinite = 0, referenceNonFinite = 0;  ///< pixels

  /// 100 (<A> - <R>) / <R> for each channel.
  glm::dvec3 meanDifference_percent() const;
};

/// Pixels where either picture is not finite are left out; FLIP sees them black in both. Throws InputError when the
/// sizes differ or no pixel is finite in both. `threads`: 0 for all.
Comparison compare(PicturePair pair, const Viewing& viewing, int threads = 0);

/// A measured number, and how far it may be off for noise: one standard deviation.
struct Estimate {
  double value = 0, standardError = 0;
};

/// <(A1 - R1)(A2 - R2)> / <R1 R2> over pixels and channels: the squared relative difference that is left when both are
/// free of noise, from two renderings of each. The noise of the one pair is independent of that of the other, so that
/// its products average to nothing, where squares would add up; the estimate may come out below zero. Pixels that are
/// not finite in all four are left out. Its standard error is that of a mean over pixels, taken as independent. Throws
/// InputError when sizes differ, when no pixel is left, or when two that should differ in their seed are the same.
Estimate noiseFreeBiasEstimate(const PicturePair& first, const PicturePair& second);
double noiseFreeBias(const PicturePair& first, const PicturePair& second);

}  // namespace loomlight
