#include "render/transport/yarn_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "core/fabric/yarn/yarn_name.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "render/scene/colouring.h"
#include "render/transport/reached_colours.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Of two yarns without names: white, and one dyed alike in all light.
Fabric whiteAndGrey(float absorption_per_mm) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].name.clear();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(absorption_per_mm);
  fabric.weftSequence = {1};
  fabric.ends_per_cm = fabric.picks_per_cm = 30;
  fabric.render.resolution = 2;
  return fabric;
}

/// In small steps of the dye there are some where the cloth and a thick mass of it are on two sides of a word.
TEST(YarnNames, AreByTheColourThatTheClothReaches) {
  int otherThanTheDye = 0;
  for (int step = 0; step < 9; ++step) {
    const Fabric fabric = whiteAndGrey(0.5f * std::pow(1.8f, static_cast<float>(step)));
    const auto names = yarnNames(fabric, {}, CountSystem::metric);
    ASSERT_TRUE(names);
    const auto paths = tracePathsToYarns(fabric, kChipPaths, {});
    const std::vector<Rgb> called = coloursForNames(*paths, reachedColours(*paths, colouringOf(fabric)));
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ((*names)[static_cast<size_t>(i)],
                yarnName(fabric, i, called[static_cast<size_t>(i)], CountSystem::metric));
    otherThanTheDye +=
        (*names)[1] != yarnName(fabric, 1, yarnReflectance(fabric, fabric.yarns[1]), CountSystem::metric);
  }
  EXPECT_GT(otherThanTheDye, 0);
}

TEST(YarnNames, LightIsWalkedOnlyWhereAYarnHasNoName) {
  std::stop_source stop;
  stop.request_stop();
  Task stopped;
  stopped.stop = stop.get_token();
  Fabric fabric = whiteAndGrey(5);
  fabric.yarns[0].name = "Aunt Mary's";
  EXPECT_FALSE(yarnNames(fabric, stopped));
  fabric.yarns[1].name = "grey";
  EXPECT_EQ(yarnNames(fabric, stopped), (std::vector<std::string>{"Aunt Mary's", "grey"}));
}

}  // namespace
}  // namespace loomlight
