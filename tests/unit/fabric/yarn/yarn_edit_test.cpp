#include "core/fabric/yarn/yarn_edit.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

TEST(YarnEdit, AYarnThatGoesTakesItsOwnFibresAlong) {
  Fabric fabric;
  fabric.fibres = {Fibre{}, Fibre{}, Fibre{}, Fibre{}};
  for (int i = 0; i < 4; ++i) fabric.fibres[static_cast<size_t>(i)].name = std::string(1, static_cast<char>('a' + i));
  fabric.yarns = {Yarn{}, Yarn{}, Yarn{}};
  fabric.yarns[1].fibre = 1;
  fabric.yarns[1].blendFibre = 2;
  fabric.yarns[2].fibre = 3;
  fabric.yarns[2].blendFibre = 0;
  fabric.warpSequence = {0, 2};
  fabric.colourways = {Colourway{"way", {Rgb(1), Rgb(2), Rgb(3), Rgb(4)}, {}}};
  const Fabric without = withoutYarn(fabric, 1);
  ASSERT_EQ(without.fibres.size(), 2u);
  EXPECT_EQ(without.fibres[1].name, "d");
  ASSERT_EQ(without.yarns.size(), 2u);
  EXPECT_EQ(without.yarns[1].fibre, 1);
  EXPECT_EQ(without.yarns[1].blendFibre, 0);
  EXPECT_EQ(without.warpSequence, (std::vector<int>{0, 1}));
  EXPECT_EQ(without.colourways[0].absorption_per_mm, (std::vector<Absorption>{Rgb(1), Rgb(4)}));
  // What others are spun of stays.
  EXPECT_EQ(withoutYarn(fabric, 0).fibres.size(), 4u);
}

/// Of which each that stays keeps its own number.
TEST(YarnEdit, AYarnThatGoesTakesItsColourInTheDraftAlong) {
  Fabric fabric;
  fabric.yarns = {Yarn{}, Yarn{}, Yarn{}};
  WifOrigin origin;
  origin.yarns = {{3, Rgb(1), {}}, {1, Rgb(2), {}}, {2, Rgb(3), {}}};
  fabric.wif = std::make_shared<WifOrigin>(origin);
  const Fabric without = withoutYarn(fabric, 1);
  ASSERT_EQ(without.wif->yarns.size(), 2u);
  EXPECT_EQ(without.wif->yarns[0], origin.yarns[0]);
  EXPECT_EQ(without.wif->yarns[1], origin.yarns[2]);
  EXPECT_EQ(fabric.wif->yarns.size(), 3u) << "undo has the old one";
}

TEST(YarnEdit, SelvedgesKeepTheirYarnOrGoOnWithTheWarp) {
  Fabric fabric;
  fabric.yarns = {Yarn{}, Yarn{}, Yarn{}};
  fabric.mill.selvedgeYarn = 2;
  EXPECT_EQ(withoutYarn(fabric, 1).mill.selvedgeYarn, 1);
  EXPECT_EQ(withoutYarn(fabric, 2).mill.selvedgeYarn, std::nullopt);
  fabric.mill.selvedgeYarn = 0;
  EXPECT_EQ(withoutYarn(fabric, 2).mill.selvedgeYarn, 0);
}

TEST(YarnEdit, AFibreThatOthersAreSpunOfStaysTheirs) {
  Fabric fabric;
  fabric.fibres = {Fibre{}};
  fabric.yarns = {Yarn{}, Yarn{}};
  Fibre coarse;
  coarse.radius_um = 20;
  const Fabric edited = withFibre(fabric, 1, coarse);
  ASSERT_EQ(edited.fibres.size(), 2u);
  EXPECT_EQ(edited.fibres[static_cast<size_t>(edited.yarns[0].fibre)].radius_um, Fibre{}.radius_um);
  EXPECT_EQ(edited.fibres[static_cast<size_t>(edited.yarns[1].fibre)].radius_um, 20);
  fabric.yarns.pop_back();
  EXPECT_EQ(withFibre(fabric, 0, coarse).fibres.size(), 1u);
}

/// In a colourway that has a colour for the old fibre, what is spun of the new one keeps that; in one that has none,
/// neither has. A fibre between them that a colourway is too old to know of keeps its own colour.
TEST(YarnEdit, AFibreOfItsOwnIsDyedInColourwaysAsTheOldOneIs) {
  Fabric fabric;
  fabric.fibres = {Fibre{}, Fibre{}};
  fabric.fibres[1].absorption_per_mm = Rgb(5);
  fabric.yarns = {Yarn{}, Yarn{}, Yarn{}};
  fabric.yarns[2].fibre = 1;
  fabric.colourways = {Colourway{"navy", {Rgb(1), Rgb(2)}, {}}, Colourway{"red", {Rgb(3)}, {}},
                       Colourway{"own", {}, {}}};
  Fibre coarse;
  coarse.radius_um = 20;
  for (const Fabric& edited :
       {withFibre(fabric, 1, coarse), withYarn(fabric, 1, Yarn{}, coarse), withYarnCopied(fabric, 0)}) {
    ASSERT_EQ(edited.fibres.size(), 3u);
    EXPECT_EQ(edited.colourways[0].absorption_per_mm, (std::vector<Absorption>{Rgb(1), Rgb(2), Rgb(1)}));
    EXPECT_EQ(edited.colourways[1].absorption_per_mm, (std::vector<Absorption>{Rgb(3), Rgb(5), Rgb(3)}));
    EXPECT_TRUE(edited.colourways[2].absorption_per_mm.empty());
  }
}

}  // namespace
}  // namespace loomlight
