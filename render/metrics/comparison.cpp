#include "render/metrics/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "render/colour/colour_space.h"

// How it works. relMSE divides each squared difference by the reference's square plus a hundredth of its mean's, so
// that dark pixels do not rule. The bias beneath the noise comes of two independent pictures of each kind: noise of
// different seeds has mean 0 in the products (A - R)(A' - R') and RR', and their sums' ratio is the squared relative
// bias.

namespace loomlight {
namespace {

void expectSameSize(const LinearPicture& one, const std::string& name, const LinearPicture& other,
                    const std::string& otherName) {
  if (one.width == other.width && one.height == other.height) return;
  throw InputError(fmt::format("{}: expected {} x {} pixels as in {}, got {} x {}", otherName, one.width, one.height,
                               name, other.width, other.height));
}

void expectOtherSeed(const LinearPicture& one, const std::string& name, const LinearPicture& other,
                     const std::string& otherName) {
  if (one.pixels != other.pixels) return;
  throw InputError(
      fmt::format("{}: the very pixels of {}; expected the same rendered with another seed", otherName, name));
}

size_t countNonFinite(const LinearPicture& picture) {
  return static_cast<size_t>(
      std::count_if(picture.pixels.begin(), picture.pixels.end(), [](const Rgb& c) { return !isFinite(c); }));
}

/// Makes pixels black in both pictures that are not finite in both; returns how many are finite.
size_t blackenNonFinite(LinearPicture& one, LinearPicture& other) {
  size_t finite = 0;
  for (size_t i = 0; i < one.pixels.size(); ++i) {
    if (isFinite(one.pixels[i]) && isFinite(other.pixels[i]))
      ++finite;
    else
      one.pixels[i] = other.pixels[i] = Rgb(0);
  }
  return finite;
}

double sum(const glm::dvec3& v) {
  return v.x + v.y + v.z;
}

double ratio(double amount, double of) {
  return of != 0 ? amount / of : std::numeric_limits<double>::quiet_NaN();
}

/// Of linear light; `finite` pixels count, the others are black.
void compareLight(const LinearPicture& picture, const LinearPicture& reference, size_t finite, Comparison& result) {
  glm::dvec3 total(0), referenceTotal(0);
  double squares = 0;
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    const glm::dvec3 a(picture.pixels[i]), r(reference.pixels[i]);
    total += a;
    referenceTotal += r;
    squares += glm::dot(a - r, a - r);
  }
  const auto count = static_cast<double>(finite);
  result.mean = total / count;
  result.referenceMean = referenceTotal / count;
  result.rmse = std::sqrt(squares / (3 * count));

  const double mean = sum(result.referenceMean) / 3, epsilon = 1e-2 * mean * mean;
  double relative = 0;
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    const glm::dvec3 a(picture.pixels[i]), r(reference.pixels[i]);
    relative += sum((a - r) * (a - r) / (r * r + epsilon));
  }
  result.relMse = mean != 0 ? relative / (3 * count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

PicturePair readPair(const std::string& picture, const std::string& reference) {
  PicturePair pair{readLinearPicture(picture), readLinearPicture(reference), picture, reference};
  expectSameSize(pair.reference, reference, pair.picture, picture);
  return pair;
}

glm::dvec3 Comparison::meanDifference_percent() const {
  glm::dvec3 percent;
  for (int i = 0; i < 3; ++i) percent[i] = 100 * ratio(mean[i] - referenceMean[i], referenceMean[i]);
  return percent;
}

Comparison compare(PicturePair pair, const Viewing& viewing, int threads) {
  expectSameSize(pair.reference, pair.referenceName, pair.picture, pair.pictureName);
  Comparison result;
  result.nonFinite = countNonFinite(pair.picture);
  result.referenceNonFinite = countNonFinite(pair.reference);
  const size_t finite = blackenNonFinite(pair.picture, pair.reference);
  if (finite == 0)
    throw InputError(
        fmt::format("{} and {}: expected a pixel that is finite in both", pair.pictureName, pair.referenceName));
  compareLight(pair.picture, pair.reference, finite, result);

  const double exposure = std::exp2(viewing.exposure_stops);
  result.ciede2000 = ciede2000(labFromLinear(result.mean * exposure), labFromLinear(result.referenceMean * exposure));

  result.flip = flip(pair.picture, pair.reference, viewing, threads);
  double total = 0;
  for (const float error : result.flip) total += error;
  result.flipMean = total / static_cast<double>(result.flip.size());
  result.flipLargest = *std::max_element(result.flip.begin(), result.flip.end());
  return result;
}

Estimate noiseFreeBiasEstimate(const PicturePair& first, const PicturePair& second) {
  expectSameSize(first.reference, first.referenceName, first.picture, first.pictureName);
  expectSameSize(first.reference, first.referenceName, second.picture, second.pictureName);
  expectSameSize(first.reference, first.referenceName, second.reference, second.referenceName);
  expectOtherSeed(first.picture, first.pictureName, second.picture, second.pictureName);
  expectOtherSeed(first.reference, first.referenceName, second.reference, second.referenceName);
  double differences = 0, squares = 0, references = 0;
  size_t finite = 0;
  for (size_t i = 0; i < first.picture.pixels.size(); ++i) {
    const Rgb &a1 = first.picture.pixels[i], &r1 = first.reference.pixels[i];
    const Rgb &a2 = second.picture.pixels[i], &r2 = second.reference.pixels[i];
    if (!isFinite(a1) || !isFinite(r1) || !isFinite(a2) || !isFinite(r2)) continue;
    ++finite;
    const double difference = glm::dot(glm::dvec3(a1) - glm::dvec3(r1), glm::dvec3(a2) - glm::dvec3(r2));
    differences += difference;
    squares += difference * difference;
    references += glm::dot(glm::dvec3(r1), glm::dvec3(r2));
  }
  if (finite == 0)
    throw InputError(fmt::format("{}, {}, {} and {}: expected a pixel that is finite in all", first.pictureName,
                                 first.referenceName, second.pictureName, second.referenceName));
  const double spread = std::max(0.0, squares - differences * differences / static_cast<double>(finite));
  return {ratio(differences, references), ratio(std::sqrt(spread), references)};
}

double noiseFreeBias(const PicturePair& first, const PicturePair& second) {
  return noiseFreeBiasEstimate(first, second).value;
}

}  // namespace loomlight
