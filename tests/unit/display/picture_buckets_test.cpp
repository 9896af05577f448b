#include "render/display/picture_buckets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight {
namespace {

constexpr PixelRect kBucketWindow{10, 20, 100, 70};

TEST(PictureBuckets, CoverTheWindowOnceFromTheMiddleOutwards) {
  for (const int side : {0, 7, 32, 1000}) {
    SCOPED_TRACE(side);
    std::vector<int> times(static_cast<size_t>(kBucketWindow.width) * kBucketWindow.height);
    double last = 0;
    for (PictureBuckets buckets(kBucketWindow, side); !buckets.finished(); buckets.finishNext()) {
      const PixelRect bucket = buckets.next();
      const double x = bucket.x + 0.5 * bucket.width - (kBucketWindow.x + 0.5 * kBucketWindow.width);
      const double y = bucket.y + 0.5 * bucket.height - (kBucketWindow.y + 0.5 * kBucketWindow.height);
      EXPECT_GE(std::hypot(x, y), last);
      last = std::hypot(x, y);
      for (int v = bucket.y; v < bucket.y + bucket.height; ++v)
        for (int u = bucket.x; u < bucket.x + bucket.width; ++u)
          ++times.at(static_cast<size_t>(v - kBucketWindow.y) * kBucketWindow.width +
                     static_cast<size_t>(u - kBucketWindow.x));
    }
    for (const int n : times) ASSERT_EQ(n, 1);
  }
}

// What is done fades into what is not: no step between neighbours is more than the ramp's, and nothing is shown early.
TEST(PictureBuckets, HaveNoSharpBorders) {
  constexpr int kSide = 32;
  PictureBuckets buckets(kBucketWindow, kSide);
  const auto isDone = [&](int x, int y, const std::vector<PixelRect>& done) {
    for (const PixelRect& p : done)
      if (x >= p.x && x < p.x + p.width && y >= p.y && y < p.y + p.height) return true;
    return false;
  };
  std::vector<PixelRect> done;
  while (!buckets.finished()) {
    done.push_back(buckets.next());
    buckets.finishNext();
    for (int y = kBucketWindow.y; y < kBucketWindow.y + kBucketWindow.height; ++y)
      for (int x = kBucketWindow.x; x < kBucketWindow.x + kBucketWindow.width; ++x) {
        const float shown = buckets.shown(x, y);
        ASSERT_GE(shown, 0.0f);
        ASSERT_LE(shown, 1.0f);
        if (!isDone(x, y, done)) {
          ASSERT_EQ(shown, 0.0f);
        }
        if (x > kBucketWindow.x) {
          ASSERT_NEAR(shown, buckets.shown(x - 1, y), 1.5f / (0.25f * kSide) + 1e-5f);
        }
        if (y > kBucketWindow.y) {
          ASSERT_NEAR(shown, buckets.shown(x, y - 1), 1.5f / (0.25f * kSide) + 1e-5f);
        }
      }
  }
  EXPECT_EQ(buckets.shown(kBucketWindow.x, kBucketWindow.y), 1.0f);
}

}  // namespace
}  // namespace loomlight
