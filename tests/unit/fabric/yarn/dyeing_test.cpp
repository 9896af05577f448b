#include "core/fabric/yarn/dyeing.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

/// A colour in a fibre's name goes with the colour; what else it is called stays, and no two are called alike.
TEST(DyedAlike, NamesSayNoColourThatIsGone) {
  Fabric fabric;
  fabric.fibres.assign(3, Fibre{});
  fabric.fibres[0].name = "silk, champagne";
  fabric.fibres[1].name = "silk, rose";
  fabric.fibres[2].name = "Aunt Mary's silk";
  const Fabric one = dyedAlike(fabric, partOfFibre(0), Rgb(9));
  EXPECT_EQ(one.fibres[0].name, "silk");
  EXPECT_EQ(one.fibres[0].absorption_per_mm, Absorption(Rgb(9)));
  EXPECT_EQ(one.fibres[1], fabric.fibres[1]);
  const Fabric piece = dyedAlike(one, wholePiece(), Rgb(5));
  EXPECT_EQ(piece.fibres[0].name, "silk");
  EXPECT_EQ(piece.fibres[1].name, "silk 2");
  EXPECT_EQ(piece.fibres[2].name, "Aunt Mary's silk");
  for (const Fibre& fibre : piece.fibres) EXPECT_EQ(fibre.absorption_per_mm, Absorption(Rgb(5)));
}

}  // namespace
}  // namespace loomlight
