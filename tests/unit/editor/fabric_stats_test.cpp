#include "app/editor/services/fabric_stats.h"

#include <gtest/gtest.h>

#include <new>

#include "app/editor/model/sample_fabric.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

TEST(FabricStatsWorker, TooLittleMemoryIsSaidAndTheNextClothIsKnownAgain) {
  Wakes wakes;
  const auto fits = std::make_shared<const Fabric>(sampleFabric());
  auto tooLarge = std::make_shared<Fabric>(sampleFabric());
  tooLarge->name = "too large";
  FabricStatsWorker worker(wakes.callback(), [](const Fabric& fabric, int) {
    if (fabric.name == "too large") throw std::bad_alloc();
    FabricStats stats;
    stats.warnings = {"known"};
    return stats;
  });
  worker.request(fits, 0);
  ASSERT_TRUE(wakes.until([&] { return worker.newest() != nullptr; }));
  worker.request(tooLarge, 0);
  ASSERT_TRUE(wakes.until([&] { return !worker.problem().empty(); }));
  EXPECT_EQ(worker.problem(), "It needs more memory than there is.");
  EXPECT_EQ(worker.newest()->fabric, fits) << "what was known before is still shown";
  worker.request(fits, 0);
  EXPECT_TRUE(wakes.until([&] { return worker.problem().empty(); }));
  EXPECT_EQ(worker.newest()->warnings, std::vector<std::string>{"known"});
}

}  // namespace
}  // namespace loomlight
