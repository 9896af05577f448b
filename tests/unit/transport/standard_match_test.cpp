#include "render/transport/standard_match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/support/open_cloth.h"

namespace loomlight {
namespace {

TEST(StandardMatches, JudgeThePartThatTheyAreOf) {
  Fabric fabric = test::openCloth();
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(20.0f, 8.0f, 2.0f);
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.weftSequence = {1};
  Spectrum flat;
  flat.fill(0.5f);
  const auto patch = makeColourPatch(fabric, {});
  const auto first = standardMatches(*patch, {{partOfYarn(1), "weft", "lot 7", flat}}, {});
  ASSERT_TRUE(first && first->size() == 1);
  const StandardMatch& weft = first->front();
  EXPECT_EQ(weft.partName, "weft");
  EXPECT_EQ(weft.standard, "lot 7");
  EXPECT_FALSE(weft.daylight.passes(1));
  EXPECT_NEAR(weft.daylight.metamerism, 0, 1e-9);  // rounding
  EXPECT_GT(weft.bulb.metamerism, 0);
  EXPECT_NEAR(weft.daylight.standard.L, 116 * std::cbrt(0.5) - 16, 1e-3);
  const auto others = standardMatches(*patch, {{partOfYarn(0), "warp", "lot 7", flat}, {{}, "Cloth", "", flat}}, {});
  ASSERT_TRUE(others && others->size() == 2);
  const auto redness = [](const StandardMatch& match) { return match.shown.r / match.shown.b; };
  EXPECT_LT(redness(weft), redness(others->back())) << "a blue weft, and the cloth";
  EXPECT_LT(redness(others->back()), redness(others->front())) << "a white warp";
  fabric.yarns.push_back(fabric.yarns[0]);
  const auto larger = makeColourPatch(fabric, {});
  ASSERT_TRUE(larger);
  EXPECT_THROW(standardMatches(*larger, {{partOfYarn(2), "unused", "lot 7", flat}}, {}), InputError);
}

}  // namespace
}  // namespace loomlight
