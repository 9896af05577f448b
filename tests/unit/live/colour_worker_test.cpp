#include "app/live/colour_worker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/fabric/model/booth_lamps.h"
#include "render/scene/colouring.h"
#include "render/transport/dye_paths.h"
#include "tests/support/narrow_dye.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

Fabric dyedCotton() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.fibres[0].absorption_per_mm = Absorption(test::narrowDye(40));
  fabric.render.observer = Observer::degrees2;  // the picture's: it has no say where dyers judge
  return fabric;
}

Spectrum grey() {
  Spectrum reflectance;
  reflectance.fill(0.3f);
  reflectance[kBands - 5] = 0.5f;
  return reflectance;
}

class ColourJudged : public testing::Test {
 protected:
  std::vector<LampJudgement> judgementsOf(const Fabric& fabric, std::optional<Spectrum> measured) {
    ColourWish wish{
        .fabric = std::make_shared<const Fabric>(fabric), .part = wholePiece(), .wanted = {}, .measured = measured};
    if (!measured) wish.wanted = Rgb(0.3f);
    wish.number = ++number;
    worker.request(wish);
    EXPECT_TRUE(window.waitFor([&] { return worker.newest() && worker.newest()->wish.number == number; }));
    return worker.newest()->judgements;
  }
  test::WorkerWindow window;
  ColourWorker worker{window.waker()};
  uint64_t number = 0;
};

// What the standard looks like is known without any cloth: a judgement under another lamp, or by another observer, is
// found out by it.
TEST_F(ColourJudged, UnderTheClothsLampFirstAndThenUnderTheOthersOfTheBooth) {
  for (const StandardIlluminant own :
       {StandardIlluminant::d65, StandardIlluminant::a, StandardIlluminant::f2, StandardIlluminant::blackBody}) {
    Fabric fabric = dyedCotton();
    fabric.light.illuminant = own;
    fabric.light.temperature_K = 4000;
    const std::vector<LampJudgement> judgements = judgementsOf(fabric, grey());
    const bool isOfBooth = std::find(kBoothLamps.begin(), kBoothLamps.end(), own) != kBoothLamps.end();
    ASSERT_EQ(judgements.size(), kBoothLamps.size() + (isOfBooth ? 0 : 1));
    EXPECT_EQ(judgements[0].lamp, own);
    for (const StandardIlluminant lamp : kBoothLamps)
      EXPECT_EQ(std::count_if(judgements.begin(), judgements.end(), [&](const auto& j) { return j.lamp == lamp; }), 1);
    for (const LampJudgement& judgement : judgements) {
      Light light = fabric.light;
      light.illuminant = judgement.lamp;
      const Lab expected = labUnder(tristimulusWeights(illuminantOf(light), Observer::degrees10), grey());
      EXPECT_EQ(judgement.judgement.standard.L, expected.L);
      EXPECT_EQ(judgement.judgement.standard.a, expected.a);
      EXPECT_EQ(judgement.judgement.standard.b, expected.b);
      EXPECT_GT(judgement.judgement.cmc, 1) << "this cloth is no grey";
      if (judgement.lamp == kBoothLamps.front()) {
        EXPECT_NEAR(judgement.judgement.metamerism, 0, 1e-6);
      }
    }
  }
}

// White is out of reach: it is come near to under the cloth's lamp, and another lamp has another nearest.
TEST_F(ColourJudged, WhatCannotBeHadIsNearestUnderTheClothsLamp) {
  Spectrum pink;
  for (size_t j = 0; j < kBands; ++j) pink[j] = j > 22 ? 1.0f : 0.75f;
  std::vector<SolvedReflectance> solved;
  for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::f11}) {
    Fabric fabric = dyedCotton();
    fabric.light.illuminant = lamp;
    judgementsOf(fabric, pink);
    ASSERT_TRUE(worker.newest()->matched);
    solved.push_back(*worker.newest()->matched);
    EXPECT_GT(solved.back().tooLight, 0u);
  }
  const auto off = [&](const char* lamp, const SolvedReflectance& of) {
    const TristimulusWeights weights = tristimulusWeights(illuminantNamed(lamp), Observer::degrees10);
    return ciede2000(labUnder(weights, pink), labUnder(weights, of.reached));
  };
  EXPECT_NE(solved[0].reached, solved[1].reached);
  EXPECT_LE(off("D65", solved[0]), off("D65", solved[1]) + 0.1) << "but for what smoothness is worth";
  EXPECT_LE(off("F11", solved[1]), off("F11", solved[0]) + 0.1);
}

TEST_F(ColourJudged, SaysHowWellTheColourIsKnown) {
  judgementsOf(dyedCotton(), grey());
  EXPECT_GT(worker.newest()->error, 0);
  EXPECT_LT(worker.newest()->error, 1.1 * kLiveDyeError);
}

// Once it is dyed as measured there is nothing left to judge.
TEST_F(ColourJudged, AClothThatReflectsAsMeasuredMatchesUnderEveryLamp) {
  Fabric fabric = dyedCotton();
  judgementsOf(fabric, grey());
  ASSERT_TRUE(worker.newest()->matched);
  fabric.fibres[0].absorption_per_mm = Absorption(worker.newest()->matched->absorption_per_mm);
  for (const LampJudgement& judgement : judgementsOf(fabric, grey())) EXPECT_LT(judgement.judgement.cmc, 0.1);
}

TEST_F(ColourJudged, NotBesideAColourWithoutASpectrum) {
  EXPECT_TRUE(judgementsOf(dyedCotton(), {}).empty());
}

TEST_F(ColourJudged, ALampThatCannotBeReadCostsTheColourNothing) {
  Fabric fabric = dyedCotton();
  fabric.light.illuminant = StandardIlluminant::file;
  fabric.light.illuminantFile = "no such lamp.txt";
  EXPECT_TRUE(judgementsOf(fabric, grey()).empty());
  EXPECT_TRUE(worker.newest()->seen);
  EXPECT_EQ(worker.error(), "");
}

}  // namespace
}  // namespace loomlight
