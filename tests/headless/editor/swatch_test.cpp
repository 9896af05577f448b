/// What a spectrophotometer has measured becomes the dye of the fibre that is looked at.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "core/fabric/model/glossary.h"
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
  HeadlessEditor editor{{1024, 640, 1}};
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

/// Where it is dropped it dyes: the yarn there alone, though another has its fibre.
TEST(SwatchOnTheCloth, DyesTheYarnUnderTheMouse) {
  Fabric cloth = smallTwill();
  for (Yarn& yarn : cloth.yarns) yarn.fibre = 0;
  const test::ScratchFolder folder;
  std::string text = "nm (% SCE),brown\n";
  for (int nm = 380; nm <= 740; nm += 20) text += fmt::format("{},{}\n", nm, 5 + (nm - 380) * 0.012);
  test::putBytes(folder.file("brown.csv"), text);
  HeadlessEditor editor{{1024, 640, 1}};
  editor.start(cloth);
  // A first look is coarser than a yarn; the picture rests at one sample.
  editor.until("each yarn is seen", [&] { return editor.number("shown_samples") == 1; });
  const ImVec2 middle = editor.centre("viewport");
  // Along a line over the cloth both yarns are met; in the midst of one, as edges move while the picture refines.
  const auto findYarn = [&](const std::string& yarn) {
    constexpr int kStep = 2, kHalfWide = 2;
    for (int i = 0, found = 0; i < 150; ++i) {
      editor.clickAt(ImVec2(middle.x + static_cast<float>(kStep * i), middle.y));
      found = editor.fact("yarn") == yarn ? found + 1 : 0;
      if (found == 2 * kHalfWide) return ImVec2(middle.x + static_cast<float>(kStep * (i - kHalfWide)), middle.y);
    }
    ADD_FAILURE() << "no yarn " << yarn;
    return middle;
  };
  const ImVec2 weft = findYarn("1");
  findYarn("0");  // which is looked at from now on
  editor.move(weft);
  editor.edits("the cloth is dyed", [&] { editor.drop(folder.file("brown.csv")); });
  EXPECT_EQ(editor.fact("yarn"), "1");
  const Fabric dyed = editor.saved();
  EXPECT_EQ(dyed.yarns[0], cloth.yarns[0]);
  EXPECT_EQ(dyed.fibres[0], cloth.fibres[0]) << "the warp has its colour still";
  EXPECT_NE(dyed.yarns[1].fibre, 0);
  EXPECT_TRUE(dyed.fibres[static_cast<size_t>(dyed.yarns[1].fibre)].absorption_per_mm.isSpectral());
  editor.until("it is said how it was measured", [&] {
    return editor.fact("fibre.cloth_colour_remark") == "As brown (SCE, specular excluded) was measured.";
  });
}

/// A palette gives colours to choose from.
TEST_F(Swatches, AColourOfAPaletteDyesByAClickOrByItsName) {
  editor.drop(file("autumn.gpl", "GIMP Palette\nName: Autumn\n#\n120 60 30 rust\n60 70 90 slate\n90 100 50 moss\n"));
  editor.until("its colours are there", [&] { return editor.fact("book.found") == "3 of 3"; });
  editor.move(editor.centre("book.0"));
  editor.until("its numbers are said", [&] {
    return editor.fact("tooltip").starts_with("rust\nL* ") && editor.fact("tooltip").ends_with("(D65, 2\xC2\xB0)");
  });
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
  editor.until("the cloth is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
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
  HeadlessEditor editor{{1024, 640, 1}};
  editor.start(cloth);
  editor.click("tab.fibre");
  editor.click("fibre.dyed/Piece");
  editor.until("the cloth is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
  editor.edits("the piece is dyed", [&] { editor.enter("fibre.colour_code", "#7a5030"); });
  const Fabric dyed = editor.saved();
  EXPECT_EQ(dyed.fibres[0].absorption_per_mm, dyed.fibres[1].absorption_per_mm);
  EXPECT_GT(dyed.fibres[0].absorption_per_mm.primaries.b, dyed.fibres[0].absorption_per_mm.primaries.r);
}

TEST(YarnDyeing, LeavesYarnsAsTheyAreThatShareItsFibre) {
  Fabric cloth = smallTwill();
  for (Yarn& yarn : cloth.yarns) yarn.fibre = 0;
  HeadlessEditor editor{{1024, 640, 1}};
  editor.start(cloth);
  editor.click("tab.fibre");
  editor.click("fibre.dyed/Yarn");
  editor.click("inspector.yarn_1");
  editor.until("the yarn is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
  editor.edits("the yarn is dyed", [&] { editor.enter("fibre.colour_code", "#7a5030"); });
  const Fabric dyed = editor.saved();
  EXPECT_EQ(dyed.yarns[0], cloth.yarns[0]);
  EXPECT_EQ(dyed.fibres[0], cloth.fibres[0]) << "the other yarn has its colour still";
  const Fibre& own = dyed.fibres[static_cast<size_t>(dyed.yarns[1].fibre)];
  EXPECT_NE(dyed.yarns[1].fibre, 0);
  EXPECT_GT(own.absorption_per_mm.primaries.b, own.absorption_per_mm.primaries.r) << "a brown";
  editor.until("it is reached", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Reached"); });
}

TEST_F(Swatches, OneClickTakesTheNearest) {
  editor.click("tab.fibre");
  editor.until("the cloth is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
  editor.edits("white is asked for", [&] { editor.enter("fibre.colour_code", "#ffffff"); });
  editor.until("it cannot be had", [&] {
    return editor.fact("fibre.cloth_colour_remark").starts_with("Lighter") &&
           editor.fact("fibre.cloth_colour_difference") != "\u0394E 0.0";
  });
  // Not before the cloth is measured as it has become: what it was before is not the nearest.
  editor.until("it can be taken",
               [&] { return editor.fact("fibre.cloth_colour_nearest") == words::takeNearest.label; });
  const Fabric nearest = editor.saved();
  editor.click("fibre.cloth_colour_nearest");
  editor.until("it is wanted now", [&] { return editor.fact("fibre.cloth_colour_difference") == "\u0394E 0.0"; });
  EXPECT_TRUE(editor.fact("fibre.cloth_colour_remark").starts_with("Reached"));
  EXPECT_EQ(editor.saved(), nearest) << "the cloth has the nearest already";
}

/// Whatever is known, wanted or refused: what is below stays where the hand is.
TEST_F(Swatches, NoRowMoves) {
  editor.click("tab.fibre");
  const auto places = [&] {
    return std::vector{editor.rect("fibre.dyed"), editor.rect("fibre.colour_code"), editor.rect("book.choice"),
                       editor.rect("fibre.absorption_r"), editor.rect("fibre.preset")};
  };
  const auto before = places();
  editor.until("the cloth is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
  EXPECT_EQ(places(), before) << "when the colour is known";
  editor.enter("fibre.colour_code", "bluish");
  editor.until("it is refused", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("\"bluish\""); });
  EXPECT_EQ(places(), before) << "when a code is refused";
  editor.edits("white is asked for", [&] { editor.enter("fibre.colour_code", "#ffffff"); });
  editor.until("it cannot be had", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Lighter"); });
  EXPECT_EQ(places(), before) << "when a colour cannot be had";
  editor.edits("it is dyed as measured", [&] {
    editor.drop(file("brown.csv", brown()));
    editor.answer();
  });
  EXPECT_EQ(places(), before) << "when it is known in bands";
}

/// A colour book stays on the page from one session to the next, until it is forgotten.
TEST_F(Swatches, ABookThatWasDroppedIsThereAtTheNextStart) {
  const std::string autumn = file("autumn.gpl", "GIMP Palette\nName: Autumn\n#\n120 60 30 rust\n60 70 90 slate\n");
  const std::string spring = file("spring.gpl", "GIMP Palette\nName: Spring\n#\n180 220 120 leaf\n");
  editor.drop(autumn);
  editor.until("its colours are there", [&] { return editor.fact("book.found") == "2 of 2"; });
  editor.drop(spring);
  editor.until("the other's are there", [&] { return editor.fact("book.found") == "1 of 1"; });
  const std::string cloth = editor.fact("file");
  editor.leave();
  editor.startOn(cloth);
  editor.click("tab.fibre");
  editor.until("the last book is open", [&] { return editor.fact("book.found") == "1 of 1"; });
  editor.choose("book.choice", "autumn");
  editor.until("the other is", [&] { return editor.fact("book.found") == "2 of 2"; });
  editor.choose("book.choice", "Forget autumn");
  editor.until("it is gone", [&] { return !editor.shows("book.search"); });
  std::filesystem::remove(spring);
  editor.choose("book.choice", "spring");
  editor.until("what is missing is said",
               [&] { return editor.fact("fibre.cloth_colour_remark").find("spring.gpl") != std::string::npos; });
}

}  // namespace
}  // namespace loomlight
