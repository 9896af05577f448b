#include "render/display/recolour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/colour/spectrum.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kSide = 32;
constexpr size_t kPixels = size_t{kSide} * kSide;

Fabric blueCotton() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 8;
  fabric.fibres[0].absorption_per_mm = Rgb(60, 20, 4);
  return fabric;
}

Fabric withColour(Fabric fabric, Rgb absorption_per_mm) {
  fabric.fibres[0].absorption_per_mm = absorption_per_mm;
  return fabric;
}

Recolouring recolouringOf(const Scene& scene) {
  return {scene.colouring, Rgb(1)};
}

/// A picture of a scene, with the paths of some of its samples.
class RecolouredPicture {
 public:
  RecolouredPicture(const Fabric& fabric, uint32_t samples, size_t bytesPerPixel)
      : RecolouredPicture(test::sceneOf(fabric), samples, bytesPerPixel) {}
  RecolouredPicture(std::shared_ptr<const Scene> of, uint32_t samples, size_t bytesPerPixel)
      : scene(std::move(of)), records(kSide, kSide, 1, kPixels * bytesPerPixel) {
    const auto medium = makeMedium(*scene, 1e9, Task{});
    const CameraRays camera(scene->fabric->camera, kSide, kSide);
    for (uint32_t upTo = 1; upTo <= samples; upTo *= 2)
      renderUpTo(upTo, *scene, *medium, camera, film, Task{}, {.records = &records});
  }
  Rgb mean() const {
    Rgb sum(0);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) sum += film.mean(x, y);
    return sum / float{kPixels};
  }
  std::shared_ptr<const Scene> scene;
  Film film{kSide, kSide};
  PathRecords records;
};

Rgb at(const Recoloured& picture, int x, int y) {
  return Rgb(picture.rgba[static_cast<size_t>(y) * kSide + x]);
}

Rgb meanOf(const Recoloured& picture) {
  Rgb sum(0);
  for (const glm::vec4& pixel : picture.rgba) sum += Rgb(pixel);
  return sum / float{kPixels};
}

double squaredError(const Recoloured& picture, const Film& truth) {
  double sum = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Rgb error = at(picture, x, y) - truth.mean(x, y);
      sum += glm::dot(error, error);
    }
  return sum;
}

std::optional<Recolouring> recolouringTo(const Scene& traced, const Fabric& wanted) {
  const SceneBase base{&traced, changes(*traced.fabric, wanted)};
  return recolouringBetween(traced, *makeScene(std::make_shared<const Fabric>(wanted), Task{}, base), base.edit);
}

TEST(RecolouringBetween, IsKnownForColourAndBrightnessAlone) {
  const auto blue = test::sceneOf(blueCotton());
  const auto red = test::sceneOf(withColour(blueCotton(), Rgb(1, 50, 60)));
  const auto recolouring = recolouringTo(*blue, *red->fabric);
  ASSERT_TRUE(recolouring);
  EXPECT_EQ(recolouring->colouring.primaries_per_mm[0], Rgb(1, 50, 60));
  EXPECT_EQ(recolouring->light, Rgb(1));

  const auto after = [&](auto&& edit) {
    Fabric fabric = blueCotton();
    edit(fabric);
    return recolouringTo(*blue, fabric);
  };
  EXPECT_EQ(after([](Fabric& f) { f.light.intensity *= 3; })->light, Rgb(3));
  EXPECT_EQ(after([](Fabric& f) { f.light.temperature_K = 2700; })->light, blackBodyTint(2700));
  EXPECT_TRUE(after([](Fabric& f) { f.name = "other"; }));
  EXPECT_FALSE(after([](Fabric& f) { f.light.turbidity += 1; }));
  EXPECT_FALSE(after([](Fabric& f) { f.camera.distance_mm += 1; }));
  EXPECT_FALSE(after([](Fabric& f) { f.fibres[0].refractiveIndex += 0.05; }));
  EXPECT_FALSE(after([](Fabric& f) { f.yarns[0].plyTwist_per_m += 50; }));
  EXPECT_FALSE(after([](Fabric& f) { f.weave = f.weave.with(0, 0, !f.weave.at(0, 0)); }));
  EXPECT_FALSE(after([](Fabric& f) { f.render.seed += 1; }));
}

TEST(Recolour, InTheSameColoursIsTheFilm) {
  const RecolouredPicture blue(blueCotton(), 16, 800);
  const Recoloured same = recolour(blue.film, blue.records, recolouringOf(*blue.scene), 2);
  ASSERT_LT(blue.records.samples(16, 16), 16u);
  double change = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      change = std::max(change, double{glm::length(at(same, x, y) - blue.film.mean(x, y))});
  EXPECT_LT(change, 1e-3);  // the coefficient is one but for the rounding of sums of squares
}

// Half of the samples on record say how noisy all of them are: no less than the luminance of the pixels' own samples
// scatters, and no more than it would were the channels' noise one and the same. Both means are known to the scatter of
// their pixels, and from half of the samples to as much again in square.
TEST(Recolour, KnowsItsNoise) {
  Fabric underDome = blueCotton();
  underDome.light.kind = LightKind::dome;
  constexpr uint32_t kSamples = 16;
  const RecolouredPicture blue(underDome, kSamples, 300);
  ASSERT_GE(blue.records.samples(16, 16), kSamples / 2);  // how many there is room for hangs on who is first
  ASSERT_LT(blue.records.samples(16, 16), kSamples);
  const auto medium = makeMedium(*blue.scene, 1e9, Task{});
  const CameraRays camera(underDome.camera, kSide, kSide);
  constexpr double kLuminance[] = {0.2126, 0.7152, 0.0722};
  TraceCounts counts;
  test::SampledMean least, most;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      test::SampledMean channels[3];
      for (uint32_t i = 0; i < kSamples; ++i) {
        const PathSample sample = tracePath(*blue.scene, *medium, camera, x, y, i, counts);
        for (int c = 0; c < 3; ++c) channels[c].add((sample.direct + sample.indirect)[c]);
      }
      double upper = 0;  // (sum w s)^2 <= sum w s^2, of weights that add up to one
      for (int c = 0; c < 3; ++c) upper += kLuminance[c] * channels[c].variance() / kSamples;
      least.add(blue.film.variance(x, y));
      most.add(upper);
    }
  const Recoloured same = recolour(blue.film, blue.records, recolouringOf(*blue.scene), 2);
  const double noise = 3.3 * std::sqrt(2);
  EXPECT_GT(same.variance, least.mean() - noise * least.standardError());
  EXPECT_LT(same.variance, most.mean() + noise * most.standardError());
}

TEST(Recolour, UnderBrighterLampsIsTheFilmBrighter) {
  const RecolouredPicture blue(blueCotton(), 16, 800);
  Recolouring recolouring = recolouringOf(*blue.scene);
  recolouring.light = Rgb(4);
  const Recoloured bright = recolour(blue.film, blue.records, recolouring, 1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) EXPECT_LT(glm::length(at(bright, x, y) - 4.0f * blue.film.mean(x, y)), 4e-3f);
}

// A lamp of another colour: nothing is estimated, whatever the record holds, and the paths would be the same.
TEST(Recolour, UnderAWarmLampIsThePictureTracedUnderIt) {
  Fabric warm = blueCotton();
  warm.light.temperature_K = 2700;
  const RecolouredPicture neutral(blueCotton(), 8, 800), traced(warm, 8, 800);
  const auto recolouring = recolouringTo(*neutral.scene, warm);
  ASSERT_TRUE(recolouring);
  ASSERT_GT(recolouring->light.r, 2 * recolouring->light.b);
  const Recoloured warmed = recolour(neutral.film, neutral.records, *recolouring, 1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Rgb expected = traced.film.mean(x, y);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(at(warmed, x, y)[c], expected[c], 1e-4f * (1 + expected[c]));
    }
}

// With all samples on record nothing is estimated: it is the picture that the same paths bring in the other colours.
TEST(Recolour, OfPathsAllOnRecordIsExact) {
  const RecolouredPicture blue(blueCotton(), 4, 1 << 14);
  const Recolouring recolouring{{{Rgb(1, 50, 60)}}, Rgb(1)};
  Scene inRed = *blue.scene;
  inRed.colouring = recolouring.colouring;  // its paths end where those of the blue one do
  const RecolouredPicture red(std::make_shared<const Scene>(inRed), 4, 0);
  const Recoloured recoloured = recolour(blue.film, blue.records, recolouring, 1);
  constexpr float kQuantum = 0x1p-24f;  // of the film, whose sums are rounded
  double change = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      ASSERT_EQ(blue.records.samples(x, y), 4u);
      const Rgb expected = red.film.mean(x, y);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(at(recoloured, x, y)[c], expected[c], 1e-6f * expected[c] + 2 * kQuantum);
      change += glm::length(expected - blue.film.mean(x, y));
    }
  EXPECT_GT(change, 1) << "the colours are others";
}

// Few paths on record, many in the film: what is not on record counts too, and the picture knows how good it is.
TEST(Recolour, UsesTheSamplesThatAreNotOnRecord) {
  const Fabric redder = withColour(blueCotton(), Rgb(25, 24, 6));
  Fabric other = redder;
  other.render.seed = 77;
  const RecolouredPicture truth(other, 128, 0);
  const RecolouredPicture many(blueCotton(), 64, 800), few(blueCotton(), 4, 800);
  ASSERT_LT(many.records.samples(0, 0), 16u);
  const Recolouring recolouring = recolouringOf(*truth.scene);
  const Recoloured fromMany = recolour(many.film, many.records, recolouring, 2);
  const Recoloured fromFew = recolour(few.film, few.records, recolouring, 2);
  EXPECT_LT(squaredError(fromMany, truth.film), 0.5 * squaredError(fromFew, truth.film));
  EXPECT_LT(fromMany.variance, 0.25 * fromFew.variance);
}

// Lighter than what was traced, whose paths ended earlier: those that went on speak for those that did not. The ratio
// of two such pictures differs by 1.6 % from seed to seed (standard deviation): the bound is 3.5 of that of their mean.
TEST(Recolour, OfADarkClothInLighterColoursIsUnbiased) {
  const Fabric dark = withColour(blueCotton(), Rgb(30, 20, 15)), pale = withColour(blueCotton(), Rgb(15, 10, 8));
  Fabric dome = dark;
  dome.light.kind = LightKind::dome;
  Fabric paleDome = pale;
  paleDome.light.kind = LightKind::dome;
  constexpr int kPairs = 8;
  Rgb ratio(0);
  for (int pair = 0; pair < kPairs; ++pair) {
    dome.render.seed = 2 * pair;
    paleDome.render.seed = 2 * pair + 1;
    const RecolouredPicture traced(dome, 32, 1 << 14), truth(paleDome, 64, 0);
    ratio += meanOf(recolour(traced.film, traced.records, recolouringOf(*truth.scene), 2)) / truth.mean() / Rgb(kPairs);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1, 0.02);
}

}  // namespace
}  // namespace loomlight
