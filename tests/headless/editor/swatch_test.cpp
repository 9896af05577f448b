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

}  // namespace
}  // namespace loomlight
