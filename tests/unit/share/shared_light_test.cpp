#include "render/share/shared_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/media/close_up_medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/fibre_bricks.h"
#include "render/transport/make_medium.h"
#include "tests/support/open_cloth.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

constexpr int kWidth = 48, kHeight = 32;

Fabric cloth(LightKind light) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 8;
  fabric.light.kind = light;
  return fabric;
}

Fabric dyed(Fabric fabric) {
  fabric.fibres[0].absorption_per_mm = Rgb(4, 2, 1);
  return fabric;
}

Task threads(int count) {
  Task task;
  task.threads = count;
  return task;
}

/// A picture as the editor makes it.
struct Picture {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Medium> medium;
  std::unique_ptr<SharedLight> light;
  Film film{kWidth, kHeight};
  std::vector<CoarseFilm> coarse;

  explicit Picture(const Fabric& fabric) : scene(test::sceneOf(fabric)), medium(makeMedium(*scene, 1e9, Task{})) {
    light = std::make_unique<SharedLight>(scene, medium, kWidth, kHeight);
  }
  void trace(uint32_t samples, int threadCount) {
    const CameraRays camera(scene->fabric->camera, kWidth, kHeight);
    renderUpTo(samples, *scene, *medium, camera, film, threads(threadCount), {.first = light->listener(0, 1)});
    light->settle();
  }
  std::vector<glm::vec4> shown(int threadCount) const { return light->picture(film, coarse, threadCount); }
};

/// Of what is cloth.
Rgb meanOf(const std::vector<glm::vec4>& picture) {
  glm::dvec4 sum(0);
  for (const glm::vec4& pixel : picture) sum += glm::dvec4(pixel);
  return Rgb(glm::dvec3(sum) / sum.a);
}

// To lay the fibres of a close-up takes seconds, and cells are voxels: a single fibre tells nothing more.
TEST(SharedLight, LaysNoFibresToFindCells) {
  Fabric near = cloth(LightKind::dome);
  near.render.estimator = Estimator::loomlight;
  near.camera.elevation_deg = 70;
  near.camera.distance_mm = 0.7;
  Picture picture(near);
  ASSERT_NE(picture.scene->cloth->fibres, nullptr);
  ASSERT_TRUE(picture.light->addHits(2, threads(1)));
  EXPECT_EQ(picture.light->hits(), 2u);
  EXPECT_EQ(picture.scene->cloth->fibres->made(), 0u);
  picture.trace(1, 1);
  EXPECT_GT(picture.scene->cloth->fibres->made(), 0u) << "paths of the film go among them";
}

// From afar no path goes among fibres, and very close by coarse ones do as well.
TEST(SharedLight, WaitsForFibresThatOnlyFinePathsGoAmong) {
  Fabric fabric = cloth(LightKind::dome);
  fabric.render.estimator = Estimator::loomlight;
  const float thinnest_mm = test::sceneOf(fabric)->cloth->fibres->thinnest_mm();
  const CameraRays camera(fabric.camera, kWidth, kHeight);
  const double distancePerPixel = 1 / camera.pixelSize_mm(1);
  for (const auto& [fibres, waits] :
       {std::pair(0.9, false), std::pair(1.1, true), std::pair(1.9, true), std::pair(2.1, false)}) {
    Fabric near = fabric;
    near.camera.distance_mm = fibres * thinnest_mm * distancePerPixel;
    Picture picture(near);
    EXPECT_EQ(picture.light->waitsForFibres(), waits) << fibres << " fibres in a pixel";
    picture.light->wholeSampleTraced();
    EXPECT_FALSE(picture.light->waitsForFibres());
    const auto other = test::sceneOf(near);  // whose fibres are others
    picture.light->moveTo(other, makeMedium(*other, 1e9, Task{}), kWidth, kHeight, {});
    EXPECT_EQ(picture.light->waitsForFibres(), waits);
    picture.light->moveTo(picture.scene, picture.medium, kWidth, kHeight, {});
    EXPECT_EQ(picture.light->waitsForFibres(), waits) << "others have been laid since";
  }
}

// A whole sample from afar lays none, so that the first close-up waits for them.
TEST(SharedLight, WaitsForFibresThatWereNotSeenFromAfar) {
  Fabric fabric = cloth(LightKind::dome);
  fabric.render.estimator = Estimator::loomlight;
  Picture picture(fabric);
  picture.light->wholeSampleTraced();
  Fabric near = fabric;
  const float thinnest_mm = picture.scene->cloth->fibres->thinnest_mm();
  near.camera.distance_mm = 1.4 * thinnest_mm / CameraRays(fabric.camera, kWidth, kHeight).pixelSize_mm(1);
  const auto scene = makeScene(std::make_shared<const Fabric>(near), Task{}, picture.scene.get());
  ASSERT_EQ(scene->cloth->fibres, picture.scene->cloth->fibres);
  picture.light->moveTo(scene, makeMedium(*scene, 1e9, Task{}), kWidth, kHeight, changes(fabric, near));
  EXPECT_TRUE(picture.light->waitsForFibres());
}

TEST(SharedLight, IsTheSameFromAnyNumberOfThreads) {
  std::vector<glm::vec4> first;
  for (const int count : {1, 3}) {
    Fabric fabric = dyed(cloth(LightKind::sky));
    fabric.drape.kind = DrapeKind::cylinder;
    fabric.drape.radius_mm = 2;
    Picture picture(fabric);
    ASSERT_TRUE(picture.light->addHits(2, threads(count)));
    picture.trace(2, count);
    ASSERT_TRUE(picture.light->addHits(5, threads(count)));
    // Half of the picture has samples at a half of the resolution alone.
    picture.coarse.push_back({Film(kWidth / 2, kHeight / 2), 2});
    PathSample sample;
    sample.alpha = 1;
    for (int y = 0; y < kHeight / 2; ++y)
      for (int x = 0; x < kWidth / 2; ++x) {
        sample.direct = Rgb(0.02f * static_cast<float>(x));
        picture.coarse[0].film.add(x, y, 0, sample);
      }
    Film upper(kWidth, kHeight);
    upper.merge(picture.film.cropped({0, 0, kWidth, kHeight / 2}));
    picture.film = std::move(upper);
    if (count == 1)
      first = picture.shown(1);
    else
      EXPECT_EQ(picture.shown(count), first);
  }
}

// A pixel whose rays all go through a cloth that is open around it shows some of what they miss.
TEST(SharedLight, OfAWhiteFurnaceIsExactlyWhite) {
  Fabric open = test::farAndOpen();
  open.fibres[0].absorption_per_mm = Rgb(0.0f);
  open.light.kind = LightKind::furnace;
  for (const Fabric& fabric : {cloth(LightKind::furnace), open}) {
    Picture picture(fabric);
    ASSERT_TRUE(picture.light->addHits(2, threads(2)));
    picture.trace(1, 2);
    for (const glm::vec4& pixel : picture.shown(2)) {
      EXPECT_NEAR(pixel.r, pixel.a, 1e-5);
      EXPECT_NEAR(pixel.b, pixel.a, 1e-5);
    }
  }
}

TEST(SharedLight, KeepsTheMeanOfTheFilm) {
  Fabric crop = dyed(cloth(LightKind::dome));
  crop.camera.distance_mm = 5;
  Picture picture(crop);
  ASSERT_TRUE(picture.light->addHits(8, threads(2)));
  picture.trace(96, 2);
  const std::vector<glm::vec4> shared = picture.shown(2);
  std::vector<glm::vec4> film;
  picture.film.toDisplayBuffer(film);
  const Rgb mean = meanOf(shared), wanted = meanOf(film);
  // With few paths the rare and dark cells of gaps are drawn towards brighter ones; here a cell has some hundred.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / wanted[c], 1, 0.01);
}

// Two rays through a pixel of open cloth leave dots of what is behind it; the pixels around know as much of its
// openings.
TEST(SharedLight, OfAnOpenClothHasNoDots) {
  const Fabric far = test::farAndOpen();
  Picture picture(far), converged(far);
  ASSERT_TRUE(picture.light->addHits(2, threads(2)));
  picture.trace(1, 2);
  converged.trace(64, 2);
  std::vector<glm::vec4> film;
  converged.film.toDisplayBuffer(film);
  double open = 0;
  for (const glm::vec4& pixel : film) open += (1.0 - pixel.a) / static_cast<double>(film.size());
  ASSERT_GT(open, 0.1);
  ASSERT_LT(open, 0.9);
  double apart2 = 0;
  const std::vector<glm::vec4> shown = picture.shown(2);
  for (size_t i = 0; i < film.size(); ++i)
    apart2 += std::pow(shown[i].a - film[i].a, 2) / static_cast<double>(film.size());
  // Of three rays of one pixel the variance is open (1 - open) / 3. Here it is a quarter of that at most, so that dots
  // have half of their contrast or less.
  EXPECT_LT(apart2, open * (1 - open) / 3 / 4);
}

TEST(FirstHits, GoThroughTheClothOrPastIt) {
  for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder}) {
    Fabric fabric = test::openCloth();
    fabric.drape.kind = drape;
    fabric.drape.radius_mm = 60;  // hardly bent
    fabric.drape.width_mm = fabric.drape.height_mm = 20;
    fabric.camera.elevation_deg = 90;
    fabric.camera.distance_mm =
        120;  // 42 mm are seen from top to bottom, and the cloth lies in the middle half of them
    const auto scene = test::sceneOf(fabric);
    const auto medium = makeMedium(*scene, 1e9, Task{});
    CellSums cells;
    FirstHits hits(kWidth, kHeight);
    ASSERT_TRUE(hits.trace(8, *scene, *medium, cells, threads(2)));
    int through = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const glm::vec2 fromMiddle = glm::abs(glm::vec2(x, y) + 0.5f - glm::vec2(kWidth, kHeight) / 2.0f);
        const float farther = std::max(fromMiddle.x, fromMiddle.y);  // the edge is 7.6 pixels away
        for (const uint32_t hit : hits.of(x, y)) {
          if (farther < 5) {
            EXPECT_NE(hit, FirstHits::kPast) << x << ", " << y;
          } else if (farther > 10) {
            EXPECT_EQ(hit, FirstHits::kPast) << x << ", " << y;
          }
          through += hit == FirstHits::kThrough;
        }
      }
    EXPECT_GT(through, 8) << "the rays of one pixel: the cloth is open";
  }
}

TEST(FirstHits, OfAQuarterOfThePixelsStandForTheOthersUntilTheseHaveTheirOwn) {
  const auto scene = test::sceneOf(cloth(LightKind::dome));
  const auto medium = makeMedium(*scene, 1e9, Task{});
  CellSums cells, cellsAtOnce;
  FirstHits hits(kWidth, kHeight), atOnce(kWidth, kHeight);
  ASSERT_TRUE(atOnce.trace(2, *scene, *medium, cellsAtOnce, threads(2)));
  EXPECT_EQ(atOnce.perPixel(), 2u);

  constexpr double kOneHour_s = 3600;
  ASSERT_TRUE(hits.trace(2, *scene, *medium, cells, threads(2), kOneHour_s));
  EXPECT_TRUE(hits.standForAll());
  EXPECT_EQ(hits.perPixel(), 0u);
  const auto seen = [&](int x, int y) {
    std::vector<uint32_t> all;
    hits.forEachSeen(x, y, [&](uint32_t hit) { all.push_back(hit); });
    return all;
  };
  const auto first = [&](int x, int y) { return atOnce.of(x, y)[0]; };
  for (int y = 2; y < kHeight - 2; y += 2)
    for (int x = 2; x < kWidth - 2; x += 2) {
      SCOPED_TRACE(testing::Message() << x << ", " << y);
      EXPECT_THAT(seen(x, y), ElementsAre(first(x, y)));
      EXPECT_THAT(seen(x + 1, y), ElementsAre(first(x, y), first(x + 2, y)));
      EXPECT_THAT(seen(x, y + 1), ElementsAre(first(x, y), first(x, y + 2)));
      EXPECT_THAT(seen(x + 1, y + 1), ElementsAre(first(x, y), first(x + 2, y), first(x, y + 2), first(x + 2, y + 2)));
    }
  EXPECT_THAT(seen(kWidth - 1, kHeight - 1), ElementsAre(first(kWidth - 2, kHeight - 2))) << "where none are beyond";

  ASSERT_TRUE(hits.trace(2, *scene, *medium, cells, threads(2), kOneHour_s));
  EXPECT_EQ(hits.perPixel(), 2u);
  int other = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_THAT(seen(x, y), ElementsAreArray(atOnce.of(x, y))) << x << ", " << y;
      ASSERT_EQ(hits.of(x, y).size(), 2u);
      other += hits.of(x, y)[0] != hits.of(x / 2 * 2, y / 2 * 2)[0];
    }
  EXPECT_GT(other, kWidth * kHeight / 4) << "most pixels do not show what those beside them show";
}

TEST(SharedLight, ShowsAPictureOfAQuarterOfThePixelsFirst) {
  Picture picture(cloth(LightKind::dome));
  EXPECT_FALSE(picture.light->shows());
  picture.trace(1, 2);
  picture.film = Film(kWidth, kHeight);
  picture.light->moveTo(picture.scene, picture.medium, kWidth, kHeight, Changes{Stage::camera, {}, {}});
  EXPECT_FALSE(picture.light->shows());
  ASSERT_TRUE(picture.light->addHits(1, threads(2), 3600));
  EXPECT_EQ(picture.light->hits(), 0u);
  ASSERT_TRUE(picture.light->shows());
  for (const glm::vec4& pixel : picture.shown(2)) EXPECT_GT(pixel.a, 0);
}

/// How much nearer a picture of one sample is to a converged one, where light is shared: a share of squared errors.
double errorOfSharedOverFilm(const Fabric& fabric) {
  Picture picture(fabric), converged(fabric);
  if (!picture.light->addHits(2, threads(2))) return INFINITY;
  picture.trace(1, 2);
  const CameraRays camera(converged.scene->fabric->camera, kWidth, kHeight);
  renderUpTo(64, *converged.scene, *converged.medium, camera, converged.film, threads(2), {.firstSample = 1});
  std::vector<glm::vec4> film, wanted;
  picture.film.toDisplayBuffer(film);
  converged.film.toDisplayBuffer(wanted);
  const std::vector<glm::vec4> shared = picture.shown(2);
  double ofFilm = 0, ofShared = 0;
  for (size_t i = 0; i < wanted.size(); ++i) {
    ofFilm += glm::dot(Rgb(film[i] - wanted[i]), Rgb(film[i] - wanted[i]));
    ofShared += glm::dot(Rgb(shared[i] - wanted[i]), Rgb(shared[i] - wanted[i]));
  }
  return ofShared / ofFilm;
}

TEST(SharedLight, IsClearerThanTheFilmThatItIsMadeOf) {
  EXPECT_LT(errorOfSharedOverFilm(dyed(cloth(LightKind::dome))), 0.25);
}

// Cells are voxels, which blur fibres that an eye sees one by one; but less than noise does.
TEST(SharedLight, IsClearerThanTheFilmAmongExplicitFibresToo) {
  Fabric near = dyed(cloth(LightKind::dome));
  near.camera.distance_mm = 1.4;
  const auto scene = test::sceneOf(near);
  ASSERT_EQ(closeUpChance(*scene->cloth, CameraRays(near.camera, kWidth, kHeight).pixelSize_mm(1.4f)), 1);
  ASSERT_TRUE(SharedLight::serves(*scene, kWidth, kHeight));
  EXPECT_LT(errorOfSharedOverFilm(near), 0.25);
}

TEST(SharedLight, ServesNoPictureWhoseVoxelsAreBlocks) {
  Fabric fabric = cloth(LightKind::sky);
  fabric.camera.distance_mm = 20;
  EXPECT_TRUE(SharedLight::serves(*test::sceneOf(fabric), kWidth, kHeight));
  EXPECT_FALSE(SharedLight::serves(*test::sceneOf(fabric), 100 * kWidth, 100 * kHeight));
  fabric.camera.distance_mm = 0.2;
  EXPECT_FALSE(SharedLight::serves(*test::sceneOf(fabric), kWidth, kHeight));
}

TEST(SharedLight, AnEditLeavesWhatIsStillSo) {
  using Cells = SharedFate::Cells;
  const Fabric before = dyed(cloth(LightKind::sky));
  const auto fate = [&](auto&& edit) {
    Fabric after = before;
    edit(after);
    return sharedFate(changes(before, after));
  };
  EXPECT_EQ(fate([](Fabric& f) { f.name = "other"; }), (SharedFate{Cells::live, true}));
  EXPECT_EQ(fate([](Fabric& f) { f.camera.azimuth_deg += 5; }), (SharedFate{Cells::prior, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.weave = f.weave.with(0, 0, !f.weave.at(0, 0)); }),
            (SharedFate{Cells::prior, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.light.azimuth_deg += 5; }), (SharedFate{Cells::places, true}));
  EXPECT_EQ(fate([](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(9); }), (SharedFate{Cells::places, true}));
  EXPECT_EQ(fate([](Fabric& f) { f.yarns[0].plyTwist_per_m += 50; }), (SharedFate{Cells::likely, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.drape.kind = DrapeKind::cylinder; }), (SharedFate{Cells::likely, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.ends_per_cm += 1; }), (SharedFate{Cells::likely, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.yarns[0].plyTwist_per_m += 50, f.light.azimuth_deg += 5; }),
            (SharedFate{Cells::none, false}));
  EXPECT_EQ(fate([](Fabric& f) { f.drape.kind = DrapeKind::cylinder, f.fibres[0].absorption_per_mm = Rgb(9); }),
            (SharedFate{Cells::none, false}));
}

TEST(SharedLight, GoesOnAfterAnEdit) {
  const Fabric before = dyed(cloth(LightKind::sky));
  Picture picture(before);
  ASSERT_TRUE(picture.light->addHits(2, threads(2)));
  picture.trace(1, 2);
  const auto moveTo = [&](const Fabric& after) {
    const auto scene = makeScene(std::make_shared<const Fabric>(after), Task{}, picture.scene.get());
    picture.light->moveTo(scene, picture.medium, kWidth, kHeight, changes(*picture.scene->fabric, after));
    picture.scene = scene;
  };
  Fabric brighter = before;
  brighter.light.azimuth_deg += 90;
  moveTo(brighter);
  EXPECT_EQ(picture.light->hits(), 2u);  // pixels show what they showed
  EXPECT_FALSE(picture.light->shows());  // but nobody knows yet in which light
  picture.film = Film(kWidth, kHeight);
  picture.trace(1, 2);
  EXPECT_TRUE(picture.light->shows());
  Fabric turned = brighter;
  turned.camera.azimuth_deg += 10;
  moveTo(turned);
  EXPECT_EQ(picture.light->hits(), 0u);
  ASSERT_TRUE(picture.light->addHits(1, threads(2)));
  EXPECT_TRUE(picture.light->shows());  // in the light of before
  Fabric finer = turned;
  finer.render.resolution *= 2;
  moveTo(finer);
  ASSERT_TRUE(picture.light->addHits(1, threads(2)));
  EXPECT_FALSE(picture.light->shows());  // voxels of another size are other places
}

// What a place's key is made of may change without any voxel: then pixels look for their cells anew.
// In a large window the first picture may fill the cells, and a drag begins with what it knows all the same.
TEST(SharedLight, OfFullCellsSomeStayWhenTheViewMoves) {
  constexpr size_t kSmall_bytes = size_t{1} << 15;
  Picture picture(cloth(LightKind::dome));
  picture.light = std::make_unique<SharedLight>(picture.scene, picture.medium, kWidth, kHeight, kSmall_bytes);
  picture.trace(4, 2);
  ASSERT_TRUE(picture.light->knows());
  Fabric turned = *picture.scene->fabric;
  turned.camera.azimuth_deg += 20;
  const auto scene = test::sceneOf(turned);
  picture.light->moveTo(scene, picture.medium, kWidth, kHeight, changes(*picture.scene->fabric, turned));
  EXPECT_TRUE(picture.light->knows());
}

TEST(SharedLight, PixelsLookForTheirCellsWhereKeysHaveChanged) {
  Fabric before = dyed(cloth(LightKind::sky));
  before.fibres.resize(2, before.fibres[0]);
  const auto hitsAfter = [&](auto&& edit) {
    Picture picture(before);
    EXPECT_TRUE(picture.light->addHits(1, threads(2)));
    Fabric after = before;
    edit(after);
    const auto scene = makeScene(std::make_shared<const Fabric>(after), Task{}, picture.scene.get());
    picture.light->moveTo(scene, picture.medium, kWidth, kHeight, changes(before, after));
    return picture.light->hits();
  };
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.fibres[0].refractiveIndex += 0.1; }), 1u);
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.yarns[0].shadeVariation_percent = 5; }), 0u);
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.yarns[0].fibre = 1; }), 0u);
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.yarns[0].blendFibre = 1; }), 0u);
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.light.kind = LightKind::headlight; }), 0u);
  EXPECT_EQ(hitsAfter([](Fabric& f) { f.render.estimator = Estimator::none; }), 0u);
}

TEST(SharedLight, HitsComeInBandsWhereThereIsLittleTime) {
  Fabric fabric = cloth(LightKind::sky);
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  const auto scene = test::sceneOf(fabric);
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  constexpr int kNarrow = 4, kTall = 200;
  SharedLight whole(scene, medium, kNarrow, kTall), inBands(scene, medium, kNarrow, kTall);
  ASSERT_TRUE(whole.addHits(2, threads(2)));
  EXPECT_EQ(whole.hits(), 2u);
  ASSERT_TRUE(inBands.addHits(2, threads(2), 0));
  EXPECT_EQ(inBands.hits(), 0u) << "no round is done before its last row";
  int calls = 1;
  for (; inBands.hits() < 2 && calls < 100; ++calls) ASSERT_TRUE(inBands.addHits(2, threads(2), 0));
  EXPECT_EQ(inBands.hits(), 2u);
  EXPECT_GT(calls, 2);
}

}  // namespace
}  // namespace loomlight
