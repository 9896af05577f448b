#include <gtest/gtest.h>

#include <atomic>

#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"
#include "tests/support/watched_medium.h"

namespace loomlight {
namespace {

TEST(Cancel, LetsEachThreadFinishTheRoundThatItIsIn) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const CameraRays camera(scene->fabric->camera, 64, 48);
  for (const int threads : {1, 2, 3})
    for (const int flight : {1, 1000, 10000}) {
      std::stop_source source;
      std::atomic<uint64_t> flownAfter{0};
      // Asks for a stop in the middle of a flight, and counts the flights after it.
      const test::WatchedMedium medium(
          std::make_shared<const VolumeMedium>(scene->cloth), [](uint64_t) {},
          [&](uint64_t flown) {
            if (source.stop_requested()) ++flownAfter;
            if (flown == static_cast<uint64_t>(flight)) source.request_stop();
          });
      Film film(64, 48);
      Task task;
      task.stop = source.get_token();
      task.threads = threads;
      EXPECT_FALSE(renderUpTo(64, *scene, medium, camera, film, task).complete);
      // Each thread looks before every round, in which each path of its batch flies once.
      EXPECT_LT(flownAfter, static_cast<uint64_t>(threads) * PathIntegrator::kBatch);
    }
}

// A stopped batch leaves nothing of itself: what the film has are whole samples, those that it would have anyway.
TEST(Cancel, LeavesWholeSamplesOnly) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const CameraRays camera(scene->fabric->camera, 64, 48);
  const auto volume = std::make_shared<const VolumeMedium>(scene->cloth);
  Film whole(64, 48), stopped(64, 48);
  ASSERT_TRUE(renderUpTo(1, *scene, *volume, camera, whole, oneThread()).complete);
  std::stop_source source;
  const test::WatchedMedium medium(volume, [&](uint64_t path) {
    if (path == 64 * 48 / 2) source.request_stop();
  });
  Task task = oneThread();
  task.stop = source.get_token();
  EXPECT_FALSE(renderUpTo(1, *scene, medium, camera, stopped, task).complete);
  int samples = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      if (stopped.samples(x, y) == 0) continue;
      ++samples;
      EXPECT_EQ(stopped.samples(x, y), 1u);
      EXPECT_EQ(stopped.mean(x, y), whole.mean(x, y));
    }
  EXPECT_GT(samples, 0);
  EXPECT_LT(samples, 64 * 48 / 2);
}

}  // namespace
}  // namespace loomlight
