/// The editor at four sizes, dark and light: whatever is opened, no label, choice or button loses its end without a way
/// to read it, nothing leaves the window, and draft, inspector and presets stay in reach. Its interface can be made
/// larger or smaller.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "core/fabric/json/fabric_json.h"
#include "tests/headless/editor/headless_editor.h"

namespace loomlight {
namespace {

struct Look {
  const char* name;
  HeadlessEditor::Screen screen;
  bool dark;
};
constexpr HeadlessEditor::Screen kTightest{1024, 640, 1}, kLaptop{1440, 900, 1}, kDesk{1920, 1080, 1},
    kFine{2880, 1800, 2};
constexpr Look kLooks[] = {{"TightestDark", kTightest, true}, {"TightestLight", kTightest, false},
                           {"LaptopDark", kLaptop, true},     {"LaptopLight", kLaptop, false},
                           {"DeskDark", kDesk, true},         {"DeskLight", kDesk, false},
                           {"FineDark", kFine, true},         {"FineLight", kFine, false}};

Fabric lightFabric() {
  Fabric fabric = readFabric(LOOMLIGHT_SAMPLES "/denim.json");
  for (Fibre& fibre : fabric.fibres) fibre.radius_um = 20;  // few fibres are soon laid
  fabric.drape = {};
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.camera.distance_mm = 200;  // hardly any of the picture, so that tracing it takes no time
  fabric.light = {};
  fabric.light.kind = LightKind::headlight;  // the longest name of a light
  fabric.render = {};
  fabric.render.resolution = 1;
  return fabric;
}

void expectInside(const HeadlessEditor& editor, const std::string& widget) {
  const HeadlessEditor::Rect r = editor.rect(widget);
  EXPECT_TRUE(0 <= r.x0 && r.x0 < r.x1 && r.x1 <= editor.screen().x) << widget << " " << r.x0 << " " << r.x1;
  EXPECT_TRUE(0 <= r.y0 && r.y0 < r.y1 && r.y1 <= editor.screen().y) << widget << " " << r.y0 << " " << r.y1;
}

class LookAt : public testing::TestWithParam<Look> {
 protected:
  LookAt() {
    editor.start(lightFabric());
    editor.untilPictured();
    if (GetParam().dark) return;
    editor.click("menu.view");
    editor.click("menu.light");
  }

  /// Each text has its room, or is read in a tooltip; where there is room enough, the former.
  void expectWhole(const std::string& where) const {
    const bool hasRoom = editor.screen().x / GetParam().screen.scale >= 1280;
    for (const auto& [name, text] : editor.snapshot().facts) {
      EXPECT_FALSE(name.starts_with("clipped.")) << where << ": " << name << " has lost the end of " << text;
      EXPECT_FALSE(hasRoom && name.starts_with("shortened.")) << where << ": " << name << " is not all of " << text;
    }
  }

  /// Where the next line of structures begins.
  float below(const std::string& structure) const {
    const float line = editor.rect(structure).y0;
    float next = editor.screen().y;
    for (const auto& [name, place] : editor.snapshot().widgets)
      if (name.starts_with("structure/") && place.y0 > line && !name.ends_with("/name"))
        next = std::min(next, place.y0);
    return next;
  }

  HeadlessEditor editor{GetParam().screen};
};

TEST_P(LookAt, EveryPageIsWholeAndAllIsInReach) {
  expectWhole("the first sight");
  for (const char* page : {"tab.fibre", "tab.cloth", "tab.scene", "tab.yarn", "draft.tab_loom", "draft.tab_colours",
                           "draft.tab_structures"}) {
    editor.click(page);
    expectWhole(page);
    for (const char* widget : {"draft.canvas", "draft.tieup_0_1", "draft.tab_colours", "tab.yarn", "viewport",
                               "view.light", "view.exposure", "status.work"})
      expectInside(editor, widget);
    expectInside(editor, editor.shows("presets.browse") ? "presets.browse" : "sample/Blue cloth");
  }
}

TEST_P(LookAt, EveryMenuIsWhole) {
  const std::pair<const char*, const char*> menus[] = {{"menu.file", "menu.quit"},
                                                       {"menu.edit", "menu.undo"},
                                                       {"menu.weave", "menu.invert"},
                                                       {"menu.view", "menu.light"},
                                                       {"menu.help", "menu.about"}};
  for (const auto& [menu, item] : menus) {
    editor.click(menu);
    editor.centre(item);
    expectInside(editor, item);
    expectWhole(menu);
    editor.key("Escape");
    editor.until("Esc shuts the menu", [&, name = item] { return !editor.shows(name); });
  }
}

TEST_P(LookAt, EveryDialogIsWhole) {
  const struct {
    const char *menu, *item, *close;
  } dialogs[] = {{"menu.file", "menu.open", "browser.cancel"},
                 {"menu.file", "menu.snapshot", "snapshot.close"},
                 {"menu.file", "menu.handover", "handover.close"},
                 {"menu.edit", "menu.preferences", "preferences.close"},
                 {"menu.weave", "menu.structures", "structures.close"},
                 {"menu.help", "menu.keys", "keys.close"},
                 {"menu.file", "menu.presets", "presets.close"},
                 {"menu.edit", "menu.colourways", "colourways.close"},
                 {"menu.view", "menu.colour_difference", "difference.close"}};
  for (const auto& dialog : dialogs) {
    editor.click(dialog.menu);
    editor.click(dialog.item);
    editor.centre(dialog.close);
    expectInside(editor, dialog.close);
    expectWhole(dialog.item);
    editor.key("Escape");
    editor.until("Esc closes the dialog", [&] { return !editor.shows(dialog.close); });
  }
  editor.key("ctrl+e");
  editor.centre("tile.close");
  expectInside(editor, "tile.close");
  expectWhole("the tile");
}

/// The truth lens is as wide as its names, which stand beside each other, in a small rectangle too.
TEST_P(LookAt, TheLensIsWhole) {
  editor.key("l");
  const ImVec2 middle = editor.centre("viewport");
  const float step = 20 * GetParam().screen.scale;
  editor.drag(middle, ImVec2(middle.x + step, middle.y + step));
  editor.until("it is placed", [&] { return editor.shows("lens.close"); });
  expectWhole("the lens");
  const char* const bar[] = {"lens.bar", "lens.fibres", "lens.difference", "lens.close"};
  for (size_t i = 0; i + 1 < std::size(bar); ++i)
    EXPECT_LE(editor.rect(bar[i]).x1, editor.rect(bar[i + 1]).x0) << bar[i];
  for (const char* part : bar) expectInside(editor, part);
}

/// A row of floats takes room from the draft alone: tabs and presets stay under the mouse.
TEST_P(LookAt, ARowOfFloatsMovesNothing) {
  const HeadlessEditor::Rect tab = editor.rect("draft.tab_colours");
  const bool hadPresets = editor.shows("sample/Blue cloth");
  editor.click("draft.floats");
  editor.centre("draft.long_float");
  EXPECT_EQ(editor.rect("draft.tab_colours").y0, tab.y0);
  EXPECT_EQ(editor.shows("sample/Blue cloth"), hadPresets);
}

/// Dialogs that are as high as their rows open in the middle too.
TEST_P(LookAt, DialogsOpenInTheMiddle) {
  for (const auto& [menu, item, close] : {std::array{"menu.edit", "menu.preferences", "preferences.close"},
                                          std::array{"menu.file", "menu.handover", "handover.close"},
                                          std::array{"menu.view", "menu.colour_difference", "difference.close"}}) {
    editor.click(menu);
    editor.click(item);
    editor.centre(close);
    const HeadlessEditor::Rect dialog = editor.rect("modal");
    EXPECT_NEAR(dialog.y0, editor.screen().y - dialog.y1, 2) << item;
    editor.key("Escape");
    editor.until("Esc closes the dialog", [&, name = close] { return !editor.shows(name); });
  }
}

/// No name in the panel of structures is broken off, and what orders come to is said whole, whatever the size.
TEST_P(LookAt, WhatThePanelOfTheDraftSaysIsSaidWhole) {
  editor.click("draft.tab_structures");
  EXPECT_EQ(editor.rect("structure/Warp rib").y0, editor.rect("structure/Plain").y0) << "they need not stand in twos";
  const HeadlessEditor::Rect plain = editor.rect("structure/Plain"), name = editor.rect("structure/Plain/name");
  const float gap = below("structure/Plain") - name.y1, above = name.y0 - plain.y1;
  EXPECT_GT(gap, 2 * above) << "it is seen whose name it is";
  if (GetParam().screen.height / GetParam().screen.scale >= 900) {  // of the last one the name is read too
    const HeadlessEditor::Rect last = editor.rect("structure/Sateen 8/name");
    expectInside(editor, "structure/Sateen 8/name");
    EXPECT_LT(last.y1, editor.rect(editor.shows("presets.browse") ? "presets.browse" : "sample/Blue cloth").y0);
    expectInside(editor, "structures.open");
  }
  for (const auto& [name, text] : editor.snapshot().facts)
    EXPECT_FALSE(name.starts_with("shortened.structure/")) << text;
  editor.edits("a long order", [&] {
    editor.click("draft.tab_colours");
    editor.enter("draft.warp_order", "100A 100B");
  });
  editor.edits("another", [&] { editor.enter("draft.weft_order", "100A 100B"); });
  editor.frame();
  for (const char* order : {"draft.warp_order_threads", "draft.weft_order_threads"})
    EXPECT_EQ(editor.fact(std::string("shortened.") + order), "") << order;
}

INSTANTIATE_TEST_SUITE_P(AtSize, LookAt, testing::ValuesIn(kLooks),
                         [](const auto& look) { return std::string(look.param.name); });

void expectWhole(const HeadlessEditor& editor, const std::string& where) {
  for (const auto& [name, text] : editor.snapshot().facts)
    EXPECT_FALSE(name.starts_with("clipped.")) << where << ": " << name << " has lost the end of " << text;
}

class LookAtSmall : public testing::Test {
 protected:
  LookAtSmall() {
    editor.start(lightFabric());
    editor.untilPictured();
  }
  HeadlessEditor editor{{1280, 720, 1}};
};

/// What buttons above the draft do is said beside it, and tables that are drawn at are covered by nothing.
TEST_F(LookAtSmall, TooltipsStandBesideTheDraft) {
  for (const char* const table : {"draft.tieup_0_1", "draft.threading_0_1"}) {
    editor.move(editor.centre(table));
    for (int i = 0; i < 60; ++i) editor.frame();
    EXPECT_FALSE(editor.shows("tooltip")) << table;
  }
  for (const char* const of : {"draft.select", "draft.colour", "draft.back", "draft.floats"}) {
    editor.move(editor.centre(of));
    editor.until(of, [&] { return !editor.fact("tooltip").empty(); });
    EXPECT_GE(editor.rect("tooltip").x0, editor.rect("draft.canvas").x1) << of;
    if (of == std::string("draft.floats")) continue;
    editor.move(editor.centre("status.work"));
    editor.until("it has gone", [&] { return !editor.shows("tooltip"); });
  }
  editor.click("draft.floats");
  for (int i = 0; i < 60; ++i) editor.frame();
  EXPECT_EQ(editor.fact("tooltip"), "") << "whoever has pressed the button knows what it does";
}

/// Neither do those of the row that lists floats.
TEST_F(LookAtSmall, TooltipsOfTheFloatRowStandBesideTheDraftToo) {
  editor.click("draft.floats");
  for (const char* const of : {"draft.long_float", "draft.float_before", "draft.float_next"}) {
    editor.move(editor.centre(of));
    editor.until(of, [&] { return !editor.fact("tooltip").empty(); });
    EXPECT_GE(editor.rect("tooltip").x0, editor.rect("draft.canvas").x1) << of;
    editor.move(editor.centre("status.work"));
    editor.until("it has gone", [&] { return !editor.shows("tooltip"); });
  }
}

/// What a field is for is no news to whoever has just typed into it, and would cover what is said of that.
TEST_F(LookAtSmall, NoTooltipCoversWhatIsSaidOfATypedText) {
  editor.click("tab.cloth");
  for (const auto& [field, text] : {std::pair("cloth.description", "twill"), std::pair("cloth.ends_per_cm", "9999")}) {
    editor.click(field);
    editor.type(text);
    editor.key("Return");
    for (int i = 0; i < 90; ++i) editor.frame();
    EXPECT_EQ(editor.fact("tooltip"), "") << field;
    editor.move(editor.centre("status.work"));
    editor.frame();
    editor.move(editor.centre(field));
    editor.until("it is read when the mouse comes again", [&] { return !editor.fact("tooltip").empty(); });
    editor.move(editor.centre("status.work"));
    editor.until("it has gone", [&] { return editor.fact("tooltip").empty(); });
  }
}

/// A name of any length leaves the menus alone, and figures leave what is said beside them alone.
TEST_F(LookAtSmall, NothingIsWrittenOverAnother) {
  editor.click("tab.cloth");
  editor.edits("a long name", [&] { editor.enter("cloth.name", std::string(200, 'm')); });
  EXPECT_GT(editor.rect("title").x0, editor.rect("menu.help").x1);
  editor.click("draft.floats");
  editor.enter("draft.long_float", "0.1");
  editor.until("floats are warned of", [&] { return editor.shows("status.warning"); });
  EXPECT_GT(editor.rect("status.warning").x0, editor.rect("status.float").x1);
}

/// A name that is broken off is read whole where the mouse rests.
TEST_F(LookAtSmall, WhatIsCutIsReadInATooltip) {
  const std::string name(200, 'm');
  editor.click("tab.cloth");
  editor.edits("a long name", [&] { editor.enter("cloth.name", name); });
  editor.move(editor.centre("title"));
  editor.until("the name is whole", [&] { return editor.fact("tooltip") == name; });
  editor.move(editor.centre("cloth.name"));
  editor.until("so is the field that it fades out in", [&] { return editor.fact("tooltip").starts_with(name + "\n"); });
}

/// 1, 2 and 3 look from above, aslant and along the cloth.
TEST_F(LookAtSmall, KeysTurnTheCloth) {
  for (const char* key : {"3", "2", "1"}) {
    const uint64_t generation = editor.number("generation");
    editor.key(key);
    editor.until(std::string(key) + " turns the cloth", [&] { return editor.number("generation") > generation; });
  }
}

/// Smaller and larger than the monitor asks for, and back; larger as far as leaves room for the cloth.
TEST_F(LookAtSmall, TheInterfaceIsResized) {
  const auto height = [&] {
    const HeadlessEditor::Rect r = editor.rect("preferences.size");
    return r.y1 - r.y0;
  };
  editor.click("menu.edit");
  editor.click("menu.preferences");
  editor.centre("preferences.size");
  const float usual = height();
  editor.click("preferences.size/75 %");
  editor.until("rows are three quarters as high", [&] { return std::abs(height() - 0.75f * usual) <= 1; });
  expectWhole(editor, "a smaller interface");
  editor.click("preferences.size/200 %");
  editor.until("rows are higher", [&] { return height() > usual; });
  const HeadlessEditor::Rect cloth = editor.rect("viewport");
  EXPECT_GT(cloth.x1 - cloth.x0, 0.4f * editor.screen().x) << "a large interface leaves no room for the cloth";
  expectWhole(editor, "a larger interface");
  editor.click("preferences.size/100 %");
  editor.until("rows are as high as before", [&] { return height() == usual; });
}

/// In the smallest window that the program asks for, dialogs show all of their rows. A window manager may make it
/// smaller still: rows that have no room scroll then, and where the file goes and the buttons that end the dialog stay
/// in reach.
TEST(LookAtLeast, DialogsEndWithinTheWindow) {
  constexpr HeadlessEditor::Screen kLeast{960, 600, 1}, kLess{800, 520, 1};
  for (const HeadlessEditor::Screen& screen : {kLeast, kLess}) {
    HeadlessEditor editor(screen);
    editor.start(lightFabric());
    editor.untilPictured();
    for (const auto& [key, dialog, last] : {std::array{"ctrl+p", "snapshot", "snapshot.samples_per_pixel"},
                                            std::array{"ctrl+e", "tile", "tile.samples"}}) {
      const std::string name = dialog, file = name + ".file", browse = name + ".browse", close = name + ".close",
                        start = name + ".start";
      editor.key(key);
      editor.centre(start);
      if (screen.height == kLeast.height) {
        EXPECT_LT(editor.rect(last).y1, editor.rect(file).y0) << last;
      }
      EXPECT_LT(editor.rect(file).y1, editor.rect(browse).y0) << browse;
      EXPECT_LT(editor.rect(browse).y1, editor.rect(start).y0) << browse;
      EXPECT_NEAR(editor.rect(browse).x0, editor.rect(file).x0, 1) << "the button stands below the field";
      expectInside(editor, close);
      expectInside(editor, start);
      editor.key("Escape");
      editor.until("Esc closes the dialog", [&] { return editor.fact("dialog") == "none"; });
    }
  }
}

}  // namespace
}  // namespace loomlight
