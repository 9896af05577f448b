// How it works. The unknowns are the five numbers of the principled surface (with a sheen of three channels: seven) and
// a weight of the normals. The weights of the colour maps are no unknowns: they follow from what the maps are colours
// of, which is the cloth in even light from above, where the fitted surface is to have the same colour. What its gloss
// and sheen send back there, the maps leave out. Where gloss leaves them too little, what is too much is a residual
// that outweighs the others, and gloss goes down. A prediction is what a renderer would show of the patch: the
// mean over pixels, each with its normal, axis and colours; and, with as much weight, one pixel of their means, which
// programs show that filter maps from afar. A gloss fitted to pixels alone is narrow, as their normals spread it, and
// from afar it would be a mirror's. Residuals are the differences of ln(1 + factor / mean) of each channel, times the
// root of the projected solid angle: dark cloths are twenty times as bright at a glance along them as from above, which
// would count for all the rest, and a fit of the factors themselves shows them pale from above (Loew et al. 2012 fit
// logarithms for the same reason). Several starts are tried, as the sum of squares has more than one valley.
#include "app/export/handover/surface_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/export/handover/least_squares.h"
#include "core/base/parallel.h"

namespace loomlight {
namespace {

constexpr glm::vec3 kAbove(0, 0, 1);

/// Of observations side by side.
struct Directions {
  Vec3Of<Float32x8> in, out;
};
constexpr size_t kAtOnce = kLanes<Float32x8>;
/// What is left of the last ones looks straight from above, in light from there; nobody asks for it.
std::vector<Directions> sideBySide(std::span<const Observation> seen) {
  const Vec3Of<Float32x8> above{{}, {}, broadcast<Float32x8>(1)};
  std::vector<Directions> directions((seen.size() + kAtOnce - 1) / kAtOnce, Directions{above, above});
  for (size_t i = 0; i < seen.size(); ++i) {
    Directions& some = directions[i / kAtOnce];
    const size_t lane = i % kAtOnce;
    const auto put = [lane](Vec3Of<Float32x8>& to, glm::vec3 v) {
      to.x[lane] = v.x;
      to.y[lane] = v.y;
      to.z[lane] = v.z;
    };
    put(some.in, seen[i].in);
    put(some.out, seen[i].out);
  }
  return directions;
}

/// The anisotropy is fitted by its square, in proportion to which slopes grow: by itself its derivative is 0 at 0, and
/// tells a fit that comes there nothing of where to go.
enum Parameter { kSpecular, kRoughness, kSquaredAnisotropy, kSheenRoughness, kNormals, kSheen, kCount = kSheen + 3 };

/// Without the weights of the maps.
SurfaceFit surfaceOf(std::span<const double> values) {
  const auto at = [&](int parameter) { return static_cast<float>(values[static_cast<size_t>(parameter)]); };
  SurfaceFit fit;
  fit.surface.specular = at(kSpecular);
  fit.surface.roughness = at(kRoughness);
  fit.surface.anisotropy = std::sqrt(at(kSquaredAnisotropy));
  fit.surface.sheenRoughness = at(kSheenRoughness);
  fit.normalStrength = at(kNormals);
  for (int c = 0; c < 3; ++c) fit.surface.sheenColour[c] = at(kSheen + c);
  return fit;
}

std::vector<Unknown> unknownsFrom(const FitStart& start) {
  constexpr double kLeastSlopes = 0.5;  // flat maps would fit most cloths best, and show no thread
  std::vector<Unknown> unknowns(kCount, {start.sheen, 0, 1});
  unknowns[kSpecular] = {0.5, 0, 1};
  unknowns[kRoughness] = {start.roughness, 0.1, 1};
  unknowns[kSquaredAnisotropy] = {start.anisotropy * start.anisotropy, 0, 1};
  unknowns[kSheenRoughness] = {0.5, 0.15, 1};
  unknowns[kNormals] = {0.75, kLeastSlopes, 1};
  return unknowns;
}

/// Of what is predicted, weighted by the directions.
FitError errorOf(std::span<const Rgb> predicted, std::span<const Observation> seen) {
  FitError error;
  double weights = 0;
  for (size_t i = 0; i < seen.size(); ++i) {
    const Observation& one = seen[i];
    const Rgb difference = predicted[i] - one.factor;
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
FitError errorOf(const SurfaceFit& fit, std::span<const SurfaceSample> samples, std::span<const Observation> seen) {
  return errorOf(predictedFactors(fit, SheenAlbedo(fit.surface.sheenRoughness), samples, seen), seen);
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

/// A colour to divide by: a channel that is nearly black counts by the brightest.
Rgb divisor(const Rgb& colour) {
  constexpr float kLeastShare = 0.01f;
  return glm::max(colour, Rgb(std::max(1e-6f, kLeastShare * std::max({colour.r, colour.g, colour.b}))));
}

/// Of the factors, by weight.
Rgb meanFactor(std::span<const Observation> seen) {
  Rgb sum(0);
  float weights = 0;
  for (const Observation& one : seen) {
    sum += one.weight * one.factor;
    weights += one.weight;
  }
  return sum / weights;
}

/// The pixels of one fit, as they are seen from near, and as one.
struct Patches {
  std::vector<SurfaceSample> near, afar;

  Patches(std::span<const SurfaceSample> samples, const SurfaceFit& fit)
      : near(asFitted(samples, fit)), afar(fromAfar(near)) {}
};

/// Mean of the colours of a patch, holes counted as black.
Rgb meanColour(std::span<const SurfaceSample> samples, Rgb PrincipledPoint::* colour) {
  Rgb sum(0);
  for (const SurfaceSample& sample : samples) sum += sample.opacity * (sample.point.*colour);
  return sum / static_cast<float>(samples.size());
}

/// What a patch shows in light of this side's half of the sky, seen straight from above: its gloss, and its diffuse
/// part where the map has a weight of 1.
struct EvenPatch {
  Rgb gloss{0}, diffuse{0};
};
EvenPatch evenlyReflected(const Principled& surface, const SheenAlbedo& sheen, std::span<const SurfaceSample> samples) {
  EvenPatch sum;
  for (const SurfaceSample& sample : samples) {
    const LightParts parts = LitPoint(surface, sheen, sample.point).evenlyReflected(kAbove);
    sum.gloss += sample.opacity * parts.gloss;
    sum.diffuse += sample.opacity * parts.diffuse * sample.point.reflected;
  }
  const auto count = static_cast<float>(samples.size());
  return {sum.gloss / count, sum.diffuse / count};
}

/// The same of the other half of the sky.
Rgb evenlyTransmitted(const Principled& surface, const SheenAlbedo& sheen, std::span<const SurfaceSample> samples) {
  Rgb sum(0);
  for (const SurfaceSample& sample : samples)
    sum += sample.opacity * LitPoint(surface, sheen, sample.point).evenlyTransmitted(kAbove) * sample.point.transmitted;
  return sum / static_cast<float>(samples.size());
}

/// Gives the map of reflected light the weight for which the surface, seen straight from above in even light, is as
/// bright as the samples' colours: on the average of near and afar. What is too bright even so, of the colour in each
/// channel.
Rgb weighReflected(SurfaceFit& fit, const SheenAlbedo& sheen, const Patches& patches) {
  // A weight near 0 would leave a map that is black in that channel: gloss, which has no hue, would take the cloth's
  // from its threads.
  constexpr float kLeastWeight = 0.5f;
  const EvenPatch near = evenlyReflected(fit.surface, sheen, patches.near);
  const EvenPatch afar = evenlyReflected(fit.surface, sheen, patches.afar);
  const Rgb colour = meanColour(patches.near, &PrincipledPoint::reflected);
  const Rgb gloss = 0.5f * (near.gloss + afar.gloss), diffuse = 0.5f * (near.diffuse + afar.diffuse);
  fit.reflectedWeight = glm::max(Rgb(kLeastWeight), quotient(colour - gloss, diffuse));
  return glm::max(Rgb(0), gloss + fit.reflectedWeight * diffuse - colour) / divisor(colour);
}

LeastSquares fitFrom(const FitStart& start, std::span<const SurfaceSample> samples, std::span<const Observation> seen) {
  // The other squares sum up to a few units, and change by as much with a channel's gloss: a hundredth of the colour
  // too much counts as little, a tenth more than all the rest.
  constexpr double kPenalty = 30;
  const Rgb mean = divisor(meanFactor(seen));
  const auto brightness = [mean](const Rgb& factor) { return glm::log(Rgb(1) + glm::max(factor, Rgb(0)) / mean); };
  return leastSquares(unknownsFrom(start), [&](std::span<const double> values) {
    SurfaceFit fit = surfaceOf(values);
    const SheenAlbedo sheen(fit.surface.sheenRoughness);
    const Patches patches(samples, fit);
    const Rgb excess = weighReflected(fit, sheen, patches);
    std::vector<double> residuals;
    residuals.reserve(3 + 6 * seen.size());
    for (int c = 0; c < 3; ++c) residuals.push_back(kPenalty * excess[c]);
    for (const auto* patch : {&patches.near, &patches.afar}) {
      const std::vector<Rgb> predicted = predictedFactors(fit, sheen, *patch, seen);
      for (size_t i = 0; i < seen.size(); ++i) {
        const Rgb difference = brightness(predicted[i]) - brightness(seen[i].factor);
        for (int c = 0; c < 3; ++c) residuals.push_back(std::sqrt(0.5 * seen[i].weight) * difference[c]);
      }
    }
    return residuals;
  });
}

}  // namespace

std::vector<Rgb> predictedFactors(const SurfaceFit& fit, const SheenAlbedo& sheen,
                                  std::span<const SurfaceSample> samples, std::span<const Observation> seen) {
  const std::vector<Directions> directions = sideBySide(seen);
  std::vector<Vec3Of<Float32x8>> sums(directions.size());
  for (const SurfaceSample& sample : samples) {
    PrincipledPoint at = sample.point;
    at.reflected *= fit.reflectedWeight;
    at.transmitted *= fit.transmittedWeight;
    const LitPoint point(fit.surface, sheen, at);
    const auto opacity = broadcast<Float32x8>(sample.opacity);
    for (size_t i = 0; i < directions.size(); ++i)
      sums[i] = sums[i] + opacity * point.sent(directions[i].in, directions[i].out);
  }
  std::vector<Rgb> factors(seen.size());
  const auto count = static_cast<float>(samples.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    const Vec3Of<Float32x8>& sum = sums[i / kAtOnce];
    const size_t lane = i % kAtOnce;
    factors[i] = kPiF / (count * std::abs(seen[i].in.z)) * Rgb(sum.x[lane], sum.y[lane], sum.z[lane]);
  }
  return factors;
}

Rgb quotient(const Rgb& wanted, const Rgb& is) {
  Rgb scale(1);
  for (int c = 0; c < 3; ++c)
    if (is[c] > 0) scale[c] = wanted[c] / is[c];
  return scale;
}

SurfaceFit fitSurface(std::span<const SurfaceSample> samples, std::span<const Observation> reflected,
                      std::span<const Observation> transmitted, int threads, std::span<const FitStart> starts) {
  std::vector<LeastSquares> fits(starts.size());
  parallelFor(fits.size(), threads, [&](size_t i) { fits[i] = fitFrom(starts[i], samples, reflected); });
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const LeastSquares& a, const LeastSquares& b) { return a.sum < b.sum; });
  SurfaceFit fit = surfaceOf(best->values);
  const SheenAlbedo sheen(fit.surface.sheenRoughness);
  const Patches patches(samples, fit);
  weighReflected(fit, sheen, patches);
  fit.transmittedWeight = quotient(meanColour(patches.near, &PrincipledPoint::transmitted),
                                   0.5f * (evenlyTransmitted(fit.surface, sheen, patches.near) +
                                           evenlyTransmitted(fit.surface, sheen, patches.afar)));
  fit.reflected = errorOf(fit, patches.near, reflected);
  fit.transmitted = errorOf(fit, patches.near, transmitted);
  fit.fromAfar = errorOf(fit, patches.afar, reflected);
  const Rgb colour = meanColour(patches.near, &PrincipledPoint::reflected);
  fit.matt = errorOf(std::vector<Rgb>(reflected.size(), colour), reflected);
  const auto shown = [&](const std::vector<SurfaceSample>& patch) {
    const EvenPatch even = evenlyReflected(fit.surface, sheen, patch);
    return even.gloss + fit.reflectedWeight * even.diffuse;
  };
  fit.evenLight = quotient(shown(patches.near), colour);
  fit.evenLightFromAfar = quotient(shown(patches.afar), colour);
  return fit;
}

}  // namespace loomlight
