#include "core/fabric/yarn/cloth_part.h"

#include <gtest/gtest.h>

#include "core/fabric/model/validate.h"

namespace loomlight {
namespace {

using Numbers = std::vector<int>;

/// Two yarns of one fibre, the second blended with another; and a colourway of both fibres.
Fabric sharing() {
  Fabric fabric;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].name = "wool";
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].blendFibre = 1;
  Colourway red;
  red.absorption_per_mm = {Rgb(1.0f, 9.0f, 9.0f), Rgb(2.0f, 8.0f, 8.0f)};
  fabric.colourways = {red};
  return fabric;
}

TEST(ClothPart, SaysWhichFibresAreDyedWithIt) {
  const Fabric fabric = sharing();
  EXPECT_EQ(fibresOf(fabric, wholePiece()), Numbers({0, 1}));
  EXPECT_EQ(fibresOf(fabric, partOfYarn(0)), Numbers({0}));
  EXPECT_EQ(fibresOf(fabric, partOfYarn(1)), Numbers({0, 1}));
  EXPECT_EQ(fibresOf(fabric, partOfFibre(1)), Numbers({1}));
  EXPECT_TRUE(has(fabric, partOfYarn(1)));
  EXPECT_FALSE(has(fabric, partOfYarn(2)));
}

TEST(ClothPart, AYarnTakesNoDyeFromThoseThatShareItsFibre) {
  const Fabric before = sharing(), ready = readyToDye(before, partOfYarn(1));
  EXPECT_EQ(fibresOf(ready, partOfYarn(1)), Numbers({1, 2}));
  EXPECT_EQ(ready.yarns[0], before.yarns[0]);
  EXPECT_EQ(ready.fibres[2].name, "cotton 2");
  EXPECT_EQ(ready.fibres[2].radius_um, before.fibres[0].radius_um);
  const auto& dyes = ready.colourways[0].absorption_per_mm;
  ASSERT_EQ(dyes.size(), 3u);
  EXPECT_EQ(dyes[2], dyes[0]) << "in other colourways it keeps the colour that it had there";
  EXPECT_NO_THROW(validate(ready, "ready"));
  EXPECT_EQ(readyToDye(ready, partOfYarn(1)), ready) << "its fibres are its own now";
}

TEST(ClothPart, NothingElseNeedsFibresOfItsOwn) {
  const Fabric fabric = sharing();
  EXPECT_EQ(readyToDye(fabric, wholePiece()), fabric);
  EXPECT_EQ(readyToDye(fabric, partOfFibre(0)), fabric);
}

TEST(ClothPart, WithoutRoomForOneMoreFibreOthersAreDyedToo) {
  Fabric full = sharing();
  full.fibres.resize(kMaxKinds, full.fibres[0]);
  EXPECT_EQ(readyToDye(full, partOfYarn(0)), full);
}

}  // namespace
}  // namespace loomlight
