#include <gtest/gtest.h>

#include <atomic>

#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"
#include "tests/support/watched_medium.h"

namespace loomlight {
namespace {

TEST(Cancel, LetsEachThreadFinishThePathThatItIsOn) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const CameraRays camera(scene->fabric->camera, 64, 48);
  for (const int threads : {1, 2, 3})
    for (const int path : {1, 100, 1000}) {
      std::stop_source source;
      std::atomic<int> begunAfter{0};
      // Asks for a stop in the middle of a path, and counts the paths that set out after it.
      const test::WatchedMedium medium(std::make_shared<const VolumeMedium>(scene->cloth), [&](uint64_t begun) {
        if (source.stop_requested()) ++begunAfter;
        if (begun == static_cast<uint64_t>(path)) source.request_stop();
      });
      Film film(64, 48);
      Task task;
      task.stop = source.get_token();
      task.threads = threads;
      const PassResult result = renderUpTo(64, *scene, medium, camera, film, task);
      EXPECT_FALSE(result.complete);
      EXPECT_LE(begunAfter, threads - 1);  // the stop came between another's look and its setting out
      EXPECT_LE(result.counts.paths, static_cast<uint64_t>(path + threads - 1));
    }
}

}  // namespace
}  // namespace loomlight
