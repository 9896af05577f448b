#include "app/live/tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <latch>
#include <new>

#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"
#include "tests/support/watched_medium.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

using test::WatchedMedium;

constexpr int kTraceWidth = 96, kTraceHeight = 72;  // a cloth of unknown speed begins at half of this resolution

// What is shown while a cloth is built has been answered already: the cloth itself goes on from there, and may be
// stopped like any later pass.
TEST(Tracer, TheSamePictureBetterGoesOnFromACoarseOneAndCanBeStopped) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 8;
  const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});

  std::atomic<bool> coarseShown = false;
  std::latch builtSent(1), builtBegun(1), editSent(1);
  const auto sketch = std::make_shared<const WatchedMedium>(medium, [&](uint64_t) {
    if (coarseShown) builtSent.wait();
  });
  const auto built = std::make_shared<const WatchedMedium>(medium, [&](uint64_t path) {
    if (path > 1) return;
    builtBegun.count_down();
    editSent.wait();
  });
  test::WorkerWindow window;
  Tracer tracer(
      [&, wake = window.waker()] {
        coarseShown = true;
        wake();
      },
      1);
  tracer.show({{scene, sketch}, kTraceWidth, kTraceHeight, 1});
  ASSERT_TRUE(window.waitFor([&] { return tracer.frame() != nullptr; }));
  ASSERT_GT(tracer.frame()->divider, 1);
  tracer.show({{scene, built}, kTraceWidth, kTraceHeight, 1});
  builtSent.count_down();
  builtBegun.wait();
  tracer.show({{scene, medium}, kTraceWidth, kTraceHeight, 2});
  editSent.count_down();
  ASSERT_TRUE(window.waitFor([&] { return tracer.frame()->generation == 2; }));
  EXPECT_LE(built->paths(), PathIntegrator::kBatch) << "no path set out but with the one that was held up";
}

TEST(Tracer, TheSamePictureBetterIsNeverCoarser) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  std::atomic<bool> coarseShown = false;
  std::latch builtSent(1);
  const auto sketch = std::make_shared<const WatchedMedium>(medium, [&](uint64_t) {
    if (coarseShown) builtSent.wait();
  });
  test::WorkerWindow window;
  std::vector<int> dividers;  // the tracer's thread writes it until it is gone
  {
    std::function<std::shared_ptr<const Frame>()> newest;
    Tracer tracer(
        [&, wake = window.waker()] {
          dividers.push_back(newest()->divider);
          coarseShown = true;
          wake();
        },
        1);
    newest = [&] { return tracer.frame(); };
    tracer.show({{scene, sketch}, kTraceWidth, kTraceHeight, 1});
    ASSERT_TRUE(window.waitFor([&] { return tracer.frame() != nullptr; }));
    tracer.show({{scene, medium}, kTraceWidth, kTraceHeight, 1});
    builtSent.count_down();
    ASSERT_TRUE(window.waitFor([&] { return tracer.frame()->samples > 0; }));
  }
  EXPECT_GT(dividers.front(), 1);
  EXPECT_TRUE(std::is_sorted(dividers.rbegin(), dividers.rend()));
}

TEST(Tracer, AnotherSizeOfTheViewportKeepsWhatWasSeen) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  test::WorkerWindow window;
  std::vector<int> dividers;  // the tracer's thread writes it until it is gone
  {
    std::function<std::shared_ptr<const Frame>()> newest;
    Tracer tracer(
        [&, wake = window.waker()] {
          if (const auto frame = newest(); frame && frame->generation == 2) dividers.push_back(frame->divider);
          wake();
        },
        1);
    newest = [&] { return tracer.frame(); };
    tracer.show({{scene, medium}, kTraceWidth, kTraceHeight, 1});
    ASSERT_TRUE(window.waitFor([&] { return tracer.frame() && tracer.frame()->samples > 1; }));
    tracer.show({{scene, medium}, 2 * kTraceWidth, kTraceHeight, 2});
    ASSERT_TRUE(window.waitFor([&] { return tracer.frame()->generation == 2 && tracer.frame()->samples > 1; }));
    EXPECT_EQ(tracer.frame()->width, 2 * kTraceWidth);
  }
  EXPECT_EQ(std::count(dividers.begin(), dividers.end(), 1), std::ssize(dividers)) << "a coarse one is a step back";
}

// A scene that comes during a pause is shown by its first pass, and no other path is traced, however often its worker
// is woken to show it otherwise.
TEST(Tracer, PausesAndGoesOn) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
  const auto watched = std::make_shared<const WatchedMedium>(makeMedium(*scene, 1e9, Task{}), [](uint64_t) {});
  test::WorkerWindow window;
  Tracer tracer(window.waker(), 1);
  tracer.pause(true);
  tracer.show({{scene, watched}, 16, 12, 1});  // too small for a pass in parts
  ASSERT_TRUE(window.waitFor([&] { return tracer.frame() != nullptr; }));
  const uint64_t paths = watched->paths();
  for (int i = 0; i < 20; ++i) {
    const auto before = tracer.frame();
    tracer.denoise(i % 2 == 0);
    ASSERT_TRUE(window.waitFor([&] { return tracer.frame() != before; }));
    ASSERT_EQ(watched->paths(), paths);
  }
  tracer.pause(false);
  EXPECT_TRUE(window.waitFor([&] { return watched->paths() > paths && tracer.frame()->samples > 1; }));
}

// The inset follows a moving view together with the picture around it; in a pause it does not, and the picture does.
TEST(Tracer, ShowsASceneThatComesInAPauseBesideAnOpenInset) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  fabric.camera.azimuth_deg += 20;
  const auto turned = makeScene(std::make_shared<const Fabric>(fabric), Task{}, scene.get());
  test::WorkerWindow window;
  Tracer tracer(window.waker(), 1);
  tracer.show({{scene, medium}, kTraceWidth, kTraceHeight, 1});
  tracer.fibres({scene, medium});
  tracer.inset(PixelRect{8, 8, 32, 32});
  ASSERT_TRUE(window.waitFor([&] { return tracer.insetFrame() != nullptr; }));
  tracer.pause(true);
  tracer.show({{turned, medium}, kTraceWidth, kTraceHeight, 2});
  EXPECT_TRUE(window.waitFor([&] { return tracer.frame()->generation == 2; }));
}

TEST(Tracer, TracesFromTheMomentThatItIsAsked) {
  const std::shared_ptr<const Scene> scene = test::sceneOf(test::whiteCotton());
  std::latch looked(1);
  const auto held =
      std::make_shared<const WatchedMedium>(makeMedium(*scene, 1e9, Task{}), [&](uint64_t) { looked.wait(); });
  Tracer tracer([] {}, 1);
  EXPECT_EQ(tracer.state().picture, Tracer::State::Phase::idle);
  tracer.show({{scene, held}, kTraceWidth, kTraceHeight, 1});
  EXPECT_EQ(tracer.state().picture, Tracer::State::Phase::tracing);
  looked.count_down();
}

TEST(Tracer, SaysWhatWentWrongAndGoesOnWithTheNextScene) {
  const std::shared_ptr<const Scene> scene = test::sceneOf(test::whiteCotton());
  const std::shared_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  const auto failing = std::make_shared<const WatchedMedium>(medium, [](uint64_t) { throw std::bad_alloc(); });
  test::WorkerWindow window;
  Tracer tracer(window.waker(), 1);
  tracer.show({{scene, failing}, 16, 12, 1});
  ASSERT_TRUE(window.waitFor([&] { return !tracer.state().error.empty(); }));
  EXPECT_EQ(tracer.state().error, "It needs more memory than there is.");
  EXPECT_EQ(tracer.state().picture, Tracer::State::Phase::idle);
  tracer.show({{scene, medium}, 16, 12, 2});
  EXPECT_TRUE(window.waitFor([&] { return tracer.frame() && tracer.frame()->generation == 2; }));
  EXPECT_EQ(tracer.state().error, "");
}

}  // namespace
}  // namespace loomlight
