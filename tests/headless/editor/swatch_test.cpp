/// What a spectrophotometer has measured becomes the dye of the fibre that is looked at.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/fabric/yarn/yarn_reflectance.h"
#include "tests/headless/editor/weaver.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

class Swatches : public testing::Test {
 protected:
  Swatches() { editor.start(smallTwill()); }
  std::string file(const std::string& name, const std::string& text) {
    test::putBytes(folder.file(name), text);
    return folder.file(name);
  }
  /// Reflects little light of short waves and more of long ones: a brown.
  std::string brown() {
    std::string head = "name", row = "made-up brown";
    for (int nm = 400; nm <= 700; nm += 20) {
      head += fmt::format(",{}", nm);
      row += fmt::format(",{:.4f}", 0.05 + (nm - 400) * 0.0007);
    }
    return fmt::format("{}\n{}\n", head, row);
  }
  test::ScratchFolder folder;
  HeadlessEditor editor{{1280, 900, 1}};
};

TEST_F(Swatches, ADroppedOneDyesTheFibreInBandsInOneStep) {
  const Absorption before = editor.saved().fibres[0].absorption_per_mm;
  editor.edits("the cloth is dyed", [&] {
    editor.drop(file("brown.csv", brown()));
    editor.answer();  // that its numbers are fractions of 1 was guessed
  });
  EXPECT_TRUE(editor.shows("fibre.cloth_colour")) << "the page of fibres is open";
  const Fibre dyed = editor.saved().fibres[0];
  ASSERT_TRUE(dyed.absorption_per_mm.isSpectral());
  const Spectrum& bands = *dyed.absorption_per_mm.bands;
  EXPECT_GT(bands[4], 2 * bands[30]) << "what it reflects least it absorbs most";
  const Rgb chip = fibreReflectance(dyed);
  EXPECT_GT(chip.r, chip.b) << "chips show it";
  editor.until("it is said", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("As made-up brown"); });
  editor.edits("one step takes it back", [&] { editor.key("ctrl+z"); });
  EXPECT_EQ(editor.saved().fibres[0].absorption_per_mm, before);
}

TEST_F(Swatches, OneThatIsBrokenIsSaidAndDyesNothing) {
  const Absorption before = editor.saved().fibres[0].absorption_per_mm;
  editor.drop(file("broken.csv", "name,400,420\nx,0.1\n"));
  editor.until("it is said", [&] { return editor.shows("message.answer_0"); });
  editor.answer();
  EXPECT_EQ(editor.saved().fibres[0].absorption_per_mm, before);
}

/// A palette gives colours to choose from.
TEST_F(Swatches, AColourOfAPaletteDyesByAClickOrByItsName) {
  editor.drop(file("autumn.gpl", "GIMP Palette\nName: Autumn\n#\n120 60 30 rust\n60 70 90 slate\n90 100 50 moss\n"));
  editor.until("its colours are there", [&] { return editor.fact("book.found") == "3 of 3"; });
  editor.edits("a click dyes", [&] { editor.click("book.0"); });
  Rgb dye = editor.saved().fibres[0].absorption_per_mm.primaries;
  EXPECT_GT(dye.b, dye.r) << "rust";
  editor.edits("its name dyes", [&] { editor.enter("fibre.colour_code", "Slate"); });
  dye = editor.saved().fibres[0].absorption_per_mm.primaries;
  EXPECT_GT(dye.r, dye.b) << "slate";
  editor.edits("one step takes it back", [&] { editor.key("ctrl+z"); });
  dye = editor.saved().fibres[0].absorption_per_mm.primaries;
  EXPECT_GT(dye.b, dye.r) << "rust again";
}

TEST_F(Swatches, ACodeDyesAndWhatIsNoneIsSaid) {
  editor.click("tab.fibre");
  editor.until("the cloth is measured", [&] { return editor.shows("fibre.colour_code"); });
  editor.edits("a code dyes", [&] { editor.enter("fibre.colour_code", "Lab 35 20 -40"); });
  const Rgb dye = editor.saved().fibres[0].absorption_per_mm.primaries;
  EXPECT_GT(dye.g, dye.b) << "a violet";
  editor.enter("fibre.colour_code", "bluish");
  editor.until("it is refused",
               [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("\"bluish\" is no colour"); });
  EXPECT_EQ(editor.saved().fibres[0].absorption_per_mm.primaries, dye);
}

TEST(PieceDyeing, DyesAllFibresAlike) {
  Fabric cloth = smallTwill();
  cloth.fibres.push_back(cloth.fibres[0]);
  cloth.fibres[1].absorption_per_mm = Rgb(20.0f, 8.0f, 2.0f);
  cloth.yarns.push_back(cloth.yarns[0]);
  cloth.yarns[1].fibre = 1;
  cloth.weftSequence = {1};
  HeadlessEditor editor{{1280, 900, 1}};
  editor.start(cloth);
  editor.click("tab.fibre");
  editor.click("fibre.dyed/Piece");
  editor.until("the cloth is measured", [&] { return editor.shows("fibre.colour_code"); });
  editor.edits("the piece is dyed", [&] { editor.enter("fibre.colour_code", "#7a5030"); });
  const Fabric dyed = editor.saved();
  EXPECT_EQ(dyed.fibres[0].absorption_per_mm, dyed.fibres[1].absorption_per_mm);
  EXPECT_GT(dyed.fibres[0].absorption_per_mm.primaries.b, dyed.fibres[0].absorption_per_mm.primaries.r);
}

TEST(PieceDyeing, OfAClothOfOneFibreIsOfThatFibre) {
  ClothColourView view;
  view.piece = true;  // as it was left on a cloth of several
  EXPECT_EQ(view.dyed(0, 1), 0);
  EXPECT_EQ(view.dyed(1, 2), kPiece);
  view.piece = false;
  EXPECT_EQ(view.dyed(1, 2), 1);
}

}  // namespace
}  // namespace loomlight
