#include "app/export/handover/surface_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

glm::vec3 direction(double angle_deg, double azimuth_deg) {
  const double angle = angle_deg * kPi / 180, azimuth = azimuth_deg * kPi / 180;
  return glm::vec3(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle));
}

/// Half-domes under nine lights, without what they see.
std::vector<Observation> halfDomes(bool isThrough) {
  std::vector<Observation> seen;
  constexpr int kAzimuths = 16, kInclinations = 8;
  for (const double angle : {0.0, 30.0, 60.0})
    for (double azimuth = 0; azimuth < (angle > 0 ? 360 : 90); azimuth += 90)
      for (int j = 0; j < kInclinations; ++j)
        for (int i = 0; i < kAzimuths; ++i) {
          const double low = j * kPi / 2 / kInclinations, high = low + kPi / 2 / kInclinations;
          Observation one;
          one.in = direction(isThrough ? 180 - angle : angle, azimuth);
          one.out = direction((j + 0.5) * 90 / kInclinations, (i + 0.5) * 360 / kAzimuths);
          one.weight = static_cast<float>((std::pow(std::sin(high), 2) - std::pow(std::sin(low), 2)) / kAzimuths);
          seen.push_back(one);
        }
  return seen;
}

/// Pixels of two yarns, one along x and one along y, whose normals roll about their axes.
std::vector<SurfaceSample> wovenSamples() {
  std::vector<SurfaceSample> samples;
  Random random(7);
  for (int i = 0; i < 24; ++i) {
    SurfaceSample sample;
    const bool isWarp = i % 2 == 0;
    const float roll = random.uniform() - 0.5f, dip = 0.3f * (random.uniform() - 0.5f);
    sample.point.normal = glm::normalize(isWarp ? glm::vec3(roll, dip, 1) : glm::vec3(dip, roll, 1));
    sample.point.drawnOut = isWarp ? glm::vec2(1, 0) : glm::vec2(0, 1);
    sample.point.reflected = isWarp ? Rgb(0.3f, 0.2f, 0.1f) : Rgb(0.5f, 0.5f, 0.55f);
    sample.point.transmitted = Rgb(0.2f, 0.1f, 0.05f);
    sample.opacity = 0.9f;
    samples.push_back(sample);
  }
  return samples;
}

void show(const SurfaceFit& truth, std::span<const SurfaceSample> samples, std::vector<Observation>& seen) {
  const SheenAlbedo sheen(truth.surface.sheenRoughness);
  const std::vector<Rgb> factors = predictedFactors(truth, sheen, samples, seen);
  for (size_t i = 0; i < seen.size(); ++i) seen[i].factor = factors[i];
}

/// What a sample shows in light of half the sky, seen straight from above: by quadrature over equal projected solid
/// angles, 1 where it sends back all light.
Rgb inEvenLight(const SurfaceFit& fit, const SurfaceSample& sample, bool isThrough) {
  const SheenAlbedo sheen(fit.surface.sheenRoughness);
  constexpr int kSteps = 200;
  std::vector<Observation> sky;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double angle = std::asin(std::sqrt((i + 0.5) / kSteps)) * 180 / kPi;
      sky.emplace_back().in = direction(isThrough ? 180 - angle : angle, (j + 0.5) * 360 / kSteps);
    }
  Rgb sum(0);
  for (const Rgb& factor : predictedFactors(fit, sheen, {&sample, 1}, sky)) sum += factor;
  return sum / static_cast<float>(kSteps * kSteps);
}

/// From diffuse colours to those in even light, which are what maps are of. The weights of the truth become what makes
/// them diffuse colours again.
void colourAsInEvenLight(SurfaceFit& truth, std::vector<SurfaceSample>& samples) {
  const SheenAlbedo sheen(truth.surface.sheenRoughness);
  const glm::vec3 above(0, 0, 1);
  Rgb reflected(0), transmitted(0), reflectedDiffuse(0), transmittedDiffuse(0);
  for (const SurfaceSample& sample : samples) {
    PrincipledPoint at = sample.point;
    at.reflected *= truth.reflectedWeight;
    at.transmitted *= truth.transmittedWeight;
    const LitPoint point(truth.surface, sheen, at);
    const LightParts parts = point.evenlyReflected(above);
    reflected += sample.opacity * (parts.gloss + parts.diffuse * at.reflected);
    transmitted += sample.opacity * point.evenlyTransmitted(above) * at.transmitted;
    reflectedDiffuse += sample.opacity * sample.point.reflected;
    transmittedDiffuse += sample.opacity * sample.point.transmitted;
  }
  for (SurfaceSample& sample : samples) {
    sample.point.reflected *= reflected / reflectedDiffuse;
    sample.point.transmitted *= transmitted / transmittedDiffuse;
  }
  truth.reflectedWeight *= reflectedDiffuse / reflected;
  truth.transmittedWeight *= transmittedDiffuse / transmitted;
}

class FitOfKnown : public testing::TestWithParam<Principled> {};

/// One surface all over, which looks the same from near and from afar.
std::vector<SurfaceSample> evenSamples() {
  std::vector<SurfaceSample> samples = wovenSamples();
  for (SurfaceSample& sample : samples) sample = samples.front();
  for (SurfaceSample& sample : samples) sample.point.normal = {0, 0, 1};
  return samples;
}

TEST_P(FitOfKnown, TheModelsOwnLobesGiveTheirParametersBack) {
  SurfaceFit truth;
  truth.surface = GetParam();
  truth.reflectedWeight = Rgb(0.8f, 0.9f, 1.1f);
  truth.transmittedWeight = Rgb(1.2f, 0.7f, 1.0f);
  std::vector<SurfaceSample> samples = evenSamples();
  colourAsInEvenLight(truth, samples);
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  show(truth, samples, reflected);
  show(truth, samples, transmitted);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  EXPECT_LT(fit.reflected.rms, 1e-3 * fit.reflected.mean);
  EXPECT_LT(fit.transmitted.rms, 1e-2 * fit.transmitted.mean);
  EXPECT_NEAR(fit.surface.roughness, truth.surface.roughness, 0.02);
  EXPECT_NEAR(fit.surface.specular, truth.surface.specular, 0.05);
  EXPECT_NEAR(fit.surface.anisotropy, truth.surface.anisotropy, 0.05);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(fit.surface.sheenColour[c], truth.surface.sheenColour[c], 0.02);
    EXPECT_NEAR(fit.reflectedWeight[c], truth.reflectedWeight[c], 0.02);
    EXPECT_NEAR(fit.transmittedWeight[c], truth.transmittedWeight[c], 0.05);
  }
  if (truth.surface.sheenColour.x > 0) {
    EXPECT_NEAR(fit.surface.sheenRoughness, truth.surface.sheenRoughness, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, FitOfKnown,
                         testing::Values(Principled{0.8f, 0.4f, 0.6f, Rgb(0), 0.5f},
                                         Principled{0.5f, 0.6f, 0.0f, Rgb(0.1f, 0.15f, 0.2f), 0.6f},
                                         Principled{1.0f, 0.3f, 0.3f, Rgb(0.05f), 0.35f}));

/// Adds noise of this share to each factor.
void disturb(float share, uint64_t seed, std::vector<Observation>& seen) {
  Random random(seed);
  for (Observation& one : seen) {
    const float spread = share * std::sqrt(12.0f) * (random.uniform() - 0.5f);
    one.variance = share * share * glm::dot(one.factor, one.factor) / 3;
    one.factor *= 1 + spread;
  }
}

struct KnownGloss {
  float anisotropy;
  glm::vec2 drawnOut;
};
class FitOfGloss : public testing::TestWithParam<KnownGloss> {};

/// A narrow gloss on a dark cloth: how much longer it is one way than the other is found from wherever the fit begins.
TEST_P(FitOfGloss, IsFoundFromEveryStartAndInNoise) {
  SurfaceFit truth;
  truth.surface = {1, 0.4f, GetParam().anisotropy, Rgb(0), 0.5f};
  std::vector<SurfaceSample> samples = evenSamples();
  for (SurfaceSample& sample : samples) {
    sample.point.drawnOut = GetParam().drawnOut;
    sample.point.reflected *= 0.3f;
  }
  samples.resize(4);  // all are the same
  colourAsInEvenLight(truth, samples);
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  show(truth, samples, reflected);
  show(truth, samples, transmitted);
  std::vector<Observation> noisy = reflected;
  disturb(0.3f, 11, noisy);
  std::vector<FitStart> starts(std::begin(kFitStarts), std::end(kFitStarts));
  starts.push_back({0.6, 0, 0.02});  // where the anisotropy's own derivative is 0
  for (const FitStart& start : starts) {
    const SurfaceFit clean = fitSurface(samples, reflected, transmitted, 0, {&start, 1});
    EXPECT_NEAR(clean.surface.anisotropy, truth.surface.anisotropy, 0.03) << start.roughness << ' ' << start.anisotropy;
    const SurfaceFit fit = fitSurface(samples, noisy, transmitted, 0, {&start, 1});
    EXPECT_NEAR(fit.surface.anisotropy, truth.surface.anisotropy, 0.1) << start.roughness << ' ' << start.anisotropy;
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, FitOfGloss,
                         testing::Values(KnownGloss{0, {1, 0}}, KnownGloss{0.8f, {1, 0}}, KnownGloss{0.8f, {0, 1}}));

glm::vec3 turned(glm::vec3 v) {
  return {-v.x, v.y, v.z};
}

/// A cloth and its mirror image, each with noise of its own, are the same surface.
TEST(SurfaceFit, ATwinThatIsTurnedOverIsTheSameSurface) {
  SurfaceFit truth;
  truth.surface = {1, 0.4f, 0.7f, Rgb(0), 0.5f};
  std::vector<SurfaceSample> samples = wovenSamples();
  for (SurfaceSample& sample : samples) {
    sample.point.drawnOut = glm::normalize(glm::vec2(1, 0.3f));
    sample.point.reflected *= 0.2f;
  }
  colourAsInEvenLight(truth, samples);
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  show(truth, samples, reflected);
  show(truth, samples, transmitted);
  std::vector<SurfaceSample> twinSamples = samples;
  for (SurfaceSample& sample : twinSamples) {
    sample.point.normal = turned(sample.point.normal);
    sample.point.drawnOut.x *= -1;
  }
  std::vector<Observation> twinReflected = reflected;
  for (Observation& one : twinReflected) {
    one.in = turned(one.in);
    one.out = turned(one.out);
  }
  disturb(0.2f, 21, reflected);
  disturb(0.2f, 22, twinReflected);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  const SurfaceFit twin = fitSurface(twinSamples, twinReflected, transmitted);
  EXPECT_NEAR(fit.surface.anisotropy, twin.surface.anisotropy, 0.05);
  EXPECT_NEAR(fit.surface.roughness, twin.surface.roughness, 0.03);
  EXPECT_NEAR(fit.surface.specular, twin.surface.specular, 0.05);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.reflectedWeight[c], twin.reflectedWeight[c], 0.03);
}

/// A dark cloth whose light is all gloss, which maps of its hue cannot leave it all: it is no brighter for that.
TEST(SurfaceFit, ADarkClothIsAsBrightInEvenLightAsItsMaps) {
  SurfaceFit truth;
  truth.surface = {1, 0.7f, 0, Rgb(0.02f), 0.5f};
  std::vector<SurfaceSample> samples = evenSamples();
  for (SurfaceSample& sample : samples) sample.point.reflected = Rgb(0.002f, 0.004f, 0.02f);
  colourAsInEvenLight(truth, samples);
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  show(truth, samples, reflected);
  show(truth, samples, transmitted);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  const SurfaceSample& one = samples.front();
  const Rgb colour = one.opacity * one.point.reflected, through = one.opacity * one.point.transmitted;
  const Rgb shown = inEvenLight(fit, one, false), shownThrough = inEvenLight(fit, one, true);
  for (int c = 0; c < 3; ++c) {
    EXPECT_GE(fit.reflectedWeight[c], 0.5f);
    EXPECT_NEAR(shown[c], colour[c], 0.02 * colour[c]);
    EXPECT_NEAR(shownThrough[c], through[c], 0.02 * through[c]);
    EXPECT_NEAR(fit.evenLight[c], shown[c] / colour[c], 0.01);
  }
}

TEST(SurfaceFit, StatesTheErrorOfWhatItCannotFit) {
  // A cloth that sends light from everywhere back to where it came from, which no such surface does.
  const std::vector<SurfaceSample> samples = wovenSamples();
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  for (Observation& one : reflected) one.factor = Rgb(glm::dot(one.in, one.out) > 0.95f ? 3.0f : 0.2f);
  for (Observation& one : transmitted) one.factor = Rgb(0.1f);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  EXPECT_GT(fit.reflected.rms, 0.3 * fit.reflected.mean);
}

/// What a fit is held against: one colour from everywhere, which is that of the maps.
TEST(SurfaceFit, StatesTheErrorOfAMattSurfaceToo) {
  const std::vector<SurfaceSample> samples = evenSamples();
  const Rgb colour = samples.front().opacity * samples.front().point.reflected;
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  for (Observation& one : reflected) one.factor = colour + (one.in.z < 0.9f ? Rgb(0.3f, 0, 0) : Rgb(0));
  double off = 0, all = 0;
  for (const Observation& one : reflected) {
    off += one.in.z < 0.9f ? one.weight : 0;
    all += one.weight;
  }
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted, 0, std::span(kFitStarts).first(1));
  ASSERT_GT(off, 0);
  EXPECT_NEAR(fit.matt.rms, 0.3 * std::sqrt(off / all / 3), 1e-5);
}

/// Of samples without anisotropy.
SurfaceSample meanOf(std::span<const SurfaceSample> samples) {
  SurfaceSample mean = samples.front();
  mean.point.normal = glm::vec3(0);
  mean.point.reflected = Rgb(0);
  for (const SurfaceSample& sample : samples) {
    mean.point.normal += sample.point.normal;
    mean.point.reflected += sample.point.reflected / static_cast<float>(samples.size());
  }
  mean.point.normal = glm::normalize(mean.point.normal);
  return mean;
}

double rmsOf(const SurfaceFit& fit, const SurfaceSample& sample, std::span<const Observation> seen) {
  const SheenAlbedo sheen(fit.surface.sheenRoughness);
  double sum = 0, weights = 0;
  const std::vector<Rgb> predicted = predictedFactors(fit, sheen, {&sample, 1}, seen);
  for (size_t i = 0; i < seen.size(); ++i) {
    const Observation& one = seen[i];
    const Rgb difference = predicted[i] - one.factor;
    sum += one.weight * glm::dot(difference, difference) / 3;
    weights += one.weight;
  }
  return std::sqrt(sum / weights);
}

/// Threads of narrow gloss whose normals spread it: the gloss of one pixel, seen from afar without their spread, would
/// be a mirror's, with an error of many times the mean.
TEST(SurfaceFit, StandsForTheClothFromAfarToo) {
  std::vector<SurfaceSample> samples = wovenSamples();
  for (SurfaceSample& sample : samples) {
    sample.point.reflected *= 0.1f;
    sample.point.normal = glm::normalize(glm::vec3(3, 3, 1) * sample.point.normal);
  }
  SurfaceFit truth;
  truth.surface = {1, 0.3f, 0, Rgb(0), 0.5f};
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  show(truth, samples, reflected);
  show(truth, samples, transmitted);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  EXPECT_LT(fit.fromAfar.rms, 0.25 * rmsOf(truth, meanOf(samples), reflected)) << "no better than that of the pixels";
  EXPECT_GT(fit.surface.roughness, 1.3 * truth.surface.roughness) << "the spread of the normals is in the gloss now";
  EXPECT_GE(fit.normalStrength, 0.5f) << "the maps still show threads";
}

/// A dark blue cloth whose highlights are blue too, which no gloss of a dielectric is: red is too little everywhere.
TEST(SurfaceFit, LeavesTheMapsTheirHue) {
  const std::vector<SurfaceSample> samples = wovenSamples();
  std::vector<Observation> reflected = halfDomes(false), transmitted = halfDomes(true);
  for (Observation& one : reflected) one.factor = Rgb(0, 0.02f, 0.1f);
  for (Observation& one : transmitted) one.factor = Rgb(0.01f);
  const SurfaceFit fit = fitSurface(samples, reflected, transmitted);
  for (int c = 0; c < 3; ++c) EXPECT_GE(fit.reflectedWeight[c], 0.5f);
}

TEST(Principled, TakesLightInAndOutTheSameWay) {
  PrincipledPoint at;
  at.normal = glm::normalize(glm::vec3(0.2f, -0.1f, 1));
  at.drawnOut = glm::normalize(glm::vec2(0.3f, 0.9f));
  at.reflected = Rgb(0.4f);
  const Principled surface{0.9f, 0.4f, 0.7f, Rgb(0.2f), 0.4f};
  const SheenAlbedo sheen(surface.sheenRoughness);
  const glm::vec3 in = direction(25, 40), out = direction(50, 200);
  const LitPoint point(surface, sheen, at);
  const Rgb there = point.sent(in, out) / glm::dot(at.normal, in);
  const Rgb back = point.sent(out, in) / glm::dot(at.normal, out);
  EXPECT_NEAR(there.x, back.x, 1e-5);
  EXPECT_GT(there.x, 0);
}

/// Light from either side and from below the surface's tangent plane, in one set of eight.
TEST(Principled, SendsEightDirectionsSideBySideAsItDoesEachAlone) {
  PrincipledPoint at;
  at.normal = glm::normalize(glm::vec3(0.6f, -0.3f, 1));
  at.reflected = Rgb(0.4f, 0.2f, 0.1f);
  at.transmitted = Rgb(0.1f, 0.2f, 0.3f);
  const Principled surface{0.9f, 0.4f, 0.7f, Rgb(0.2f, 0.1f, 0), 0.4f};
  const SheenAlbedo sheen(surface.sheenRoughness);
  const LitPoint point(surface, sheen, at);
  constexpr double kIn_deg[] = {0, 30, 60, 85, 89, 95, 120, 170}, kOut_deg[] = {0, 20, 88, 40, 60, 30, 85, 10};
  Vec3Of<Float32x8> in, out;
  const auto put = [](Vec3Of<Float32x8>& to, int lane, glm::vec3 v) {
    to.x[lane] = v.x;
    to.y[lane] = v.y;
    to.z[lane] = v.z;
  };
  for (int i = 0; i < 8; ++i) {
    put(in, i, direction(kIn_deg[i], 50 * i));
    put(out, i, direction(kOut_deg[i], 180 - 30 * i));
  }
  const Vec3Of<Float32x8> together = point.sent(in, out);
  int dark = 0;
  for (int i = 0; i < 8; ++i) {
    const Rgb alone = point.sent(direction(kIn_deg[i], 50 * i), direction(kOut_deg[i], 180 - 30 * i));
    EXPECT_EQ(Rgb(together.x[i], together.y[i], together.z[i]), alone) << i;
    dark += alone == Rgb(0);
  }
  EXPECT_GT(dark, 0) << "some lie below the tangent plane";
  EXPECT_LT(dark, 5);
}

/// Albedo over the half-dome by quadrature, for light from `angle_deg`.
double albedo(const Principled& surface, double angle_deg) {
  PrincipledPoint at;
  at.reflected = Rgb(1);
  const SheenAlbedo sheen(surface.sheenRoughness);
  const LitPoint point(surface, sheen, at);
  double sum = 0;
  constexpr int kSteps = 128;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double square = (i + 0.5) / kSteps;  // of the sine: equal projected solid angles
      const glm::vec3 out = direction(std::asin(std::sqrt(square)) * 180 / kPi, (j + 0.5) * 360 / kSteps);
      // By reciprocity, the light that comes from everywhere into one direction.
      sum += point.sent(out, direction(angle_deg, 30)).x / out.z;
    }
  return sum * kPi / (kSteps * kSteps);
}

TEST(Principled, AWhiteSurfaceSendsBackNoMoreThanItGets) {
  for (const double angle : {5.0, 40.0, 70.0}) {
    EXPECT_NEAR(albedo({0, 0.5f, 0, Rgb(0), 0.5f}, angle), 1, 1e-3);
    EXPECT_LT(albedo({1, 0.5f, 0.5f, Rgb(0), 0.5f}, angle), 1.02);
    EXPECT_LT(albedo({1, 0.5f, 0.5f, Rgb(0.5f), 0.5f}, angle), 1.02);
    EXPECT_GT(albedo({1, 0.5f, 0.5f, Rgb(0.5f), 0.5f}, angle), 0.6);
  }
}

/// Within 1 %, which is what the lattice of directions is good for.
TEST(Principled, InEvenLightItIsTheSumOverHalfTheSky) {
  SurfaceSample sample;
  sample.point.reflected = Rgb(0.2f, 0.02f, 0);
  sample.point.transmitted = Rgb(0.3f);
  SurfaceFit fit;
  for (const float roughness : {0.25f, 0.5f, 0.9f})
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0.4f, 0.2f, 1)}) {
      sample.point.normal = glm::normalize(normal);
      fit.surface = {1, roughness, 0.5f, Rgb(0.1f), 0.5f};
      const SheenAlbedo sheen(fit.surface.sheenRoughness);
      const glm::vec3 above(0, 0, 1);
      const LitPoint point(fit.surface, sheen, sample.point);
      const LightParts parts = point.evenlyReflected(above);
      const Rgb reflected = parts.gloss + parts.diffuse * sample.point.reflected;
      const Rgb transmitted = point.evenlyTransmitted(above) * sample.point.transmitted;
      const Rgb expected = inEvenLight(fit, sample, false);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(reflected[c], expected[c], 0.01 * expected[c]) << roughness;
      EXPECT_NEAR(transmitted.x, inEvenLight(fit, sample, true).x, 0.01 * transmitted.x);
    }
}

TEST(Principled, ItsHighlightIsLongAlongTheAxis) {
  const Principled surface{1, 0.3f, 0.8f, Rgb(0), 0.5f};
  const SheenAlbedo sheen(surface.sheenRoughness);
  PrincipledPoint at;
  at.drawnOut = {0, 1};
  const glm::vec3 normal(0, 0, 1);
  const LitPoint point(surface, sheen, at);
  const Rgb along = point.sent(normal, direction(40, 90));
  const Rgb across = point.sent(normal, direction(40, 0));
  EXPECT_GT(along.x, 2 * across.x);
}

}  // namespace
}  // namespace loomlight
