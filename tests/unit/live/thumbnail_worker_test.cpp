#include "app/live/thumbnail_worker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <vector>

#include "tests/support/wakes.h"

namespace loomlight {
namespace {

/// Coarse fibres in few pixels, which are soon rendered.
std::shared_ptr<const Fabric> soonRendered(int samples) {
  Fabric fabric;
  fabric.fibres[0].radius_um = 20;
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  fabric.camera.distance_mm = 8;
  fabric.light.kind = LightKind::dome;
  fabric.render.resolution = 1;
  fabric.render.width = 16;
  fabric.render.height = 12;
  fabric.render.samplesPerPixel = samples;
  return std::make_shared<const Fabric>(std::move(fabric));
}

Pixels8 green(const Fabric& fabric) {
  Pixels8 picture{fabric.render.width, fabric.render.height, 3, {}};
  for (int i = 0; i < picture.width * picture.height; ++i) picture.bytes.insert(picture.bytes.end(), {0, 255, 0});
  return picture;
}

/// What was there to be seen whenever the worker brought something.
struct Seen {
  std::vector<std::vector<int>> samples;  ///< of each picture; -1 where there was none
  bool sketchesAreGreen = true;
};

Seen seenUntil(int samples, const std::vector<ThumbnailOrder>& orders) {
  Wakes wakes;
  std::mutex mutex;
  Seen seen;
  const ThumbnailWorker* looked = nullptr;
  ThumbnailWorker worker(
      [&] {
        std::vector<int> now;
        const std::lock_guard lock(mutex);
        for (const ThumbnailOrder& order : orders) {
          const auto thumbnail = looked->of(order.name);
          now.push_back(thumbnail ? static_cast<int>(thumbnail->samples) : -1);
          if (now.back() == 0) seen.sketchesAreGreen &= thumbnail->picture.bytes == green(*order.fabric).bytes;
        }
        seen.samples.push_back(now);
        wakes.callback()();
      },
      green);
  looked = &worker;
  worker.request(orders);
  EXPECT_TRUE(wakes.until([&] {
    const std::lock_guard lock(mutex);
    return !seen.samples.empty() &&
           std::all_of(seen.samples.back().begin(), seen.samples.back().end(), [&](int one) { return one == samples; });
  }));
  return seen;
}

/// Nobody looks at grey for as long as it takes to trace light through all that come before.
TEST(ThumbnailWorker, SketchesAllBeforeItRendersAny) {
  const Seen seen = seenUntil(2, {{"a", soonRendered(2)}, {"b", soonRendered(2)}});
  const std::vector<std::vector<int>> expected = {{0, -1}, {0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}};
  EXPECT_EQ(seen.samples, expected);
  EXPECT_TRUE(seen.sketchesAreGreen);
}

/// After an edit the picture that there is says more than a sketch.
TEST(ThumbnailWorker, SketchesNothingInThePlaceOfAPicture) {
  Wakes wakes;
  std::mutex mutex;
  int sketches = 0;
  ThumbnailWorker worker(wakes.callback(), [&](const Fabric& fabric) {
    const std::lock_guard lock(mutex);
    ++sketches;
    return green(fabric);
  });
  for (const int samples : {1, 2}) {
    const auto fabric = soonRendered(samples);
    worker.request({{"a", fabric}});
    EXPECT_TRUE(wakes.until([&] {
      const auto newest = worker.of("a");
      return newest && newest->fabric == fabric && newest->samples == static_cast<uint32_t>(samples);
    }));
  }
  const std::lock_guard lock(mutex);
  EXPECT_EQ(sketches, 1);
}

}  // namespace
}  // namespace loomlight
