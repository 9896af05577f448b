#include <gtest/gtest.h>

#include <atomic>

#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// A medium that asks for a stop in the middle of a path, and counts the paths that set out after it.
class StoppingMedium : public Medium {
 public:
  StoppingMedium(const Scene& scene, int stopAtPath) : medium_(scene.cloth), stopAtPath_(stopAtPath) {}

  std::optional<Collision> collide(const Departure& from, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const override {
    if (from.events == 0) {
      if (source_.stop_requested()) ++begunAfter_;
      if (++begun_ == stopAtPath_) source_.request_stop();
    }
    return medium_.collide(from, direction, random, counts);
  }
  float transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const override {
    return medium_.transmittance(from, direction, distance, random, counts);
  }
  Departure leave(const Collision& collision, glm::vec3 wi, int order) const override {
    return medium_.leave(collision, wi, order);
  }

  std::stop_token token() const { return source_.get_token(); }
  int begunAfter() const { return begunAfter_; }

 private:
  VolumeMedium medium_;
  int stopAtPath_;
  mutable std::stop_source source_;
  mutable std::atomic<int> begun_{0}, begunAfter_{0};
};

TEST(Cancel, LetsEachThreadFinishThePathThatItIsOn) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const CameraRays camera(scene->fabric->camera, 64, 48);
  for (const int threads : {1, 2, 3})
    for (const int path : {1, 100, 1000}) {
      const StoppingMedium medium(*scene, path);
      Film film(64, 48);
      Task task;
      task.stop = medium.token();
      task.threads = threads;
      const PassResult result = renderUpTo(64, *scene, medium, camera, film, task);
      EXPECT_FALSE(result.complete);
      EXPECT_LE(medium.begunAfter(), threads - 1);  // the stop came between another's look and its setting out
      EXPECT_LE(result.counts.paths, static_cast<uint64_t>(path + threads - 1));
    }
}

}  // namespace
}  // namespace loomlight
