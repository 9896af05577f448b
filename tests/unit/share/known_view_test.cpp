#include "render/share/known_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/scene/camera_rays.h"
#include "render/share/shared_light.h"
#include "render/transport/make_medium.h"
#include "tests/support/open_cloth.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kFiner = 3;  // pixels of the known view for one of the coarse film, each way

/// Two views of one cloth: light is known from the one, and the other is to be seen.
class KnownViewTest : public testing::Test {
 protected:
  static constexpr int kWidth = 48, kHeight = 30;
  static constexpr PixelRect kCoarse{0, 0, kWidth / kFiner, kHeight / kFiner};

  static Task threads(int count) {
    Task task;
    task.threads = count;
    return task;
  }
  static std::shared_ptr<const Scene> sceneAt(LightKind light, double azimuth_deg) {
    Fabric fabric = test::whiteCotton();
    if (light != LightKind::furnace) darkenWeft(fabric);
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 8;
    fabric.camera.azimuth_deg += azimuth_deg;
    fabric.light.kind = light;
    return test::sceneOf(fabric);
  }

  static void darkenWeft(Fabric& fabric) {
    fabric.fibres.push_back(fabric.fibres[0]);
    fabric.fibres[1].absorption_per_mm = Rgb(40, 30, 20);
    fabric.yarns.push_back(fabric.yarns[0]);
    fabric.yarns[1].fibre = 1;
    fabric.weftSequence = {1};
  }

  void lookFirst(LightKind light) {
    const auto scene = sceneAt(light, 0);
    medium_ = makeMedium(*scene, 1e9, Task{});
    known_ = std::make_unique<SharedLight>(scene, medium_, kWidth, kHeight);
    Film film(kWidth, kHeight);
    renderUpTo(4, *scene, *medium_, CameraRays(scene->fabric->camera, kWidth, kHeight), film, threads(2),
               {.first = known_->listener(0, 1)});
    known_->settle();
    scene_ = sceneAt(light, 20);
    known_->moveTo(scene_, medium_, kWidth, kHeight, changes(*scene->fabric, *scene_->fabric));
  }
  Film trace(int width, int height, uint32_t samples, int divider = 1) const {
    Film film(width, height);
    const CameraRays camera(scene_->fabric->camera, kWidth, kHeight, divider);
    renderUpTo(samples, *scene_, *medium_, camera, film, threads(2));
    return film;
  }
  CoarseFilm traceCoarse(uint32_t samples) const {
    return {trace(kCoarse.width, kCoarse.height, samples, kFiner), kFiner};
  }

  std::shared_ptr<const Scene> scene_;  ///< of the second view
  std::shared_ptr<const Medium> medium_;
  std::unique_ptr<SharedLight> known_;
};

// Even than one without noise: it has their detail.
TEST_F(KnownViewTest, IsNearerToTheViewThanAFilmOfFewerPixels) {
  lookFirst(LightKind::dome);
  const Film coarse = traceCoarse(64).film, wanted = trace(kWidth, kHeight, 64);
  const auto view = known_->known(traceCoarse(1), kFiner, threads(2));
  ASSERT_TRUE(view);
  double ofKnown = 0, ofCoarse = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Rgb known = view->picture.light[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)];
      const Rgb fromKnown = known - wanted.mean(x, y);
      const Rgb fromCoarse = coarse.mean(x / kFiner, y / kFiner) - wanted.mean(x, y);
      ofKnown += glm::dot(fromKnown, fromKnown);
      ofCoarse += glm::dot(fromCoarse, fromCoarse);
    }
  EXPECT_LT(ofKnown, ofCoarse);
}

TEST_F(KnownViewTest, IsTheSameFromAnyNumberOfThreadsAndKnowsItsCrossings) {
  lookFirst(LightKind::sky);
  const CoarseFilm coarse = traceCoarse(1);
  const auto one = known_->known(coarse, kFiner, threads(1)), three = known_->known(coarse, kFiner, threads(3));
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->picture.light, three->picture.light);
  EXPECT_EQ(one->picture.alpha, three->picture.alpha);
  EXPECT_EQ(one->picture.variances, three->picture.variances);
  for (size_t i = 0; i < one->hits.size(); ++i) {
    EXPECT_EQ(one->hits[i].end, three->hits[i].end);
    if (one->hits[i].end >= 0) {
      EXPECT_GT(one->picture.alpha[i], 0);
    }
  }
}

// Also where the last of the coarse ones reach beyond the view.
TEST_F(KnownViewTest, EachOfItsPixelsIsAPartOfACoarseOne) {
  constexpr int kDivider = 9, kColumns = 6, kRows = 4;  // 54 x 36 of 48 x 30
  lookFirst(LightKind::dome);
  const auto view = known_->known({trace(kColumns, kRows, 1, kDivider), kDivider}, kFiner, threads(2));
  ASSERT_TRUE(view);
  const Film same = trace(kFiner * kColumns, kFiner * kRows, 1, kDivider / kFiner);
  ASSERT_EQ(view->hits.size(), size_t{kFiner * kColumns} * (kFiner * kRows));
  for (int y = 0; y < same.height(); ++y)
    for (int x = 0; x < same.width(); ++x) {
      const Film::Hit& hit = view->hits[static_cast<size_t>(y) * kFiner * kColumns + static_cast<size_t>(x)];
      EXPECT_EQ(hit.end, same.hit(x, y).end) << x << ", " << y;
      EXPECT_EQ(hit.pick, same.hit(x, y).pick) << x << ", " << y;
    }
}

TEST_F(KnownViewTest, OfAWhiteFurnaceIsWhite) {
  lookFirst(LightKind::furnace);
  const auto view = known_->known(traceCoarse(1), kFiner, threads(2));
  ASSERT_TRUE(view);
  for (size_t i = 0; i < view->picture.light.size(); ++i) {
    EXPECT_NEAR(view->picture.light[i].r, view->picture.alpha[i], 1e-5);
    EXPECT_NEAR(view->picture.light[i].b, view->picture.alpha[i], 1e-5);
  }
}

TEST_F(KnownViewTest, IsNoneWhenStopped) {
  lookFirst(LightKind::dome);
  std::stop_source source;
  source.request_stop();
  Task task = threads(2);
  task.stop = source.get_token();
  EXPECT_FALSE(known_->known({Film(kCoarse.width, kCoarse.height), kFiner}, kFiner, task));
}

// One ray through a pixel of open cloth goes through it or does not; the pixels around tell how much of it is seen.
TEST(KnownView, OfAnOpenClothHasNoDots) {
  constexpr int kSide = 32;
  const auto scene = test::sceneOf(test::farAndOpen());
  const auto medium = makeMedium(*scene, 1e9, Task{});
  Film film(kSide, kSide);
  renderUpTo(64, *scene, *medium, CameraRays(scene->fabric->camera, kSide, kSide), film, Task{});
  const auto view =
      knownView(*scene, *medium, CellSums(), CameraRays(scene->fabric->camera, kSide, kSide), kSide, kSide, Task{});
  ASSERT_TRUE(view);
  double open = 0, apart2 = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float alpha = view->picture.alpha[static_cast<size_t>(y) * kSide + static_cast<size_t>(x)];
      open += (1.0 - film.alpha(x, y)) / (kSide * kSide);
      apart2 += std::pow(alpha - film.alpha(x, y), 2) / (kSide * kSide);
    }
  ASSERT_GT(open, 0.1);
  ASSERT_LT(open, 0.9);
  // Of one ray the variance is open (1 - open), and dots have half of their contrast where it is a quarter of that.
  EXPECT_LT(apart2, open * (1 - open) / 4);
}

// Satin shines where it did not: the film of few pixels knows, and tells the finer picture.
TEST(BrightenTo, MovesSheenToWhereItIsNow) {
  constexpr int kSide = 32;
  SharedPicture picture(kFiner * kSide, kFiner * kSide);
  std::ranges::fill(picture.light, Rgb(0.2f));
  std::ranges::fill(picture.alpha, 1.0f);
  std::ranges::fill(picture.variances, 0.04f);
  Film coarse(kSide, kSide);
  Random random(7);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      PathSample sample;
      sample.alpha = 1;
      const float mean = x < kSide / 2 ? 0.2f : 0.8f;
      sample.direct = random.below(2) == 0 ? Rgb(0) : Rgb(2 * mean);
      coarse.add(x, y, 0, sample);
    }
  brightenTo(picture, coarse, kFiner, 1);
  double matt = 0, shiny = 0;
  constexpr size_t kQuarter = kFiner * kSide / 4, kRow = size_t{kFiner} * kSide;
  for (size_t y = 0; y < kRow; ++y)
    for (size_t x = 0; x < kQuarter; ++x) {
      matt += picture.light[y * kRow + x].r / (kRow * kQuarter);
      shiny += picture.light[y * kRow + kRow - 1 - x].r / (kRow * kQuarter);
    }
  // Within a quarter of the cells' error, which was 0.6 there and nothing here.
  EXPECT_NEAR(matt, 0.2, 0.15);
  EXPECT_NEAR(shiny, 0.8, 0.15);
}

}  // namespace
}  // namespace loomlight
