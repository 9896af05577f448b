#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "render/media/fibre_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

Fabric cottonPiece(double side_mm) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = side_mm;
  fabric.render.resolution = 1;
  return fabric;
}

// Laying strands and Embree's tree both come by often enough that a stop is heard at once: no more than one step of a
// thread each is done after it. Without Embree's own monitor its half would run to the end, and report 1.
TEST(FibreBuild, StopsWithinAStepAlsoInsideEmbree) {
  const auto scene = test::sceneOf(cottonPiece(4));
  for (const double at : {0.1, 0.55, 0.8})
    for (const int threads : {1, 2}) {
      std::stop_source stop;
      std::atomic<int> after{0};
      Task task;
      task.stop = stop.get_token();
      task.threads = threads;
      task.progress = [&](double fraction) {
        if (stop.stop_requested()) ++after;
        if (fraction >= at) stop.request_stop();
      };
      EXPECT_EQ(FibreMedium::build(scene->cloth, {}, task), nullptr) << "stopped at " << at;
      EXPECT_TRUE(stop.stop_requested());
      EXPECT_LE(after, hardwareThreads());
    }
}

// Embree's half too: it finds the threads that the builder was given, however many the machine has.
TEST(FibreBuild, ByOneThreadIsByTheCaller) {
  const auto scene = test::sceneOf(cottonPiece(4));
  std::mutex mutex;
  std::set<std::thread::id> builders;
  Task task;
  task.threads = 1;
  task.progress = [&](double) {
    const std::lock_guard lock(mutex);
    builders.insert(std::this_thread::get_id());
  };
  ASSERT_TRUE(FibreMedium::build(scene->cloth, {}, task));
  EXPECT_EQ(builders, std::set{std::this_thread::get_id()});
}

TEST(FibreBuild, ComesByInSmallSteps) {
  const auto scene = test::sceneOf(cottonPiece(6));
  std::mutex mutex;
  std::vector<double> fractions{0};
  Task task;
  task.progress = [&](double fraction) {
    const std::lock_guard lock(mutex);
    fractions.push_back(fraction);
  };
  ASSERT_TRUE(FibreMedium::build(scene->cloth, {}, task));
  std::sort(fractions.begin(), fractions.end());
  double largest = 0;
  for (size_t i = 1; i < fractions.size(); ++i) largest = std::max(largest, fractions[i] - fractions[i - 1]);
  EXPECT_LT(largest, 0.05);
  EXPECT_EQ(fractions.back(), 1);
}

// Instrumented builds have their own, larger, memory.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// Of this process now, bytes.
double residentMemory() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * 4096;
}

/// Builds the fibres, and ends the process: with 0 where they took about what was estimated.
[[noreturn]] void measureAndExit(std::shared_ptr<const TraceData> cloth, const FibreOptions& options) {
  const double before = residentMemory();
  std::mutex mutex;
  double most = 0;
  Task task;
  task.progress = [&](double) {
    const std::lock_guard lock(mutex);
    most = std::max(most, residentMemory());
  };
  const auto fibres = FibreMedium::build(std::move(cloth), options, task);
  const FibreSize& size = fibres->size();
  EXPECT_NEAR(static_cast<double>(fibres->segments()), size.segments, 0.05 * size.segments);
  const double taken = std::max(most, residentMemory()) - before;
  constexpr double kOnce = 16e6;  // Embree's device and its threads
  EXPECT_LT(taken, size.bytes + kOnce);
  EXPECT_GT(taken, 0.6 * size.bytes);
  std::_Exit(testing::Test::HasFailure() ? 1 : 0);
}

// Each in a process of its own ("threadsafe" starts this program anew, for this test alone): memory that other tests
// have given back would be taken again without a trace.
TEST(FibreBuild, TakesTheMemoryThatWasEstimated) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const FibreOptions& options : {FibreOptions(), FibreOptions(1e9, FibreExtent::oneRepeat)})
    EXPECT_EXIT(measureAndExit(test::sceneOf(cottonPiece(10))->cloth, options), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace loomlight
