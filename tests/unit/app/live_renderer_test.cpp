#include "app/workers/live_renderer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Waits for what the workers do, as the window does: woken, then looking.
class Window {
 public:
  std::function<void()> waker() {
    return [this] {
      std::lock_guard lock(mutex_);
      ++wakes_;
      woken_.notify_all();
    };
  }
  /// False if it has not come true within a generous minute.
  template <class Condition>
  bool waitFor(Condition&& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::unique_lock lock(mutex_);
    for (;;) {
      const int seen = wakes_;
      lock.unlock();
      if (condition()) return true;
      lock.lock();
      if (!woken_.wait_until(lock, deadline, [&] { return wakes_ != seen; })) return false;
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable woken_;
  int wakes_ = 0;
};

Fabric smallCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  return fabric;
}

ViewRequest view(const Fabric& fabric, uint64_t generation) {
  return {std::make_shared<const Fabric>(fabric), 64, 48, generation};
}

TEST(LiveRenderer, ShowsTheFabric) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  EXPECT_EQ(renderer.frame(), nullptr);
  renderer.request(view(smallCloth(), 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->samples > 0; }));
  const auto frame = renderer.frame();
  EXPECT_EQ(frame->generation, 1u);
  EXPECT_EQ(frame->width, 64);
  EXPECT_EQ(frame->rgba.size(), 64u * 48u);
  float light = 0;
  int hits = 0;
  for (const glm::vec4& pixel : frame->rgba) light += pixel.g;
  for (const Film::Hit& hit : frame->hits) hits += hit.yarn >= 0;
  EXPECT_GT(light, 0);
  EXPECT_GT(hits, 100);
  EXPECT_GT(renderer.status().counts.bricks, 0u);
  EXPECT_GT(renderer.status().measures.arealMass_g_m2, 0);
}

// The viewport may show the truth too; moving the camera then keeps the fibres, and leaving the method lets them go.
TEST(LiveRenderer, ShowsExplicitFibres) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.render.method = Method::fibres;
  renderer.request(view(fabric, 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 1; }));
  fabric.camera.azimuth_deg += 20;
  renderer.request(view(fabric, 2));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  fabric.render.method = Method::volume;
  renderer.request(view(fabric, 3));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 3; }));
  EXPECT_EQ(renderer.status().error, "");
}

TEST(LiveRenderer, EndsOnTheNewestOfManyEdits) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  constexpr uint64_t kEdits = 40;
  for (uint64_t i = 1; i <= kEdits; ++i) {
    fabric.weave = fabric.weave.with(static_cast<int>(i % 2), static_cast<int>(i % 3 % 2), i % 5 < 2);
    fabric.yarns[0].plyTwist_per_m = 300.0 + 10.0 * static_cast<double>(i);
    fabric.camera.azimuth_deg = static_cast<double>(i);
    renderer.request(view(fabric, i));
  }
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == kEdits; }));
}

TEST(LiveRenderer, AMaterialEditTouchesNoVoxel) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric fabric = smallCloth();
  renderer.request(view(fabric, 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 1; }));
  const double before = renderer.status().buildSeconds;
  fabric.fibres[0].absorption_per_mm = Rgb(50, 5, 5);
  fabric.fibres[0].refractiveIndex = 1.6;
  renderer.request(view(fabric, 2));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  EXPECT_EQ(renderer.status().buildSeconds, before);  // set anew by every voxelisation
}

TEST(LiveRenderer, SaysWhatIsWrongAndGoesOn) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric broken = smallCloth();
  broken.drape.kind = DrapeKind::mesh;
  broken.drape.file = "no-such-mesh.obj";
  renderer.request(view(broken, 1));
  ASSERT_TRUE(window.waitFor([&] { return !renderer.status().error.empty(); }));
  EXPECT_NE(renderer.status().error.find("no-such-mesh.obj"), std::string::npos);
  renderer.request(view(smallCloth(), 2));
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 2; }));
  EXPECT_TRUE(renderer.status().error.empty());
}

TEST(LiveRenderer, PausesAndGoesOn) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  renderer.request(view(smallCloth(), 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->samples > 0; }));
  renderer.pause(true);
  renderer.pause(false);
  const int before = renderer.frame()->samples;
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame()->samples > before; }));
}

TEST(LiveRenderer, EndsInTheMiddleOfWork) {
  Window window;
  for (int i = 0; i < 5; ++i) {
    LiveRenderer renderer(window.waker(), 2);
    renderer.request(view(smallCloth(), 1));
    if (i % 2) window.waitFor([&] { return renderer.frame() != nullptr; });
  }
}

}  // namespace
}  // namespace loomlight
