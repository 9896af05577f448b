#include "render/transport/light_lanes.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <map>

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
      light.internalReflectance = random.uniform();
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

/// Lights on record, each of a sample of its own.
class Recorded {
 public:
  explicit Recorded(const std::vector<Met>& met) {
    for (uint32_t i = 0; i < met.size(); ++i) {
      const Met& one = met[i];
      const LightColumns::Kind kind = LightColumns::kindOf(one.light, one.lengths_mm);
      LightColumns& lights = kinds_.try_emplace(kind, kind, kMaterials).first->second;
      EXPECT_TRUE(lights.add(one.light, one.lengths_mm, i, budget));
    }
  }
  /// These, to the bit.
  void expect(const std::vector<Met>& met, const Colouring& colouring) const {
    std::vector<Rgb> colours(met.size(), Rgb(0));
    for (const auto& [kind, lights] : kinds_) addColours(lights, colouring, Rgb(1), colours);
    for (size_t i = 0; i < met.size(); ++i)
      ASSERT_EQ(colours[i], colourOf(met[i].light, met[i].lengths_mm, colouring)) << i;
  }
  void renumber(const std::vector<uint32_t>& numbers) {
    for (auto& [kind, lights] : kinds_) lights.renumber(numbers, budget);
  }
  RecordBudget budget{size_t{1} << 20};

 private:
  std::map<LightColumns::Kind, LightColumns> kinds_;
};

// A picture in other colours is the one that would have been traced in them, wherever either was computed.
TEST(LightColumns, GiveEachLightTheColourThatItHasAlone) {
  const std::vector<Met> met = lights(500);
  const Recorded recorded(met);
  for (const size_t inBands : {0, 1, 2, 3})
    for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::f11}) {
      SCOPED_TRACE(inBands);
      const Colouring colouring = colouringOf(inBands, lamp);
      onEveryTarget([&] { recorded.expect(met, colouring); });
    }
}
TEST(LightColumns, ForgetTheLightsOfSamplesThatAreDropped) {
  const std::vector<Met> met = lights(500);
  Recorded recorded(met);
  const size_t before = recorded.budget.taken();
  std::vector<Met> kept;
  std::vector<uint32_t> numbers;
  for (size_t i = 0; i < met.size(); ++i) {
    const bool isKept = i % 3 == 0;
    numbers.push_back(isKept ? static_cast<uint32_t>(kept.size()) : LightColumns::kNone);
    if (isKept) kept.push_back(met[i]);
  }
  recorded.renumber(numbers);
  recorded.expect(kept, colouringOf(2, StandardIlluminant::d65));
  EXPECT_LT(recorded.budget.taken(), before / 2);
  recorded.renumber(std::vector<uint32_t>(kept.size(), LightColumns::kNone));
  EXPECT_EQ(recorded.budget.taken(), 0u);
}

TEST(LightColumns, LampsThatShineBrighterAddInProportion) {
  const Met one = lights(1)[0];
  RecordBudget budget(size_t{1} << 20);
  LightColumns lights(LightColumns::kindOf(one.light, one.lengths_mm), kMaterials);
  ASSERT_TRUE(lights.add(one.light, one.lengths_mm, 0, budget));
  Rgb colour(0), brighter(0);
  const Colouring colouring = colouringOf(1, StandardIlluminant::d65);
  addColours(lights, colouring, Rgb(1), {&colour, 1});
  addColours(lights, colouring, Rgb(4), {&brighter, 1});  // a power of two: exact
  ASSERT_NE(colour, Rgb(0));
  EXPECT_EQ(brighter, 4.0f * colour);
}

}  // namespace
}  // namespace loomlight
