// How it works. The unknowns are the five numbers of the principled surface (with a sheen of three channels: seven),
// three weights of the colour maps and one of the normals. A prediction is what a renderer would show of the patch: the
// mean over pixels, each with its normal, axis and colours; and, with as much weight, one pixel of their means, which
// programs show that filter maps from afar. A gloss fitted to pixels alone is narrow, as their normals spread it, and
// from afar it would be a mirror's. Residuals are the differences of ln(1 + factor / mean) of each channel, times the
// root of the projected solid angle: dark cloths are twenty times as bright at a glance along them as from above, which
// would count for all the rest, and a fit of the factors themselves shows them pale from above (Loew et al. 2012 fit
// logarithms for the same reason). A wide and a narrow gloss, with and without sheen, are tried as starts, as the sum
// of squares has more than one valley.
#include "app/export/handover/surface_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/export/handover/least_squares.h"
#include "core/base/parallel.h"

namespace loomlight {
namespace {

enum Parameter {
  kSpecular,
  kRoughness,
  kAnisotropy,
  kSheenRoughness,
  kSheen,
  kReflected = kSheen + 3,
  kNormals = kReflected + 3,
  kCount
};

SurfaceFit surfaceOf(std::span<const double> values) {
  const auto at = [&](int parameter) { return static_cast<float>(values[static_cast<size_t>(parameter)]); };
  SurfaceFit fit;
  fit.surface.specular = at(kSpecular);
  fit.surface.roughness = at(kRoughness);
  fit.surface.anisotropy = at(kAnisotropy);
  fit.surface.sheenRoughness = at(kSheenRoughness);
  fit.normalStrength = at(kNormals);
  for (int c = 0; c < 3; ++c) {
    fit.surface.sheenColour[c] = at(kSheen + c);
    fit.reflectedWeight[c] = at(kReflected + c);
  }
  return fit;
}

std::vector<Unknown> unknownsFrom(double roughness, double sheen) {
  // A weight near 0 would leave a map that is black in that channel: where the gloss of the fit is too bright in one
  // colour, the map still has the hue of the cloth.
  constexpr double kLeastWeight = 0.5;
  constexpr double kLeastSlopes = 0.5;  // flat maps would fit most cloths best, and show no thread
  std::vector<Unknown> unknowns(kCount, {1, kLeastWeight, 2});
  unknowns[kSpecular] = {0.5, 0, 1};
  unknowns[kRoughness] = {roughness, 0.1, 1};
  unknowns[kAnisotropy] = {0.3, 0, 1};
  unknowns[kSheenRoughness] = {0.5, 0.15, 1};
  unknowns[kNormals] = {0.75, kLeastSlopes, 1};
  for (int c = 0; c < 3; ++c) unknowns[size_t{kSheen} + static_cast<size_t>(c)] = {sheen, 0, 1};
  return unknowns;
}

/// The measured and the predicted, weighted as residuals are, of one fit.
FitError errorOf(const SurfaceFit& fit, std::span<const SurfaceSample> samples, std::span<const Observation> seen) {
  const SheenAlbedo sheen(fit.surface.sheenRoughness);
  FitError error;
  double weights = 0;
  for (const Observation& one : seen) {
    const Rgb difference = predictedFactor(fit, sheen, samples, one) - one.factor;
    weights += one.weight;
    error.mean += one.weight * (one.factor.r + one.factor.g + one.factor.b) / 3;
    error.rms += one.weight * glm::dot(difference, difference) / 3;
    error.noise += one.weight * one.variance;
  }
  error.mean /= weights;
  error.rms = std::sqrt(std::max(0.0, error.rms - error.noise) / weights);
  error.noise = std::sqrt(error.noise / weights);
  return error;
}

/// With the normals that the maps of this fit have.
std::vector<SurfaceSample> asFitted(std::span<const SurfaceSample> samples, const SurfaceFit& fit) {
  std::vector<SurfaceSample> fitted(samples.begin(), samples.end());
  for (SurfaceSample& sample : fitted) sample.point.normal = flattened(sample.point.normal, fit.normalStrength);
  return fitted;
}

/// All pixels seen as one.
std::vector<SurfaceSample> fromAfar(std::span<const SurfaceSample> samples) {
  SurfaceSample mean;
  mean.opacity = 0;
  mean.point.anisotropyScale = mean.point.roughnessScale = 0;
  glm::vec3 normal(0);
  glm::vec2 axes(0);  // with doubled angles, as both ends of an axis are the same
  for (const SurfaceSample& sample : samples) {
    const PrincipledPoint& at = sample.point;
    const glm::vec2 axis = at.drawnOut;
    mean.opacity += sample.opacity;
    mean.point.reflected += sample.opacity * at.reflected;
    mean.point.transmitted += sample.opacity * at.transmitted;
    mean.point.roughnessScale += sample.opacity * at.roughnessScale;
    normal += sample.opacity * at.normal;
    axes += sample.opacity * at.anisotropyScale * glm::vec2(axis.x * axis.x - axis.y * axis.y, 2 * axis.x * axis.y);
  }
  if (mean.opacity <= 0) return {mean};
  mean.point.reflected /= mean.opacity;
  mean.point.transmitted /= mean.opacity;
  mean.point.roughnessScale /= mean.opacity;
  mean.point.normal = glm::normalize(normal);
  mean.point.anisotropyScale = glm::length(axes) / mean.opacity;
  const float angle = 0.5f * std::atan2(axes.y, axes.x);
  mean.point.drawnOut = {std::cos(angle), std::sin(angle)};
  mean.opacity /= static_cast<float>(samples.size());
  return {mean};
}

/// Of the factors, by weight; a channel that is nearly black counts by the brightest.
Rgb meanFactor(std::span<const Observation> seen) {
  constexpr float kLeastShare = 0.01f;
  Rgb sum(0);
  float weights = 0;
  for (const Observation& one : seen) {
    sum += one.weight * one.factor;
    weights += one.weight;
  }
  const Rgb mean = sum / weights;
  return glm::max(mean, Rgb(std::max(1e-6f, kLeastShare * std::max({mean.r, mean.g, mean.b}))));
}

LeastSquares fitFrom(std::span<const Unknown> unknowns, std::span<const SurfaceSample> samples,
                     std::span<const Observation> seen) {
  const Rgb mean = meanFactor(seen);
  const auto brightness = [mean](const Rgb& factor) { return glm::log(Rgb(1) + glm::max(factor, Rgb(0)) / mean); };
  return leastSquares(unknowns, [&](std::span<const double> values) {
    const SurfaceFit fit = surfaceOf(values);
    const SheenAlbedo sheen(fit.surface.sheenRoughness);
    const std::vector<SurfaceSample> near = asFitted(samples, fit), afar = fromAfar(near);
    std::vector<double> residuals;
    residuals.reserve(6 * seen.size());
    for (const auto* patch : {&near, &afar})
      for (const Observation& one : seen) {
        const Rgb difference = brightness(predictedFactor(fit, sheen, *patch, one)) - brightness(one.factor);
        for (int c = 0; c < 3; ++c) residuals.push_back(std::sqrt(0.5 * one.weight) * difference[c]);
      }
    return residuals;
  });
}

/// The weight of each channel for which the squares of predicted minus measured are least.
Rgb transmittedWeight(const SurfaceFit& fit, std::span<const SurfaceSample> samples,
                      std::span<const Observation> seen) {
  const SheenAlbedo sheen(fit.surface.sheenRoughness);
  glm::dvec3 products(0), squares(0);
  for (const Observation& one : seen) {
    const glm::dvec3 predicted = predictedFactor(fit, sheen, samples, one);
    products += static_cast<double>(one.weight) * predicted * glm::dvec3(one.factor);
    squares += static_cast<double>(one.weight) * predicted * predicted;
  }
  Rgb weight(1);
  for (int c = 0; c < 3; ++c)
    if (squares[c] > 0) weight[c] = static_cast<float>(std::clamp(products[c] / squares[c], 0.0, 2.0));
  return weight;
}

}  // namespace

Rgb predictedFactor(const SurfaceFit& fit, const SheenAlbedo& sheen, std::span<const SurfaceSample> samples,
                    const Observation& seen) {
  const bool isThrough = seen.in.z < 0;
  Rgb sum(0);
  for (const SurfaceSample& sample : samples) {
    PrincipledPoint at = sample.point;
    at.reflected *= fit.reflectedWeight;
    at.transmitted *= fit.transmittedWeight;
    sum += sample.opacity * (isThrough ? transmittedLight(fit.surface, sheen, at, seen.in, seen.out)
                                       : reflectedLight(fit.surface, sheen, at, seen.in, seen.out));
  }
  const auto count = static_cast<float>(samples.size());
  return static_cast<float>(kPi) / (count * std::abs(seen.in.z)) * sum;
}

Rgb quotient(const Rgb& wanted, const Rgb& is) {
  Rgb scale(1);
  for (int c = 0; c < 3; ++c)
    if (is[c] > 0) scale[c] = wanted[c] / is[c];
  return scale;
}

SurfaceFit fitSurface(std::span<const SurfaceSample> samples, std::span<const Observation> reflected,
                      std::span<const Observation> transmitted, int threads) {
  constexpr std::array<std::pair<double, double>, 3> kStarts{{{0.6, 0.02}, {0.35, 0.02}, {0.9, 0.2}}};
  std::array<LeastSquares, kStarts.size()> fits;
  parallelFor(fits.size(), threads, [&](size_t i) {
    fits[i] = fitFrom(unknownsFrom(kStarts[i].first, kStarts[i].second), samples, reflected);
  });
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const LeastSquares& a, const LeastSquares& b) { return a.sum < b.sum; });
  SurfaceFit fit = surfaceOf(best->values);
  const std::vector<SurfaceSample> near = asFitted(samples, fit);
  fit.transmittedWeight = transmittedWeight(fit, near, transmitted);
  fit.reflected = errorOf(fit, near, reflected);
  fit.transmitted = errorOf(fit, near, transmitted);
  fit.fromAfar = errorOf(fit, fromAfar(near), reflected);
  return fit;
}

}  // namespace loomlight
