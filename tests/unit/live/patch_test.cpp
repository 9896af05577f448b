#include "render/display/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

#include "app/live/live_renderer.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

const glm::vec4 kOld(0.25f, 0.25f, 0.25f, 1), kFresh(0.75f, 0.5f, 0.25f, 1);

const Weave kThen(std::vector<Weave::Row>(6, Weave::Row(6, 0)));
const Weave kNow = kThen.with(3, 2, true);

/// Crossings of eight pixels a side, warp over where the sum of their numbers is even.
Film::Hit hitAt(int x, int y) {
  const int end = x / 8, pick = y / 8;
  return {(end + pick) % 2, end, pick, 25};
}

Frame pictureOf(int size, int divider, const glm::vec4& colour) {
  Frame frame;
  frame.width = frame.height = size / divider;
  frame.divider = divider;
  frame.window = {0, 0, size, size};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      frame.rgba.push_back(colour);
      frame.hits.push_back(hitAt(x * divider + divider / 2, y * divider + divider / 2));
    }
  return frame;
}

TEST(Patched, ChangesWhatTheNewPictureShowsOtherwise) {
  for (const int divider : {1, 4}) {
    const Frame old = pictureOf(48, 1, kOld);
    Frame fresh = pictureOf(48, divider, kFresh);
    for (Film::Hit& hit : fresh.hits)
      if (hit.end == 2 && hit.pick == 3) hit.yarn = 1 - hit.yarn;
    fresh.generation = 7;
    const Frame whole = patched(fresh, old, kNow, kThen, false);
    EXPECT_EQ(whole.generation, 7u);
    ASSERT_EQ(whole.rgba.size(), old.rgba.size());
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const bool turned = x / 8 == 2 && y / 8 == 3;
        const size_t i = static_cast<size_t>(y) * 48 + static_cast<size_t>(x);
        const int across = std::max({16 - x, x - 23, 0}), down = std::max({24 - y, y - 31, 0});
        SCOPED_TRACE(testing::Message() << x << ", " << y << " at 1/" << divider);
        if (turned) {
          EXPECT_EQ(whole.rgba[i], kFresh);
        } else if (std::max(across, down) >= (divider == 1 ? 6 : 2 * divider)) {  // at 1/1, five fade
          EXPECT_EQ(whole.rgba[i], kOld);
        } else {  // no border is a line
          EXPECT_GE(whole.rgba[i].x, std::min(kFresh.x, kOld.x));
          EXPECT_LE(whole.rgba[i].x, std::max(kFresh.x, kOld.x));
        }
        EXPECT_EQ(whole.hits[i].yarn == hitAt(x, y).yarn, !turned);
      }
  }
}

TEST(Patched, AFinePictureComesInOverSomePixels) {
  const Frame old = pictureOf(48, 1, kOld);
  Frame fresh = pictureOf(48, 1, kFresh);
  for (Film::Hit& hit : fresh.hits)
    if (hit.end == 2 && hit.pick == 3) hit.yarn = 1 - hit.yarn;
  const Frame whole = patched(fresh, old, kNow, kThen, false);
  float steepest = 0;
  for (int x = 1; x < 48; ++x)
    steepest = std::max(steepest, std::abs(whole.rgba[28 * 48 + x].x - whole.rgba[28 * 48 + x - 1].x));
  EXPECT_LE(steepest, 0.4f * (kFresh.x - kOld.x));
}

// A coarse picture may have no sample on a crossing that was turned.
TEST(Patched, ATurnedCrossingIsSeenWhereNoSampleMetIt) {
  const Frame old = pictureOf(48, 1, kOld), fresh = pictureOf(48, 8, kFresh);
  const Frame whole = patched(fresh, old, kNow, kThen, false);
  EXPECT_EQ(patched(fresh, old, kThen, kThen, false).rgba, old.rgba);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      const size_t i = static_cast<size_t>(y) * 48 + static_cast<size_t>(x);
      if (x / 8 == 2 && y / 8 == 3) {
        EXPECT_EQ(whole.rgba[i], kFresh);
      } else if (x >= 40 || y < 8) {
        EXPECT_EQ(whole.rgba[i], kOld);
      }
    }
}

// A thread leans on the one beside it, which knows what is turned beside it in turn.
TEST(Patched, InCrowdedClothChangesReachAThreadFarther) {
  const Frame old = pictureOf(48, 1, kOld);
  Frame fresh = pictureOf(48, 1, kFresh);
  for (Film::Hit& hit : fresh.hits)
    if (hit.end == 4 && hit.pick == 5) hit.yarn = 1 - hit.yarn;
  const size_t middle = 44 * 48 + 36;
  EXPECT_EQ(patched(fresh, old, kNow, kThen, false).rgba[middle], kOld);
  EXPECT_EQ(patched(fresh, old, kNow, kThen, true).rgba[middle], kFresh);
}

TEST(Patched, IsAsGoodAsTheWorseOfBoth) {
  Frame old = pictureOf(48, 1, kOld), fresh = pictureOf(48, 8, kFresh);
  EXPECT_EQ(patched(fresh, old, kNow, kThen, false).quality, PreviewQuality::clear);
  fresh.quality = PreviewQuality::sketch;
  EXPECT_EQ(patched(fresh, old, kNow, kThen, false).quality, PreviewQuality::sketch);
  std::swap(fresh.quality, old.quality);
  EXPECT_EQ(patched(fresh, old, kNow, kThen, false).quality, PreviewQuality::sketch);
}

// What is fresh in it decides what may be seen of later passes.
TEST(Patched, SharesLightWhereTheFreshPictureDoes) {
  Frame old = pictureOf(48, 1, kOld), fresh = pictureOf(48, 8, kFresh);
  old.shared = true;
  EXPECT_FALSE(patched(fresh, old, kNow, kThen, false).shared);
  std::swap(fresh.shared, old.shared);
  EXPECT_TRUE(patched(fresh, old, kNow, kThen, false).shared);
}

TEST(Patched, TakesCoarsePicturesThatReachBeyondTheEdge) {
  const Frame old = pictureOf(48, 1, kOld);
  Frame fresh = pictureOf(64, 32, kFresh);
  for (Film::Hit& hit : fresh.hits) hit = {5, 92, 93, 25};
  for (const glm::vec4& pixel : patched(fresh, old, kNow, kThen, false).rgba) EXPECT_EQ(pixel, kFresh);
}

/// Wider than the piece that is seen: a single crossing is turned.
Fabric wideCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  // The soft border of a coarse picture reaches some crossings far: the piece has many.
  fabric.drape.width_mm = fabric.drape.height_mm = 12;
  fabric.camera.distance_mm = 24;
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.weftSequence = {1};
  std::vector<Weave::Row> plain(32, Weave::Row(32));
  for (size_t pick = 0; pick < 32; ++pick)
    for (size_t end = 0; end < 32; ++end) plain[pick][end] = (pick + end) % 2 == 0;
  fabric.weave = Weave(plain);
  return fabric;
}

size_t samePixels(const Frame& a, const Frame& b) {
  size_t same = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) same += a.rgba[i] == b.rgba[i];
  return same;
}

// What a stroke of the brush does not touch stays as clear as it was, from the first picture on.
TEST(LivePatch, APaintedCrossingLeavesTheRestOfThePictureAsItWas) {
  Fabric fabric = wideCloth();
  test::WorkerWindow window;
  // The last picture before the stroke, and the first one after it: the thread that traces shows none unseen.
  const LiveRenderer* shown = nullptr;
  std::mutex mutex;
  std::shared_ptr<const Frame> before, after;
  LiveRenderer renderer(
      [&, wake = window.waker()] {
        {
          std::lock_guard lock(mutex);
          const auto frame = shown->frame();
          if (frame && frame->generation == 1) before = frame;
          if (frame && frame->generation == 2 && !after) after = frame;
        }
        wake();
      },
      1);
  shown = &renderer;
  const auto show = [&](uint64_t generation) {
    renderer.request({std::make_shared<const Fabric>(fabric), 96, 96, generation, nullptr});
  };
  show(1);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame() && renderer.frame()->samples >= 16; }));
  fabric.weave = fabric.weave.with(14, 14, !fabric.weave.at(14, 14));
  show(2);
  ASSERT_TRUE(window.waitFor([&] {
    std::lock_guard lock(mutex);
    return after != nullptr;
  }));
  std::lock_guard lock(mutex);
  ASSERT_EQ(after->rgba.size(), before->rgba.size());
  EXPECT_EQ(after->divider, 1);
  EXPECT_GT(samePixels(*after, *before), after->rgba.size() / 2);
  EXPECT_LT(samePixels(*after, *before), after->rgba.size());
}

TEST(LivePatch, StaysWhenTheClothIsGivenAName) {
  Fabric fabric = wideCloth();
  test::WorkerWindow window;
  LiveRenderer renderer(window.waker(), 1);
  renderer.shareLight(false);
  renderer.restAt(16);
  const auto show = [&](uint64_t generation) {
    renderer.request({std::make_shared<const Fabric>(fabric), 96, 96, generation, nullptr});
  };
  const auto rests = [&](uint64_t generation) {
    return window.waitFor([&] {
      const auto frame = renderer.frame();
      return frame && frame->generation == generation && renderer.status().phase == LiveStatus::Phase::converged;
    });
  };
  show(1);
  ASSERT_TRUE(rests(1));
  renderer.restAt(2);
  fabric.weave = fabric.weave.with(14, 14, !fabric.weave.at(14, 14));
  show(2);
  ASSERT_TRUE(rests(2));
  const auto patched = renderer.frame();
  fabric.name = "a name";
  show(3);
  ASSERT_TRUE(rests(3));
  EXPECT_EQ(samePixels(*renderer.frame(), *patched), patched->rgba.size());
}

}  // namespace
}  // namespace loomlight
