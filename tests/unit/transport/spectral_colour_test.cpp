#include <gtest/gtest.h>

#include <cmath>

#include "core/fabric/model/choice_names.h"
#include "core/fabric/yarn/band_colour.h"
#include "render/colour/primaries.h"
#include "render/colour/tristimulus.h"
#include "render/scene/colouring.h"
#include "render/transport/path_light.h"

namespace loomlight {
namespace {

/// Two fibres, neither of which absorbs.
Fabric white() {
  Fabric fabric;
  fabric.fibres.resize(2);
  fabric.light.kind = LightKind::dome;
  return fabric;
}

/// A dye with a band of its own, as dyes have.
Spectrum bell(double centre_nm, double width_nm, double height_per_mm) {
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) {
    const double away = (bandWavelength_nm(j) - centre_nm) / width_nm;
    bands[j] = static_cast<float>(height_per_mm * std::exp(-away * away));
  }
  return bands;
}

Spectrum flat(float value) {
  Spectrum bands;
  bands.fill(value);
  return bands;
}

PathLight fromAFibre() {
  PathLight light{Rgb(0.9f, 0.8f, 0.4f), {0.1f, 0.5f, 0.25f, 0.15f}};
  light.material = 1;
  light.traverse_mm = 0.02f;
  light.internalReflectance = 0.3f;
  return light;
}

constexpr std::array<float, 2> kLengths_mm = {0.05f, 0.03f};

void expectNear(const Rgb& a, const Rgb& b, double within) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], within) << c;
}

// Three numbers have a spectrum that shows, in daylight, just what they say.
TEST(SpectralColour, PrimariesAreTheSumOfTheirBands) {
  Fabric fabric = white();
  fabric.fibres[0].absorption_per_mm = Rgb(1, 8, 30);
  fabric.fibres[1].absorption_per_mm = Rgb(20, 4, 0);
  const Colouring colouring = colouringOf(fabric);
  ASSERT_FALSE(colouring.isSpectral());
  const Rgb inPrimaries = colourOf({Rgb(1)}, kLengths_mm, colouring);
  for (int c = 0; c < 3; ++c)
    EXPECT_FLOAT_EQ(inPrimaries[c],
                    std::exp(-0.05f * colouring.primaries_per_mm[0][c] - 0.03f * colouring.primaries_per_mm[1][c]));
  const LinearWeights daylight = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  expectNear(Rgb(weighted(daylight, leftInBands(kLengths_mm, colouring))), inPrimaries, 2e-5);
}

// What is known in bands and absorbs all alike is a grey of three numbers, on every way that light can take.
TEST(SpectralColour, FlatBandsAreAGreyOfThreeNumbers) {
  Fabric grey = white(), bands = white();
  grey.fibres[0].absorption_per_mm = Rgb(6.0f);
  grey.fibres[1].absorption_per_mm = Rgb(40.0f);
  bands.fibres[0].absorption_per_mm = Absorption(flat(6));
  bands.fibres[1].absorption_per_mm = Absorption(flat(40));
  ASSERT_TRUE(colouringOf(bands).isSpectral());
  for (const LightKind kind : {LightKind::dome, LightKind::sky}) {
    grey.light.kind = bands.light.kind = kind;
    for (const PathLight& light : {PathLight{Rgb(0.2f, 1, 3)}, fromAFibre()})
      expectNear(colourOf(light, kLengths_mm, colouringOf(bands)), colourOf(light, kLengths_mm, colouringOf(grey)),
                 1e-4);
  }
}

// The same written out, wavelength by wavelength and pass by pass.
TEST(SpectralColour, IsTheSumOverWavelengthsAndPasses) {
  Fabric fabric = white();
  fabric.fibres[0].absorption_per_mm = Rgb(2, 5, 9);
  fabric.fibres[1].absorption_per_mm = Absorption(bell(600, 40, 60));
  const Spectrum& dye = *fabric.fibres[1].absorption_per_mm.bands;
  const PathLight light = fromAFibre();
  const LinearWeights daylight = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  glm::dvec3 expected(0.0);
  for (size_t j = 0; j < kBands; ++j) {
    const double t = std::exp(-double{dye[j]} * light.traverse_mm), inside = light.internalReflectance;
    double through = light.modes[0] + light.modes[1] * t + light.modes[2] * t * t;
    double share = 1 - inside, passed = t * t * t;
    for (int p = 3; p < 80; ++p, share *= inside, passed *= t) through += light.modes[3] * share * passed;
    const double left = through * std::exp(-double{dye[j]} * kLengths_mm[1]);
    for (int o = 0; o < 3; ++o)
      for (int c = 0; c < 3; ++c)
        expected[o] += daylight.rows[static_cast<size_t>(o)][j] * left * light.radiance[c] *
                       std::exp(-double{fabric.fibres[0].absorption_per_mm.primaries[c]} * kLengths_mm[0]) *
                       colourPrimaries()[static_cast<size_t>(c)][j];
  }
  expectNear(colourOf(light, kLengths_mm, colouringOf(fabric)), Rgb(expected), 1e-4);
}

TEST(SpectralColour, WhiteStaysWhiteUnderEveryLamp) {
  for (size_t i = 0; i < ChoiceNames<StandardIlluminant>::names.size(); ++i) {
    Fabric fabric = white();
    fabric.light.illuminant = static_cast<StandardIlluminant>(i);
    if (fabric.light.illuminant == StandardIlluminant::file) continue;
    for (const Observer observer : {Observer::degrees2, Observer::degrees10}) {
      fabric.render.observer = observer;
      SCOPED_TRACE(ChoiceNames<StandardIlluminant>::names[i]);
      expectNear(colourOf({Rgb(1)}, kLengths_mm, colouringOf(fabric)), Rgb(1), 1e-5);
      Fabric inBands = fabric;
      inBands.fibres[0].absorption_per_mm = Absorption(flat(0));
      expectNear(colourOf({Rgb(1)}, kLengths_mm, colouringOf(inBands)), Rgb(1), 1e-4);
    }
  }
}

// Under light of equal power, which favours none; whatever the fibre's modes and the observer.
TEST(SpectralColour, AWhiteClothUnderEIsWhiteInEveryBand) {
  Fabric fabric = white();
  for (Fibre& fibre : fabric.fibres) fibre.absorption_per_mm = Absorption(flat(0));
  fabric.light.illuminant = StandardIlluminant::e;
  for (const Observer observer : {Observer::degrees2, Observer::degrees10}) {
    fabric.render.observer = observer;
    const Colouring colouring = colouringOf(fabric);
    for (const float left : leftInBands(kLengths_mm, colouring)) EXPECT_NEAR(left, 1, 1e-3);
    // What each band adds to what is seen is what it adds of a perfect diffuser.
    const LinearWeights diffuser = linearWeights(illuminantNamed("E"), observer);
    for (size_t o = 0; o < 3; ++o)
      for (size_t j = 0; j < kBands; ++j) {
        float seen = 0;
        for (const Spectrum& primary : colouring.eye.primaries) seen += primary[j] * colouring.eye.channels[o][j];
        EXPECT_NEAR(seen, diffuser.rows[o][j], 1e-3) << bandWavelength_nm(j) << " nm";
      }
  }
}

// Chips are coloured where nothing is known of lamps and observers.
TEST(SpectralColour, AChipIsSeenInDaylight) {
  const LinearWeights daylight = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  for (const double centre_nm : {400, 480, 560, 640, 720}) {
    const Spectrum reflectance = bell(centre_nm, 30, 0.8);
    expectNear(linearFromReflectance(reflectance), Rgb(weighted(daylight, reflectance)), 1e-6);
  }
}

// Which no three numbers can show: one colour by day, two in the shop.
TEST(SpectralColour, MetamersPartUnderAnotherLamp) {
  // What daylight does not see of a ripple: a metameric black (Wyszecki 1953).
  const LinearWeights daylight = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  Spectrum ripple;
  for (size_t j = 0; j < kBands; ++j) ripple[j] = 0.1f * std::sin(static_cast<float>(j));
  const Spectrum seen = mixed(colourPrimaries(), Rgb(weighted(daylight, ripple)));
  Fabric one = white(), other = white();
  Spectrum plain, rippled;
  for (size_t j = 0; j < kBands; ++j) {  // over a way of 1 mm
    plain[j] = -std::log(0.4f);
    rippled[j] = -std::log(0.4f + ripple[j] - seen[j]);
  }
  one.fibres[0].absorption_per_mm = Absorption(plain);
  other.fibres[0].absorption_per_mm = Absorption(rippled);
  constexpr std::array<float, 2> kWay_mm = {1, 0};
  const auto differ = [&](StandardIlluminant illuminant) {
    one.light.illuminant = other.light.illuminant = illuminant;
    const Rgb a = colourOf({Rgb(1)}, kWay_mm, colouringOf(one)), b = colourOf({Rgb(1)}, kWay_mm, colouringOf(other));
    return glm::length(a - b);
  };
  EXPECT_LT(differ(StandardIlluminant::d65), 1e-4);
  EXPECT_GT(differ(StandardIlluminant::f11), 0.01);
  EXPECT_GT(differ(StandardIlluminant::a), 0.001);
}

TEST(SpectralColour, ARecipeAddsUp) {
  Fabric recipe = white(), sum = white();
  Absorption absorption(bell(420, 60, 2));
  absorption.dyes = {{"red", 2, bell(520, 40, 20)}, {"blue", 0.5, bell(620, 50, 30)}};
  recipe.fibres[0].absorption_per_mm = absorption;
  Spectrum together;
  for (size_t j = 0; j < kBands; ++j)
    together[j] = bell(420, 60, 2)[j] + 2 * bell(520, 40, 20)[j] + 0.5f * bell(620, 50, 30)[j];
  sum.fibres[0].absorption_per_mm = Absorption(together);
  expectNear(colourOf({Rgb(1)}, kLengths_mm, colouringOf(recipe)), colourOf({Rgb(1)}, kLengths_mm, colouringOf(sum)),
             1e-6);
}

// Roulette ends paths by it: a band that is brighter would be drawn too seldom, and sparkle.
TEST(SpectralColour, NothingIsBrighterThanTheLeastAbsorptionSays) {
  Fabric fabric = white();
  // Red light alone comes through one fibre, and of the other nothing but what is left of red at 590 nm.
  fabric.fibres[0].absorption_per_mm = Rgb(0, 100, 100);
  Spectrum yellow = flat(50);
  yellow[21] = 0;
  fabric.fibres[1].absorption_per_mm = Absorption(yellow);
  const std::vector<Rgb> least = leastAbsorption_per_mm(colouringOf(fabric));
  EXPECT_EQ(least[0], Rgb(0, 100, 100));
  constexpr std::array<float, 2> kLong_mm = {0.1f, 0.1f};
  const Rgb bound = transmittance(least, kLong_mm);
  const float brightest = std::max({bound.r, bound.g, bound.b});
  const Spectrum left = leftInBands(kLong_mm, colouringOf(fabric));
  EXPECT_GT(left[21], 0.3f) << "there is something to be missed";
  for (const float band : left) EXPECT_LE(band, brightest + 0.03f);
  fabric.fibres[1].absorption_per_mm = Absorption(flat(50));
  const Rgb dark = transmittance(leastAbsorption_per_mm(colouringOf(fabric)), kLong_mm);
  EXPECT_LT(std::max({dark.r, dark.g, dark.b}), 0.01f) << "paths that bring nothing would never end";
}

}  // namespace
}  // namespace loomlight
