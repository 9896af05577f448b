#include "app/live/live_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/base/random.h"
#include "render/light/lat_long.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/small_view.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

using test::smallView;
using Window = test::WorkerWindow;

Fabric smallCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  return fabric;
}

TEST(LiveRenderer, ShowsTheFabric) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  EXPECT_EQ(renderer.frame(), nullptr);
  renderer.request(smallView(smallCloth(), 1));
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
  EXPECT_TRUE(window.waitFor([&] { return renderer.status().counts.bricks > 0; }));
  EXPECT_GT(renderer.status().measures.arealMass_g_m2, 0);
}

// The viewport may show the truth too; moving the camera then keeps the fibres, and leaving the method lets them go.
TEST(LiveRenderer, ShowsExplicitFibres) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.render.method = Method::fibres;
  renderer.request(smallView(fabric, 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 1; }));
  fabric.camera.azimuth_deg += 20;
  renderer.request(smallView(fabric, 2));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  fabric.render.method = Method::volume;
  renderer.request(smallView(fabric, 3));
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
    renderer.request(smallView(fabric, i));
  }
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == kEdits; }));
}

/// One edit of a designer in a hurry, at random.
void edit(Fabric& fabric, Random& random) {
  Yarn& yarn = fabric.yarns[0];
  switch (random.below(7)) {
    case 0:
      fabric.weave = fabric.weave.resized(2 + static_cast<int>(random.below(4)), 2 + static_cast<int>(random.below(4)));
      break;
    case 1:
      yarn.plyTwist_per_m = 300 + 50 * random.below(8);
      break;
    case 2:
      yarn.count_tex = 15 + random.below(8);
      break;
    case 3:
      yarn.plies = 1 + static_cast<int>(random.below(3));
      break;
    case 4:
      fabric.ends_per_cm = 20 + random.below(5);
      break;
    case 5:
      fabric.fibres[0].absorption_per_mm = Rgb(10 * random.uniform());
      break;
    default: {
      const int pick = static_cast<int>(random.below(static_cast<uint32_t>(fabric.weave.picks()))),
                end = static_cast<int>(random.below(static_cast<uint32_t>(fabric.weave.ends())));
      fabric.weave = fabric.weave.with(pick, end, !fabric.weave.at(pick, end));
    }
  }
}

// Edits, undo and redo arrive while volumes are built and pictures traced; what is shown in the end is, to the last
// bit, the picture of a scene that was built of nothing.
TEST(LiveRenderer, EditsDuringBuildsLeaveWhatAFreshBuildMakes) {
  constexpr int kClear = 16;  // from here on pictures are shown as they are
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    Window window;
    LiveRenderer renderer(window.waker(), 2);
    std::vector<Fabric> history{smallCloth()};
    size_t now = 0;
    uint64_t generation = 0;
    for (int step = 0; step < 60; ++step) {
      const uint32_t action = random.below(6);
      if (action == 0 && now > 0) {
        --now;  // undo
      } else if (action == 1 && now + 1 < history.size()) {
        ++now;  // redo
      } else {
        history.resize(++now);
        history.push_back(history.back());
        edit(history.back(), random);
      }
      renderer.request(smallView(history[now], ++generation));
      // At once, or somewhere in the middle of what the edit sets going.
      std::this_thread::sleep_for(std::chrono::microseconds(random.below(4) == 0 ? 0 : random.below(20'000)));
    }
    Fabric last = history[now];
    last.yarns[0].plyTwist_per_m = 777;
    renderer.request(smallView(last, ++generation));
    // What is shown before all is built is another picture; at the end it may go on for one more pass.
    constexpr int kLongestPass = 64;
    ASSERT_TRUE(window.waitFor([&] { return renderer.status().builtGeneration == generation; }));
    const auto shows = [&](int samples) {
      const auto frame = renderer.frame();
      return frame && frame->generation == generation && frame->samples >= samples;
    };
    const int enough = shows(1) ? renderer.frame()->samples + kLongestPass + 1 : kClear;
    ASSERT_TRUE(window.waitFor([&] { return shows(enough); }));
    const auto seen = renderer.frame();
    const auto scene = test::sceneOf(last);
    const auto medium = makeMedium(*scene, 4e9, Task{});
    Film film(seen->width, seen->height);
    const CameraRays camera(last.camera, seen->width, seen->height);
    ASSERT_TRUE(renderUpTo(static_cast<uint32_t>(seen->samples), *scene, *medium, camera, film, Task{}).complete);
    for (int y = 0; y < seen->height; ++y)
      for (int x = 0; x < seen->width; ++x)
        ASSERT_EQ(glm::vec3(seen->rgba[static_cast<size_t>(y) * seen->width + x]), film.mean(x, y)) << "seed " << seed;
  }
}

// A drag of a heavy cloth moves the picture though no build of it is ever done.
TEST(LiveRenderer, ShowsEveryOtherEditOfAClothThatTakesLongToBuild) {
  constexpr uint64_t kEdits = 6;
  Window window;
  const LiveRenderer* shown = nullptr;
  std::atomic<uint64_t> seen = 0, seenEarly = 0;  // pictures of an edit, and those that came before its volume
  LiveRenderer renderer(
      [&, wake = window.waker()] {  // asked by the thread that traces, as soon as there is a picture
        const auto frame = shown->frame();
        if (frame && seen.exchange(frame->generation) < frame->generation)
          seenEarly += shown->status().builtGeneration < frame->generation;
        wake();
      },
      1);
  shown = &renderer;
  Fabric fabric = smallCloth();
  fabric.yarns[0].count_tex = 100;
  fabric.yarns[0].migration = 0.3;
  fabric.ends_per_cm = fabric.picks_per_cm = 11;
  for (uint64_t generation = 1; generation <= kEdits; ++generation) {
    fabric.yarns[0].plyTwist_per_m = 200.0 + 20.0 * static_cast<double>(generation);
    renderer.request(smallView(fabric, generation));
    ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == generation; }));
  }
  EXPECT_GT(seenEarly, 0u) << "no picture was there before its volume";
  EXPECT_TRUE(window.waitFor([&] { return renderer.status().builtGeneration == kEdits; }));
}

TEST(LiveRenderer, AMaterialEditTouchesNoVoxel) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric fabric = smallCloth();
  renderer.request(smallView(fabric, 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.status().builtGeneration == 1; }));
  const double before = renderer.status().buildSeconds;
  fabric.fibres[0].absorption_per_mm = Rgb(50, 5, 5);
  fabric.fibres[0].refractiveIndex = 1.6;
  renderer.request(smallView(fabric, 2));
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 2; }));
  EXPECT_EQ(renderer.status().buildSeconds, before);  // set anew by every voxelisation
}

TEST(LiveRenderer, UndoAndRedoVoxeliseNothing) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric fabric = smallCloth(), edited = fabric;
  edited.yarns[0].plyTwist_per_m += 100;
  edited.weave = edited.weave.with(0, 0, !edited.weave.at(0, 0));
  uint64_t generation = 0;
  const auto bricksFor = [&](const Fabric& shown) {
    const uint64_t before = renderer.status().bricksVoxelised;
    renderer.request(smallView(shown, ++generation));
    EXPECT_TRUE(window.waitFor([&] { return renderer.status().builtGeneration == generation; }));
    return renderer.status().bricksVoxelised - before;
  };
  EXPECT_GT(bricksFor(fabric), 0u);
  EXPECT_GT(bricksFor(edited), 0u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(bricksFor(fabric), 0u);
    EXPECT_EQ(bricksFor(edited), 0u);
  }
}

TEST(LiveRenderer, SaysWhatIsWrongAndGoesOn) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric broken = smallCloth();
  broken.drape.kind = DrapeKind::mesh;
  broken.drape.file = "no-such-mesh.obj";
  renderer.request(smallView(broken, 1));
  ASSERT_TRUE(window.waitFor([&] { return !renderer.status().error.empty(); }));
  EXPECT_NE(renderer.status().error.find("no-such-mesh.obj"), std::string::npos);
  renderer.request(smallView(smallCloth(), 2));
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->generation == 2; }));
  // A first look may come before its cloth is known to be right.
  EXPECT_TRUE(window.waitFor([&] { return renderer.status().error.empty(); }));
}

TEST(LiveRenderer, EndsInTheMiddleOfWork) {
  Window window;
  for (int i = 0; i < 5; ++i) {
    LiveRenderer renderer(window.waker(), 2);
    renderer.request(smallView(smallCloth(), 1));
    if (i % 2) window.waitFor([&] { return renderer.frame() != nullptr; });
  }
}

// The report's estimator shows a picture before any table is baked; better tables take over once theirs is as good.
TEST(LiveRenderer, BetterTablesReplaceAPictureWithoutGoingBack) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric fabric = smallCloth();
  fabric.render.estimator = Estimator::report;
  fabric.fibres[0].absorption_per_mm = Rgb(2000);  // dark: most of what is seen has been scattered once
  ViewRequest request = smallView(fabric, 1);
  renderer.request(request);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->samples >= 16; }));
  EXPECT_EQ(renderer.status().error, "");

  // Tables of total shadow: no light that comes straight from the dome, so the picture is darker.
  auto dark = std::make_shared<BvdfSet>();
  const BvdfResolution resolution;
  dark->tables.emplace_back(resolution, HotSpot{1e6f, 1e-6f}, std::vector<float>(resolution.bins(), 1.0f));
  dark->tableOfYarn = {0};
  const auto brightness = [](const Frame& frame) {
    double sum = 0;
    for (const glm::vec4& pixel : frame.rgba) sum += pixel.g;
    return sum;
  };
  const double before = brightness(*renderer.frame());
  int most = renderer.frame()->samples;
  request.visibility = dark;
  renderer.request(request);
  bool wentBack = false;
  EXPECT_TRUE(window.waitFor([&] {
    const auto frame = renderer.frame();
    wentBack |= frame->samples < most;
    most = frame->samples;
    return brightness(*frame) < 0.9 * before;
  }));
  EXPECT_FALSE(wentBack);
}

TEST(ReferenceInset, ShowsTheVeryPixelsThatBricksOfFibresShow) {
  constexpr int kClear = 16;  // from here on pictures are shown as they are
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.camera.distance_mm = 6;
  renderer.request(smallView(fabric, 1));
  const PixelRect place{20, 10, 24, 16};
  renderer.inset(InsetRequest{place, 4e9});
  ASSERT_TRUE(
      window.waitFor([&] { return renderer.insetFrame() && renderer.insetFrame()->fibres->samples >= kClear; }));
  const auto seen = renderer.insetFrame()->fibres;
  EXPECT_EQ(seen->generation, 1u);
  EXPECT_EQ(seen->window, place);
  EXPECT_GT(renderer.status().inset.segments, 1000);
  EXPECT_GT(renderer.status().inset.bytes, renderer.status().inset.segments);

  fabric.render.method = Method::fibres;
  renderer.inset(std::nullopt);
  const auto scene = test::sceneOf(fabric);
  const auto fibres = makeMedium(*scene, {4e9, FibreExtent::bricks}, Task{});
  Film film(64, 48);
  const CameraRays camera(fabric.camera, 64, 48);
  ASSERT_TRUE(renderUpTo(static_cast<uint32_t>(seen->samples), *scene, *fibres, camera, film, Task{}).complete);
  for (int y = 0; y < place.height; ++y)
    for (int x = 0; x < place.width; ++x) {
      const glm::vec4 pixel = seen->rgba[static_cast<size_t>(y) * place.width + x];
      EXPECT_EQ(glm::vec3(pixel), film.mean(place.x + x, place.y + y));
    }
}

// A volume that forgets what the eye's ray has passed is in its own shadow with the light at the eye, fibres are not:
// the two pictures are far apart, and the inset says how far.
TEST(ReferenceInset, ComparesBothPicturesAndTheVolumeGoesOn) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.camera.distance_mm = 6;
  fabric.light.kind = LightKind::headlight;
  fabric.fibres[0].absorption_per_mm = Rgb(2000);  // dark: all that is seen has been scattered once
  fabric.render.estimator = Estimator::none;
  renderer.request(smallView(fabric, 1));
  const PixelRect place{20, 10, 24, 16};
  renderer.inset(InsetRequest{place, 4e9});
  constexpr int kSamples = 64;  // as many as the pictures below: with half of the noise that would hide the difference
  ASSERT_TRUE(window.waitFor([&] {
    const auto seen = renderer.insetFrame();
    return seen && seen->difference && seen->fibres->samples >= kSamples && renderer.frame()->samples >= kSamples;
  }));
  const int before = renderer.frame()->samples;
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame()->samples > before; }));
  const auto difference = renderer.insetFrame()->difference;
  EXPECT_EQ(difference->map.size(), 24u * 16u);

  const auto traced = [&](Method method) {
    Fabric other = fabric;
    other.render.method = method;
    other.render.seed = 2;
    const auto scene = test::sceneOf(other);
    const auto medium = makeMedium(*scene, 4e9, Task{});
    Film film(64, 48);
    renderUpTo(kSamples, *scene, *medium, CameraRays(fabric.camera, 64, 48), film, Task{}, {.window = place});
    return film;
  };
  const Film volume = traced(Method::volume), fibres = traced(Method::fibres);
  double change = 0, truth = 0, variance = 0;
  for (int y = place.y; y < place.y + place.height; ++y)
    for (int x = place.x; x < place.x + place.width; ++x) {
      change += luminance(volume.mean(x, y)) - luminance(fibres.mean(x, y));
      truth += luminance(fibres.mean(x, y));
      variance += volume.variance(x, y) + fibres.variance(x, y);
    }
  const double expected_percent = 100 * change / truth;
  const double error_percent = std::hypot(difference->error_percent, 100 * std::sqrt(variance) / truth);
  EXPECT_GT(std::abs(expected_percent), 4 * error_percent);
  EXPECT_NEAR(difference->mean_percent, expected_percent, 4 * error_percent);
}

TEST(ReferenceInset, FollowsTheCameraKeepsTheFibresAndRelaysThemAfterAnEdit) {
  Window window;
  LiveRenderer renderer(window.waker(), 2);
  Fabric fabric = smallCloth();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  renderer.request(smallView(fabric, 1));
  renderer.inset(InsetRequest{{20, 10, 24, 16}, 4e9});
  const auto shows = [&](uint64_t generation) {
    return renderer.insetFrame() && renderer.insetFrame()->fibres->generation == generation;
  };
  ASSERT_TRUE(window.waitFor([&] { return shows(1); }));
  bool laying = false;
  fabric.camera.azimuth_deg += 20;
  renderer.request(smallView(fabric, 2));
  ASSERT_TRUE(window.waitFor([&] {
    laying |= renderer.status().inset.phase == InsetStatus::Phase::laying;
    return shows(2);
  }));
  EXPECT_FALSE(laying);
  const double segments = renderer.status().inset.segments;
  fabric.yarns[0].count_tex *= 2;
  renderer.request(smallView(fabric, 3));
  ASSERT_TRUE(window.waitFor([&] { return shows(3); }));
  EXPECT_GT(renderer.status().inset.segments, 1.2 * segments);
}

TEST(ReferenceInset, SaysWhatItWouldTakeAndRefusesBeyondTheLimit) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  renderer.request(smallView(smallCloth(), 1));
  renderer.inset(InsetRequest{{20, 10, 24, 16}, 1e5});
  ASSERT_TRUE(window.waitFor([&] { return renderer.status().inset.phase == InsetStatus::Phase::tooLarge; }));
  EXPECT_GT(renderer.status().inset.bytes, 1e5);
  EXPECT_EQ(renderer.insetFrame(), nullptr);
  renderer.inset(InsetRequest{{20, 10, 24, 16}, 4e9});  // the limit was raised
  EXPECT_TRUE(window.waitFor([&] { return renderer.insetFrame() != nullptr; }));
  renderer.inset(std::nullopt);
  EXPECT_TRUE(window.waitFor([&] { return renderer.insetFrame() == nullptr; }));
  EXPECT_EQ(renderer.status().inset.phase, InsetStatus::Phase::closed);
}

TEST(ReferenceInset, IsNeedlessOverExplicitFibresAndEndsInTheMiddleOfWork) {
  Window window;
  LiveRenderer renderer(window.waker(), 1);
  Fabric fabric = smallCloth();
  renderer.inset(InsetRequest{{0, 0, 24, 16}, 4e9});
  EXPECT_EQ(renderer.status().inset.phase, InsetStatus::Phase::waiting);
  renderer.request(smallView(fabric, 1));
  ASSERT_TRUE(window.waitFor([&] { return renderer.insetFrame() != nullptr; }));
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  fabric.render.method = Method::fibres;
  renderer.request(smallView(fabric, 2));
  EXPECT_TRUE(window.waitFor([&] { return renderer.status().inset.phase == InsetStatus::Phase::needless; }));
  fabric.render.method = Method::volume;
  renderer.request(smallView(fabric, 3));
  EXPECT_TRUE(window.waitFor([&] {
    const auto frame = renderer.insetFrame();
    return frame && frame->fibres->generation == 3;
  }));
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  renderer.request(smallView(fabric, 4));
  EXPECT_TRUE(window.waitFor([&] { return renderer.status().builtGeneration == 4; }));
}

}  // namespace
}  // namespace loomlight
