#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/live/refinement.h"
#include "render/scene/camera_rays.h"
#include "render/scene/fibre_bricks.h"
#include "tests/support/refining_test.h"
#include "tests/support/watched_medium.h"

namespace loomlight {
namespace {

double pixelSize_mm(const Camera& camera, int width, int height) {
  return CameraRays(camera, width, height).pixelSize_mm(static_cast<float>(camera.distance_mm));
}

class SharedRefinement : public test::RefiningTest {
 protected:
  static constexpr double kSlow_s = 1e-4;  ///< a path: so that it begins coarse

  Refinement sharing() const {
    Refinement refinement(cloth, kWidth, kHeight, {.secondsPerPath = kSlow_s});
    refinement.shareLight(nullptr, {});
    return refinement;
  }

  /// So near that paths at full resolution go among fibres, and no coarse ones.
  Traceable seenCloseUp() const {
    constexpr double kFibres = 1.4;  // in a pixel
    Fabric near = *cloth.scene->fabric;
    near.render.estimator = Estimator::loomlight;
    near.camera.elevation_deg = 70;
    const auto thinnest_mm = static_cast<double>(cloth.scene->cloth->fibres->thinnest_mm());
    near.camera.distance_mm *= kFibres * thinnest_mm / pixelSize_mm(near.camera, kWidth, kHeight);
    const auto scene = test::sceneOf(near);
    return {scene, makeMedium(*scene, 1e9, Task{})};
  }

  /// Seen from elsewhere, and so slow that first fibres take several steps.
  Traceable turnedSlowly(std::chrono::milliseconds slow = std::chrono::milliseconds(40)) const {
    Fabric turned = *cloth.scene->fabric;
    turned.camera.azimuth_deg += 10;
    return {makeScene(std::make_shared<const Fabric>(turned), Task{}, cloth.scene.get()),
            std::make_shared<const test::WatchedMedium>(cloth.medium, [slow](uint64_t path) {
              if (path % 1000 == 1) std::this_thread::sleep_for(slow);
            })};
  }
};

TEST_F(SharedRefinement, TheFilmKnowsNothingOfIt) {
  Refinement shared = sharing(), plain(cloth, kWidth, kHeight, {.secondsPerPath = kSlow_s});
  // How many samples a pass has hangs on how long they take; where they rest does not.
  constexpr uint32_t kEnough = 6;
  for (Refinement* refinement : {&shared, &plain}) {
    refinement->restAt(kEnough);
    refine(*refinement, kEnough);
    ASSERT_EQ(refinement->samples(), kEnough);
  }
  const Frame frame = shared.frame();
  EXPECT_TRUE(frame.shared);
  EXPECT_FALSE(plain.frame().shared);
  EXPECT_EQ(frame.rgba, plain.frame().rgba);
  EXPECT_NE(frame.helped, frame.rgba);
}

TEST_F(SharedRefinement, IsSeenAtFullResolutionBeforeTheFilmIs) {
  Refinement refinement = sharing();
  while (!refinement.frame().shared) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  EXPECT_GT(refinement.divider(), 1);
  const Frame frame = refinement.frame();
  EXPECT_EQ(frame.divider, 1);
  EXPECT_EQ(frame.quality, PreviewQuality::coarse);
  ASSERT_EQ(frame.helped.size(), static_cast<size_t>(kWidth) * kHeight);
  EXPECT_EQ(frame.plain().data(), frame.helped.data());
  EXPECT_EQ(frame.hits.size(), frame.helped.size());
}

// Where an earlier picture stands in, no coarse passes are left, and a fine one takes seconds: it would put the noise
// of its first sample in place of light that is known. First fibres of a tall picture take longer than the time of a
// pass, so they need several of their own; those of a quarter of the pixels are seen first.
TEST_F(SharedRefinement, FirstFibresAreThereBeforeAnyFinePassBegins) {
  constexpr int kTall = 3 * kHeight;
  Refinement before(cloth, kWidth, kTall, {.secondsPerPath = kSlow_s});
  before.shareLight(nullptr, {});
  refine(before, 1);
  Refinement after(turnedSlowly(), kWidth, kTall, {.secondsPerPath = kSlow_s});
  after.shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, *after.scene().fabric));
  after.standIn(std::make_shared<const Frame>(before.frame()));
  after.skipCoarse(3);
  for (const bool whole : {false, true}) {
    do {
      ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
      ASSERT_EQ(after.film().samples(kWidth / 2, kTall / 2), 0u);  // where a pass begins
      EXPECT_EQ(after.isNews() || whole, after.frame().shared);
    } while (!after.isNews());
  }
  EXPECT_GT(after.takeSharedLight()->hits(), 0u);
}

// A view in known light is clearer than coarse passes with the noise of one path a pixel.
TEST_F(SharedRefinement, FirstFibresComeBeforeCoarsePassesWhereLightIsKnown) {
  constexpr int kTall = 3 * kHeight;
  Refinement before(cloth, kWidth, kTall, {.secondsPerPath = kSlow_s});
  before.shareLight(nullptr, {});
  refine(before, 1);
  Refinement after(turnedSlowly(), kWidth, kTall, {.secondsPerPath = 4 * kSlow_s});
  after.shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, *after.scene().fabric));
  after.beginWith({12, 0.1, 3});
  ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  const int first = after.divider();
  ASSERT_GT(first, 2);
  for (const bool whole : {false, true}) {
    do {
      ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
      EXPECT_EQ(after.divider(), first);
      EXPECT_EQ(after.isNews() || whole, after.frame().divider == 1);
    } while (!after.isNews());
  }
  EXPECT_GT(after.takeSharedLight()->hits(), 0u);
}

// The builder of a cloth needs the processor more than pictures of what there is of it.
TEST_F(SharedRefinement, OfASketchThereAreCoarsePassesAlone) {
  Fabric turned = *cloth.scene->fabric;
  turned.weave = turned.weave.with(0, 0, !turned.weave.at(0, 0));
  const Changes edit = changes(*cloth.scene->fabric, turned);
  const Traceable next{test::sceneOf(turned), cloth.medium};
  for (const bool known : {true, false}) {
    Refinement before = sharing();
    refine(before, 1);
    Refinement sketch(next, kWidth, kHeight, {.secondsPerPath = 4 * kSlow_s, .isSketch = true});
    sketch.shareLight(known ? before.takeSharedLight() : nullptr, edit);
    sketch.beginWith({8, 0.3, 3});
    EXPECT_FALSE(sketch.converged());
    int passes = 0;
    for (; !sketch.converged(); ++passes) ASSERT_TRUE(sketch.advance(Task{{}, {}, 1}));
    EXPECT_EQ(sketch.showsKnownLight(), known);
    // It rests, but noise is taken and given back all the same.
    sketch.denoise(true);
    EXPECT_FALSE(sketch.frame().denoised.empty());
    sketch.denoise(false);
    EXPECT_TRUE(sketch.frame().denoised.empty());
    EXPECT_EQ(passes == 1, known) << "in known light one says all";
    EXPECT_EQ(sketch.samples(), 0u);
    EXPECT_EQ(sketch.takeSharedLight()->hits(), 0u);
  }
}

// A patched picture comes to stand in when known light is seen already: the noise of its pixels is not that of these.
TEST_F(SharedRefinement, KnownLightHasNotTheNoiseOfWhatStandsIn) {
  Fabric turned = *cloth.scene->fabric;
  turned.weave = turned.weave.with(0, 0, !turned.weave.at(0, 0));
  Refinement before = sharing();
  refine(before, 1);
  constexpr double kBeginsAtAThird_s = 0.16 / (kWidth * kHeight);
  Refinement sketch({test::sceneOf(turned), cloth.medium}, kWidth, kHeight,
                    {.secondsPerPath = kBeginsAtAThird_s, .isSketch = true});
  sketch.shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, turned));
  sketch.beginWith({8, 0.3, 3});
  while (!sketch.converged()) ASSERT_TRUE(sketch.advance(Task{{}, {}, 1}));
  ASSERT_TRUE(sketch.showsKnownLight());
  ASSERT_EQ(sketch.frame().divider, 1);
  auto patched = std::make_shared<Frame>(before.frame());
  patched->variances.assign(patched->rgba.size(), 1.0f);
  sketch.standIn(patched);
  sketch.denoise(true);
  EXPECT_TRUE(sketch.frame().variances.empty());
}

TEST_F(SharedRefinement, TheFirstPictureOfAMovedViewHasTheDetailOfTheOneBefore) {
  constexpr FirstPass kMoving{12, 0.1, 3};
  Refinement before = sharing();
  refine(before, 1);
  Fabric turned = *cloth.scene->fabric;
  turned.camera.azimuth_deg += 10;
  const Changes edit = changes(*cloth.scene->fabric, turned);
  const Traceable moved{makeScene(std::make_shared<const Fabric>(turned), Task{}, cloth.scene.get()), cloth.medium};
  for (const bool known : {true, false}) {
    Refinement after(moved, kWidth, kHeight, {.secondsPerPath = kSlow_s});
    after.shareLight(known ? before.takeSharedLight() : nullptr, edit);
    after.beginWith(kMoving);
    ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
    const int divider = after.divider();
    ASSERT_GT(divider, 1);
    const Frame frame = after.frame();
    EXPECT_EQ(frame.shared, known);
    EXPECT_EQ(frame.divider, known ? divider / 3 : divider);
    EXPECT_EQ(frame.quality, PreviewQuality::coarse);
    EXPECT_EQ(frame.plain().size(), static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height));
    EXPECT_EQ(frame.hits.size(), frame.plain().size());
    EXPECT_GE(frame.width * frame.divider, kWidth);
    refine(after, 1);  // it goes on from there
    EXPECT_EQ(after.frame().divider, 1);
  }
}

/// Of all that is shown, in linear light.
Rgb meanOf(const Frame& frame) {
  glm::dvec3 sum(0);
  for (const glm::vec4& pixel : frame.plain()) sum += glm::dvec3(pixel);
  return Rgb(sum / static_cast<double>(frame.plain().size()));
}

/// Mean distance of what is shown from the means of a film, in linear light.
double apart(const Frame& frame, const Film& film) {
  double sum = 0;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const auto u = static_cast<size_t>(x / frame.divider), v = static_cast<size_t>(y / frame.divider);
      sum += glm::distance(Rgb(frame.plain()[v * static_cast<size_t>(frame.width) + u]), film.mean(x, y));
    }
  return sum / (film.width() * film.height());
}

// The picture before has 32 samples, so its noise is less than what is lost where one path stands for many pixels.
TEST_F(SharedRefinement, AMovedViewIsAsSharpAsThePictureBefore) {
  Fabric turned = *cloth.scene->fabric;
  turned.camera.azimuth_deg += 5;
  const Traceable moved{makeScene(std::make_shared<const Fabric>(turned), Task{}, cloth.scene.get()), cloth.medium};
  for (const bool sharesLight : {true, false}) {
    SCOPED_TRACE(sharesLight);
    Refinement after(moved, kWidth, kHeight, {.secondsPerPath = kSlow_s}),
        without(moved, kWidth, kHeight, {.secondsPerPath = kSlow_s});
    for (Refinement* one : {&without, &after}) {
      Refinement before(cloth, kWidth, kHeight, {.secondsPerPath = kSlow_s});
      if (sharesLight) before.shareLight(nullptr, {});
      refine(before, 32);
      if (one == &after) after.movedFrom(std::make_shared<const Frame>(before.frame()), cloth.scene->fabric->camera);
      if (sharesLight) one->shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, turned));
      one->beginWith({12, 0.1, 3});
      ASSERT_TRUE(one->advance(Task{{}, {}, 1}));
    }
    const Frame first = after.frame();
    EXPECT_EQ(first.divider, 1);
    EXPECT_EQ(first.samples, 0);
    EXPECT_EQ(first.quality, PreviewQuality::coarse);
    ASSERT_EQ(first.plain().size(), static_cast<size_t>(kWidth) * kHeight);
    EXPECT_FALSE(after.converged());
    while (after.fading()) refine(after, after.samples() + 1);
    EXPECT_EQ(apart(after.frame(), after.film()) == 0, !sharesLight) << "nothing of it is left in the light of paths";
    EXPECT_LT(apart(first, after.film()), apart(without.frame(), after.film()));
  }
}

// A round of them takes a second or more of a large picture: a few at a time are seen as they come, and none is traced
// that no pixel could keep.
TEST_F(SharedRefinement, FirstFibresAreSeenAsTheyCome) {
  Refinement refinement = sharing();
  refinement.restAt(1);  // a quick machine would go on to more in the same pass
  refine(refinement, 1);
  refinement.restAt(2);
  int rounds = 0;
  for (std::vector<glm::vec4> shown = refinement.frame().helped; refinement.samples() < 12;) {
    ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
    std::vector<glm::vec4> now = refinement.frame().helped;
    EXPECT_TRUE(!refinement.isNews() || now != shown);
    rounds += refinement.samples() == 1 && now != shown;
    if (refinement.samples() == 2) refinement.restAt(12);
    shown = std::move(now);
  }
  EXPECT_GE(rounds, 2) << "more than one from four to eight";
}

// Cells are told here that nothing has changed, so that what they say is wrong. Folds are like that: cells that few
// paths have told of mix places that face the light with others. Coarse passes know better, and were seen before.
TEST_F(SharedRefinement, BelievesCoarsePassesUntilTheFirstFineOne) {
  constexpr float kBrighter = 8;
  Fabric bright = *cloth.scene->fabric;
  bright.light.intensity *= kBrighter;
  const Traceable brighter{makeScene(std::make_shared<const Fabric>(bright), Task{}, cloth.scene.get()), cloth.medium};
  Refinement before = sharing(), after(brighter, kWidth, kHeight, {.secondsPerPath = kSlow_s});
  refine(before, 16);
  const Rgb dim = meanOf(before.frame());
  after.shareLight(before.takeSharedLight(), {});
  while (after.divider() != 2 || !after.frame().shared) {
    ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
    ASSERT_EQ(after.samples(), 0u);
  }
  ASSERT_EQ(after.film().samples(kWidth / 2, kHeight / 2), 0u);
  // Some 600 paths are noisy by 2 %; the rest is what blocks of them trust less than they might.
  EXPECT_NEAR(luminance(meanOf(after.frame())) / luminance(dim), kBrighter, 0.2 * kBrighter);
}

// To lay the fibres of a close-up takes seconds: what repeats share learns of two coarse paths for every pixel before,
// and pixels have first fibres accordingly. Once fibres are there, nothing waits for them.
TEST_F(SharedRefinement, CoarsePathsComeBeforeFibresAreLaid) {
  const Traceable closeUp = seenCloseUp();
  const auto& scene = closeUp.scene;
  const Refinement::Options options{.secondsPerPath = kSlow_s, .paths_bytes = size_t{1} << 24};
  const auto coarsePaths = [](const Refinement& refinement) {
    const Film* film = refinement.paths().film;
    return film ? static_cast<int>(film->samples(0, 0)) * film->width() * film->height() : 0;
  };
  Refinement first(closeUp, kWidth, kHeight, options);
  first.shareLight(nullptr, {});
  int paths = 0;
  while (scene->cloth->fibres->made() == 0) {
    paths = coarsePaths(first);
    ASSERT_TRUE(first.advance(Task{{}, {}, 1}));
  }
  EXPECT_GE(paths, 2 * kWidth * kHeight);
  refine(first, 1);

  Refinement second(closeUp, kWidth, kHeight, options);
  second.shareLight(first.takeSharedLight(), {});
  paths = 0;
  while (second.samples() == 0) {
    paths = std::max(paths, coarsePaths(second));
    ASSERT_TRUE(second.advance(Task{{}, {}, 1}));
  }
  EXPECT_LE(paths, kWidth * kHeight / 2) << "of coarse passes of one sample";
}

// Where the first sample waits for fibres, a moved picture that was young would be seen all the while.
TEST_F(SharedRefinement, AMovedCloseUpThatWasYoungGivesWayToCoarsePaths) {
  const Traceable closeUp = seenCloseUp();
  Refinement before(closeUp, kWidth, kHeight, {.secondsPerPath = kSlow_s});
  before.shareLight(nullptr, {});
  while (!before.frame().shared) ASSERT_TRUE(before.advance(Task{{}, {}, 1}));
  Fabric turned = *closeUp.scene->fabric;
  turned.camera.azimuth_deg += 5;
  const auto scene = makeScene(std::make_shared<const Fabric>(turned), Task{}, closeUp.scene.get());
  Refinement after({scene, makeMedium(*scene, 1e9, Task{})}, kWidth, kHeight, {.secondsPerPath = kSlow_s});
  after.movedFrom(std::make_shared<const Frame>(before.frame()), closeUp.scene->fabric->camera);
  after.shareLight(before.takeSharedLight(), changes(*closeUp.scene->fabric, turned));
  after.beginWith({12, 0.1, 3});
  ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  ASSERT_TRUE(after.fading());
  EXPECT_FALSE(after.hasDetail());
  while (!after.hasDetail()) ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  EXPECT_EQ(after.samples(), 0u);
  EXPECT_EQ(scene->cloth->fibres->made(), 0u);
}

// A clear picture says more of another view than cells do; a young one less than they do of paths of this view, but
// more than of few first fibres.
TEST_F(SharedRefinement, AMovedViewThatWasYoungGivesWayToTheFirstSamples) {
  Fabric turned = *cloth.scene->fabric;
  turned.camera.azimuth_deg += 5;
  const Traceable moved{makeScene(std::make_shared<const Fabric>(turned), Task{}, cloth.scene.get()), cloth.medium};
  for (const uint32_t samples : {1u, 32u}) {
    Refinement before = sharing();
    refine(before, samples);
    Refinement after(moved, kWidth, kHeight, {.secondsPerPath = kSlow_s});
    after.movedFrom(std::make_shared<const Frame>(before.frame()), cloth.scene->fabric->camera);
    after.shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, turned));
    after.beginWith({12, 0.1, 3});
    ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
    const Frame first = after.frame();
    EXPECT_FALSE(first.shared);
    EXPECT_EQ(first.divider, 1);
    EXPECT_FALSE(after.hasDetail());
    after.denoise(true);
    const Frame quiet = after.frame();
    ASSERT_EQ(quiet.denoised.size(), quiet.plain().size());
    EXPECT_FALSE(std::equal(quiet.denoised.begin(), quiet.denoised.end(), quiet.plain().begin()));
    after.denoise(false);
    while (!after.frame().shared) ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
    EXPECT_EQ(after.samples(), 0u);
    EXPECT_FALSE(after.hasDetail());
    const Frame shared = after.frame();
    size_t same = 0;
    for (size_t i = 0; i < first.plain().size(); ++i) same += shared.plain()[i] == first.plain()[i];
    EXPECT_GT(same, first.plain().size() / 2) << "where it has seen what is seen now";
    EXPECT_LT(same, first.plain().size());
    // Coarse passes bring light to cells, and are not seen.
    while (after.divider() > 1) {
      ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
      EXPECT_EQ(after.frame().divider, 1);
    }
    refine(after, 1);
    EXPECT_EQ(after.hasDetail(), samples == 1);
  }
}

// A coarse pass of the cloth itself would be seen for a moment, between a sketch of it and light that is shared.
TEST_F(SharedRefinement, ASketchInKnownLightIsSeenUntilLightIsShared) {
  constexpr int kTall = 3 * kHeight;
  // No hits are had in the time of one pass, however long ago it was asked for.
  const Traceable moved = turnedSlowly(std::chrono::milliseconds(150));
  Refinement before(cloth, kWidth, kTall, {.secondsPerPath = kSlow_s});
  before.shareLight(nullptr, {});
  refine(before, 1);
  Refinement sketch(moved, kWidth, kTall, {.secondsPerPath = 10 * kSlow_s, .isSketch = true});
  sketch.shareLight(before.takeSharedLight(), changes(*cloth.scene->fabric, *moved.scene->fabric));
  sketch.beginWith({12, 0.1, 3});
  while (!sketch.converged()) ASSERT_TRUE(sketch.advance(Task{{}, {}, 1}));
  ASSERT_TRUE(sketch.showsKnownLight());
  Refinement after(moved, kWidth, kTall, {.secondsPerPath = 10 * kSlow_s});
  after.shareLight(sketch.takeSharedLight(), {});
  auto shown = std::make_shared<Frame>(sketch.frame());
  shown->quality = PreviewQuality::sketch;
  after.standIn(shown);
  after.skipCoarse(sketch.divider());
  const Frame first = after.frame();
  EXPECT_TRUE(first.shared);
  const auto showsTheSketch = [&] { return std::ranges::equal(after.frame().plain(), first.plain()); };
  while (after.divider() == sketch.divider()) ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  EXPECT_TRUE(showsTheSketch()) << "a coarse pass is seen";
  while (showsTheSketch()) ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  EXPECT_EQ(after.samples(), 0u) << "light is shared before any fine pass";
  for (const int divider = after.divider(); after.divider() == divider;) ASSERT_TRUE(after.advance(Task{{}, {}, 1}));
  EXPECT_NE(after.frame().quality, PreviewQuality::sketch) << "nothing is left of it";
}

TEST_F(SharedRefinement, ServesVolumesOnEveryDrape) {
  EXPECT_TRUE(SharedLight::serves(*cloth.scene, kWidth, kHeight));
  Fabric bent = *cloth.scene->fabric, fibres = bent;
  bent.drape.kind = DrapeKind::cylinder;
  EXPECT_TRUE(SharedLight::serves(*test::sceneOf(bent), kWidth, kHeight));
  fibres.render.method = Method::fibres;
  EXPECT_FALSE(SharedLight::serves(*test::sceneOf(fibres), kWidth, kHeight));
}

}  // namespace
}  // namespace loomlight
