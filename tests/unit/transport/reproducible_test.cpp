#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "render/media/volume_medium.h"
#include "render/transport/colour_patch.h"
#include "render/transport/path_integrator.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"

namespace loomlight {
namespace {

constexpr int kWidth = 37, kHeight = 23;  // no multiple of a tile

Fabric dyedCotton() {
  Fabric fabric = test::whiteCotton();
  fabric.fibres[0].absorption_per_mm = Rgb(30.0f, 10.0f, 3.0f);
  fabric.light.kind = LightKind::sky;
  return fabric;
}

void expectSame(const Film& a, const Film& b) {
  const Image x = a.toImage(true), y = b.toImage(true);
  ASSERT_EQ(x.channels.size(), y.channels.size());
  for (size_t c = 0; c < x.channels.size(); ++c) EXPECT_EQ(x.channels[c].values, y.channels[c].values);
}

class ReproducibleFilm : public testing::Test {
 protected:
  Film render(uint32_t samples, int threads, uint32_t first = 0) const {
    Film film(kWidth, kHeight);
    Task task;
    task.threads = threads;
    renderUpTo(samples, *scene_, VolumeMedium(scene_->cloth), camera_, film, task, {.firstSample = first});
    return film;
  }
  std::shared_ptr<const Scene> scene_ = test::sceneOf(dyedCotton());
  CameraRays camera_{dyedCotton().camera, kWidth, kHeight};
};

class ReproducibleMedium : public testing::TestWithParam<test::MediumKind> {};

/// The report's estimator with tables of its own, baked by so many threads; any other medium as it is made.
std::unique_ptr<const Medium> made(const test::MediumKind& kind, const Scene& scene, int threads) {
  if (kind.estimator != Estimator::report) return kind.make(scene, threads);
  const BvdfOptions few{{4, 4, 8, 16}, 100'000};
  const BvdfCache none{std::filesystem::path()};
  return std::make_unique<const ReportMedium>(scene.cloth, bakeBvdf(*scene.fabric, few, none, Task{{}, {}, threads}));
}

// From the fabric on: scene, fibres, tables of visibility and samples are all made by so many threads.
TEST_P(ReproducibleMedium, ForAnyNumberOfThreads) {
  Fabric fabric = dyedCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 5;
  fabric.drape.radius_mm = 2;
  fabric.camera.distance_mm = 9;
  fabric.yarns[0].count_tex = 10;
  fabric.render.resolution = 4;
  GetParam().askFor(fabric);
  for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder}) {
    fabric.drape.kind = drape;
    if (drape != DrapeKind::flat && GetParam().extent == FibreExtent::oneRepeat) continue;
    const auto rendered = [&](int threads) {
      const Task task{{}, {}, threads};
      const auto scene = makeScene(std::make_shared<const Fabric>(fabric), task);
      const auto medium = made(GetParam(), *scene, threads);
      Film film(kWidth, kHeight);
      renderUpTo(6, *scene, *medium, CameraRays(fabric.camera, kWidth, kHeight), film, task);
      return film;
    };
    const Film one = rendered(1);
    expectSame(one, rendered(2));
    expectSame(one, rendered(3));
  }
}

// Two materials and a lamp, so that paths are sorted by what they meet; as many under way as there is place for.
TEST_P(ReproducibleMedium, HoweverManyPathsAreUnderWayAtOnce) {
  Fabric fabric = dyedCotton();
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].refractiveIndex = 1.7;
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.weftSequence = {1};
  GetParam().askFor(fabric);
  const auto scene = test::sceneOf(fabric);
  const auto medium = made(GetParam(), *scene, 1);
  const CameraRays camera(fabric.camera, kWidth, kHeight);
  std::vector<PixelSample> wanted;
  for (uint32_t i = 0; i < 40; ++i)
    for (int x = 0; x < 12; ++x) wanted.push_back({12 + x, 11, i, nullptr});
  const auto coloursOf = [&](size_t most) {
    PathTracer tracer(*scene, *medium, camera, most);
    TraceCounts counts;
    EXPECT_TRUE(tracer.trace(wanted, counts));
    std::vector<Rgb> colours;
    for (size_t i = 0; i < wanted.size(); ++i) colours.push_back(tracer.sample(i).direct + tracer.sample(i).indirect);
    return std::pair(colours, counts.events);
  };
  const auto [alone, events] = coloursOf(1);
  EXPECT_GT(events, wanted.size());
  EXPECT_EQ(coloursOf(5), std::pair(alone, events));
  EXPECT_EQ(coloursOf(PathIntegrator::kBatch), std::pair(alone, events));
}

INSTANTIATE_TEST_SUITE_P(Every, ReproducibleMedium,
                         testing::Values(test::kPlain, test::kReportsLaw, test::kReport, test::kLoomlight,
                                         test::kLoomlightAtRandom, test::kFibres, test::kFibresAtRandom,
                                         test::kFibresOfOneRepeat, test::kFibresInBricks),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(ReproducibleFilm, ForAnySplitOfTheSamples) {
  const Film whole = render(6, 2);
  Film split = render(2, 1);
  split.merge(render(4, 3, 2));
  expectSame(whole, split);
}

TEST_F(ReproducibleFilm, WhenContinued) {
  Film film = render(2, 2);
  Task task;
  task.threads = 2;
  renderUpTo(6, *scene_, VolumeMedium(scene_->cloth), camera_, film, task);
  expectSame(film, render(6, 1));
}

TEST_F(ReproducibleFilm, WithAnotherSeedIsAnother) {
  Fabric other = dyedCotton();
  other.render.seed = 2;
  const Film a = render(2, 1);
  scene_ = test::sceneOf(other);
  EXPECT_NE(a.toImage(false).find("G")->values, render(2, 1).toImage(false).find("G")->values);
}

/// Two seeds that follow each other make two independent measurements, not one in another order.
TEST(Seeds, ThatAreCountedUpShareNoWalks) {
  const auto lengthsOf = [](uint64_t seed) {
    Fabric fabric = dyedCotton();
    fabric.render.seed = seed;
    const auto patch = makeColourPatch(fabric, {});
    std::vector<float> lengths_mm =
        tallyPathLengths(*patch->scene, *patch->medium, wholePiece(), 2 * PathIntegrator::kBatch, {})->lengths_mm;
    std::sort(lengths_mm.begin(), lengths_mm.end());
    return lengths_mm;
  };
  const auto even = lengthsOf(2), odd = lengthsOf(3);
  std::vector<float> shared;
  std::set_intersection(even.begin(), even.end(), odd.begin(), odd.end(), std::back_inserter(shared));
  // Lengths of no path at all are 0 in both.
  EXPECT_LT(std::count_if(shared.begin(), shared.end(), [](float length_mm) { return length_mm > 0; }),
            static_cast<ptrdiff_t>(even.size() / 100));
}

}  // namespace
}  // namespace loomlight
