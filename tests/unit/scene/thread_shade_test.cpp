#include "render/scene/thread_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

TEST(ThreadShade, VariesByAsMuchAsIsSaid) {
  constexpr int kThreads = 100'000;
  for (const System system : {System::warp, System::weft})
    for (const float variation : {0.05f, 0.4f}) {
      double sum = 0, squares = 0, least = 2;
      for (int thread = 0; thread < kThreads; ++thread) {
        const double factor = shadeFactor(variation, shadeClass(system, thread));
        sum += factor;
        squares += factor * factor;
        least = std::min(least, factor);
      }
      const double mean = sum / kThreads;
      EXPECT_NEAR(mean, 1, 4 * variation / std::sqrt(kThreads));
      EXPECT_NEAR(std::sqrt(squares / kThreads - mean * mean) / variation, 1, 0.02);
      EXPECT_GT(least, 0) << "no thread makes light";
    }
}

TEST(ThreadShade, NeighboursKnowNothingOfEachOther) {
  constexpr int kThreads = 100'000;
  double sum = 0;
  for (int thread = 0; thread < kThreads; ++thread)
    sum += (shadeFactor(1, shadeClass(System::warp, thread)) - 1) *
           (shadeFactor(1, shadeClass(System::warp, thread + 1)) - 1);
  EXPECT_NEAR(sum / kThreads, 0, 4 / std::sqrt(kThreads));
}

}  // namespace
}  // namespace loomlight
