#include "render/transport/light_batches.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr size_t kMaterials = 3;

Spectrum bell(double centre_nm, double height_per_mm) {
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) {
    const double away = (bandWavelength_nm(j) - centre_nm) / 40;
    bands[j] = static_cast<float>(height_per_mm * std::exp(-away * away));
  }
  return bands;
}

/// Three fibres, of which so many are known in bands.
Colouring colouringOf(size_t inBands, StandardIlluminant lamp) {
  Fabric fabric;
  fabric.fibres.resize(kMaterials);
  fabric.light.kind = LightKind::dome;
  fabric.light.illuminant = lamp;
  fabric.fibres[0].absorption_per_mm = Rgb(1, 8, 30);
  fabric.fibres[1].absorption_per_mm = Rgb(20, 4, 0);
  fabric.fibres[2].absorption_per_mm = Rgb(500, 90, 2);
  for (size_t k = 0; k < inBands; ++k)
    fabric.fibres[k].absorption_per_mm = Absorption(bell(450 + 90 * static_cast<double>(k), 60));
  return colouringOf(fabric);
}

struct Met {
  PathLight light;
  std::array<float, kMaterials> lengths_mm{};
};

/// Of all kinds, in any order: found by the path or sent by a fibre, with and without a way inside of some fibres.
std::vector<Met> lights(size_t count) {
  Random random(7);
  std::vector<Met> all(count);
  for (Met& met : all) {
    PathLight& light = met.light;
    for (int c = 0; c < 3; ++c) light.radiance[c] = 2 * random.uniform();
    if (random.below(4) > 0) {
      light.material = static_cast<int>(random.below(kMaterials));
      light.traverse_mm = 0.03f * random.uniform() + 1e-4f;
      light.inside = random.uniform();
      for (float& mode : light.modes) mode = random.uniform();
    }
    if (random.below(2) > 0)
      for (float& length : met.lengths_mm) length = random.below(3) > 0 ? 0.2f * random.uniform() : 0;
  }
  return all;
}

/// Calls it for each instruction set that this processor has.
template <class Function>
void onEveryTarget(const Function& function) {
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    function();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// To the bit.
void expectColours(LightBatches& batches, const std::vector<Met>& met, const Colouring& colouring) {
  const std::span<const Rgb> colours = batches.colours();
  ASSERT_EQ(colours.size(), met.size());
  for (size_t i = 0; i < met.size(); ++i)
    ASSERT_EQ(colours[i], colourOf(met[i].light, met[i].lengths_mm, colouring)) << i;
}

// A picture in other colours is the one that would have been traced in them, wherever either was computed.
TEST(LightBatches, GiveEachLightTheColourThatItHasAlone) {
  const std::vector<Met> met = lights(500);
  for (const size_t inBands : {1, 2, 3})
    for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::f11}) {
      SCOPED_TRACE(inBands);
      const Colouring colouring = colouringOf(inBands, lamp);
      onEveryTarget([&] {
        LightBatches batches(colouring, kMaterials);
        for (const Met& one : met) batches.add(one.light, one.lengths_mm);
        expectColours(batches, met, colouring);
      });
    }
}

// Lanes that are not filled hold what was in them before.
TEST(LightBatches, MayBeAskedBeforeTheyAreFull) {
  const Colouring colouring = colouringOf(2, StandardIlluminant::d65);
  const std::vector<Met> met = lights(60);
  LightBatches batches(colouring, kMaterials);
  EXPECT_TRUE(batches.colours().empty());
  for (size_t i = 0; i < met.size(); ++i) {
    batches.add(met[i].light, met[i].lengths_mm);
    if (i % 7 == 0) expectColours(batches, {met.begin(), met.begin() + static_cast<ptrdiff_t>(i) + 1}, colouring);
  }
  expectColours(batches, met, colouring);
}

}  // namespace
}  // namespace loomlight
