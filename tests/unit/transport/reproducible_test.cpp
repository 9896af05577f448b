#include <gtest/gtest.h>

#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kWidth = 37, kHeight = 23;  // no multiple of a tile

class ReproducibleFilm : public testing::Test {
 protected:
  static Fabric fabric() {
    Fabric f = test::whiteCotton();
    f.fibres[0].absorption_per_mm = Rgb(30.0f, 10.0f, 3.0f);
    f.light.kind = LightKind::sky;
    return f;
  }
  Film render(uint32_t samples, int threads, uint32_t first = 0) const {
    Film film(kWidth, kHeight);
    Task task;
    task.threads = threads;
    renderUpTo(samples, *scene_, VolumeMedium(*scene_), camera_, film, task, first);
    return film;
  }
  static void expectSame(const Film& a, const Film& b) {
    const Image x = a.toImage(true), y = b.toImage(true);
    ASSERT_EQ(x.channels.size(), y.channels.size());
    for (size_t c = 0; c < x.channels.size(); ++c) EXPECT_EQ(x.channels[c].values, y.channels[c].values);
  }
  std::shared_ptr<const Scene> scene_ = test::sceneOf(fabric());
  CameraRays camera_{fabric().camera, kWidth, kHeight};
};

TEST_F(ReproducibleFilm, ForAnyNumberOfThreads) {
  const Film one = render(6, 1);
  expectSame(one, render(6, 2));
  expectSame(one, render(6, 3));
}

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
  renderUpTo(6, *scene_, VolumeMedium(*scene_), camera_, film, task);
  expectSame(film, render(6, 1));
}

TEST_F(ReproducibleFilm, WithAnotherSeedIsAnother) {
  Fabric other = fabric();
  other.render.seed = 2;
  const Film a = render(2, 1);
  scene_ = test::sceneOf(other);
  EXPECT_NE(a.toImage(false).find("G")->values, render(2, 1).toImage(false).find("G")->values);
}

TEST_F(ReproducibleFilm, StopsWithinAPath) {
  // The stop comes from the sampled work itself: after it, each thread may finish the path that it is on, no more.
  std::stop_source stop;
  stop.request_stop();
  Film film(kWidth, kHeight);
  Task task;
  task.threads = 2;
  task.stop = stop.get_token();
  const PassResult result = renderUpTo(4, *scene_, VolumeMedium(*scene_), camera_, film, task);
  EXPECT_FALSE(result.complete);
  EXPECT_LE(result.counts.paths, 2u);
}

}  // namespace
}  // namespace loomlight
