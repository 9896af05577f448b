#include "app/editor/services/yarn_colour_service.h"

#include <gtest/gtest.h>

#include "core/fabric/model/colourways.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

Fabric redCloth() {
  Fabric fabric;
  fabric.fibres[0].radius_um = 20;
  fabric.fibres[0].absorption_per_mm = Rgb(4.0f, 60.0f, 80.0f);
  fabric.render.resolution = 1;
  return fabric;
}

class YarnColours : public testing::Test {
 protected:
  std::shared_ptr<const Fabric> follows(Fabric fabric) {
    const auto shared = std::make_shared<const Fabric>(std::move(fabric));
    colours.follow(shared);
    return shared;
  }
  std::shared_ptr<const Fabric> known(Fabric fabric) {
    auto shared = follows(std::move(fabric));
    EXPECT_TRUE(wakes.until([&] { return colours.knows(*shared); }));
    return shared;
  }
  Wakes wakes;
  YarnColourService colours{wakes.callback()};
};

TEST_F(YarnColours, AreThoseThatTheClothReaches) {
  const auto cloth = known(redCloth());
  EXPECT_EQ(colours.of(*cloth), *reachedColours(*cloth, Task{}));
  EXPECT_NE(colours.of(*cloth), yarnReflectances(*cloth));
}

TEST_F(YarnColours, AnOldColourStaysUntilTheNewOneIsKnown) {
  const auto red = known(redCloth());
  const std::vector<Rgb> before = colours.of(*red);
  Fabric blue = *red;
  blue.fibres[0].absorption_per_mm = Rgb(80.0f, 60.0f, 4.0f);
  const auto dyed = std::make_shared<const Fabric>(blue);
  EXPECT_EQ(colours.of(*dyed), before) << "nobody has looked at it yet";
  colours.follow(dyed);
  ASSERT_TRUE(wakes.until([&] { return colours.knows(*dyed); }));
  EXPECT_GT(colours.of(*dyed)[0].b, 2 * before[0].b);
  EXPECT_EQ(colours.of(*known(*red)), before) << "a step of undo brings it back";
}

TEST_F(YarnColours, ACopiedYarnIsShownAsTheOneItIsLike) {
  const auto red = known(redCloth());
  const Fabric more = withYarnCopied(*red, 0);
  EXPECT_EQ(colours.of(more), std::vector<Rgb>(2, colours.of(*red)[0]));
  EXPECT_EQ(colours.of(*known(more)).size(), 2u);
}

TEST_F(YarnColours, OfTheNextClothNothingIsKnownYet) {
  const auto red = known(redCloth());
  colours.forget();
  EXPECT_FALSE(colours.knows(*red));
  EXPECT_EQ(colours.of(*red), yarnReflectances(*red));
  colours.follow(red);
  EXPECT_TRUE(wakes.until([&] { return colours.knows(*red); }));
}

TEST_F(YarnColours, ColourwaysAreAsTheClothWouldBeInThem) {
  Fabric fabric = redCloth();
  Colourway blue{.name = "blue", .absorption_per_mm = {Rgb(80.0f, 60.0f, 4.0f)}, .unknown = {}};
  fabric.colourways = {blue};
  const auto cloth = known(fabric);
  const std::vector<Rgb> shown = colours.ofColourway(*cloth, 0);
  EXPECT_EQ(shown, *reachedColours(inColourway(fabric, blue), Task{}));
}

TEST_F(YarnColours, AFibreThatIsGoneLeavesNoColourBehind) {
  const auto more = known(withYarnCopied(redCloth(), 0));
  Fabric fewer = withoutYarn(*more, 1);
  EXPECT_EQ(colours.of(fewer).size(), 1u);
  EXPECT_EQ(colours.of(*known(fewer)).size(), 1u);
}

}  // namespace
}  // namespace loomlight
