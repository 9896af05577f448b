/// Colourways side by side: as large as there is room for, and on paper.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/fabric/model/colourways.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

Fabric offered(int colourways) {
  Fabric cloth = smallCloth("Offered");
  for (int i = 0; i < colourways; ++i) cloth.colourways.push_back(colourwayOf(cloth, "Way " + std::to_string(i + 1)));
  return cloth;
}

void openDialog(HeadlessEditor& editor) {
  editor.click("menu.edit");
  editor.click("menu.colourways");
  editor.until("they are shown", [&] { return editor.shows("colourways.card_0"); });
}

TEST(Colourways, TakeTheRoomThatThereIs) {
  HeadlessEditor editor({1440, 900});
  editor.start(offered(3));
  openDialog(editor);
  for (int i = 0; i < 6; ++i) editor.frame();
  const HeadlessEditor::Rect first = editor.rect("colourways.card_0"), last = editor.rect("colourways.card_3");
  EXPECT_GT(last.x1 - first.x0, 1200) << "two beside each other";
  EXPECT_GT(last.y1 - first.y0, 600) << "and two below";
  EXPECT_LT(last.y1, editor.rect("colourways.name").y0);
  for (int i = 0; i < 4; ++i) {
    const std::string card = "colourways.card_" + std::to_string(i);
    editor.until("all have pictures of that size", [&] {
      const Pixels8* const picture = editor.pictureIn(card);
      return picture && picture->width + 1 >= static_cast<int>(first.x1 - first.x0);
    });
  }
}

TEST(Colourways, ScrollWhereThereAreTooMany) {
  HeadlessEditor editor({1024, 640});
  editor.start(offered(30));
  openDialog(editor);
  for (int i = 0; i < 6; ++i) editor.frame();
  const HeadlessEditor::Rect first = editor.rect("colourways.card_0");
  EXPECT_GE(first.x1 - first.x0, 199) << "no smaller than can be judged";
}

TEST(Colourways, AYarnWithAFibreOfItsOwnHasItsColourInEach) {
  HeadlessEditor editor({1280, 1400});
  Fabric cloth = offered(2);
  cloth.yarns.push_back(cloth.yarns[0]);
  cloth.weftSequence = {1};
  cloth.colourways[1].absorption_per_mm = {Rgb(7)};
  editor.start(cloth);
  editor.click("tab.fibre");
  editor.edits("it has one", [&] { editor.click("fibre.own"); });
  EXPECT_EQ(editor.saved().colourways[1].absorption_per_mm, (std::vector<Absorption>{Rgb(7), Rgb(7)}));
}

TEST(Colourways, GoOnPaper) {
  HeadlessEditor editor;
  editor.start(offered(6));  // so many that they are not done before anybody has looked twice
  openDialog(editor);
  editor.click("colourways.print");
  const std::string file = editor.homeFile("colourways.pdf");
  editor.nameFile(file);
  editor.until("they are rendered for the page",
               [&] { return editor.fact("busy").find("colourways.pdf") != std::string::npos; });
  const auto done = [&] { return std::atoi(editor.fact("busy.done").c_str()); };
  editor.until("it is known how far they are", [&] { return done() > 0; });
  const int before = done();
  editor.until("they come on", [&] { return done() > before; });
  EXPECT_LE(done(), 100);
  editor.click("busy.cancel");
  editor.untilNoDialogIsOpen();
  EXPECT_FALSE(std::filesystem::exists(file)) << "nothing is written by halves";
}

}  // namespace
}  // namespace loomlight
