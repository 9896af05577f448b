#include "core/fabric/weave/structure_edit.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_reflectance.h"

namespace loomlight {
namespace {

TEST(StructureEdit, FillsTheSelectionFromItsCorner) {
  Fabric fabric;
  fabric.weave = twill(3, 1).resized(12, 12);
  const CellRect selection{3, 2, 5, 6};
  const Weave edited = withStructure(fabric, selection, satin(5, 2), {}).fabric.weave;
  EXPECT_EQ(partOf(edited, selection), partOf(satin(5, 2), {0, 0, 5, 6}));
  for (int p = 0; p < 12; ++p)
    for (int e = 0; e < 12; ++e)
      if (!selection.contains(p, e)) {
        EXPECT_EQ(edited.at(p, e), fabric.weave.at(p, e));
      }
}

TEST(StructureEdit, ReplacesTheWeaveAndItsDraft) {
  const Fabric fabric = withDraft(Fabric{}, smallestDraft(twill(3, 1)));
  const Fabric edited = withStructure(fabric, std::nullopt, satin(8, 3), {}).fabric;
  EXPECT_EQ(edited.weave, satin(8, 3));
  ASSERT_TRUE(edited.draft);
  EXPECT_EQ(drawdown(*edited.draft), edited.weave);
}

TEST(StructureEdit, AColourEffectTakesTwoYarns) {
  MadeStructure houndstooth;
  houndstooth.weave = twill(2, 2);
  houndstooth.warpColours = houndstooth.weftColours = {0, 0, 1, 1};
  const Fabric edited = withStructure(Fabric{}, std::nullopt, houndstooth, {}).fabric;
  EXPECT_EQ(edited.yarns.size(), 2u);
  EXPECT_EQ(edited.warpSequence, houndstooth.warpColours);
  const auto colourOf = [&edited](int yarn) {
    const Fibre& fibre = edited.fibres[static_cast<size_t>(edited.yarns[static_cast<size_t>(yarn)].fibre)];
    return fibreReflectance(fibre).y;
  };
  EXPECT_LT(colourOf(1), 0.2f * colourOf(0)) << "the effect would not be seen";
  EXPECT_EQ(withSecondYarn(edited), edited);
}

TEST(StructureEdit, ASecondYarnGoesByItsColourAndNoNamePilesUp) {
  Fabric fabric;
  fabric.yarns[0].name = "Aunt Mary's";
  fabric.fibres[0].name = "wool, ecru";
  for (int i = 0; i < 3; ++i) {
    const Fabric two = withSecondYarn(fabric);
    EXPECT_EQ(two.yarns[1].name, "");
    EXPECT_EQ(two.fibres[1].name, i % 2 == 0 ? "wool" : "wool 2") << "after " << i;
    fabric = withoutYarn(two, 0);
  }
}

}  // namespace
}  // namespace loomlight
