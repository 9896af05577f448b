/// The editor in three sizes: whatever is opened, no label, choice or button loses its end, and nothing leaves the
/// window. Its interface can be made larger or smaller.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/fabric/json/fabric_json.h"
#include "tests/headless/editor/headless_editor.h"

namespace loomlight {
namespace {

constexpr HeadlessEditor::Screen kTightest{1280, 720, 1};

Fabric lightFabric() {
  Fabric fabric = readFabric(LOOMLIGHT_SAMPLES "/denim.json");
  for (Fibre& fibre : fabric.fibres) fibre.radius_um = 20;  // few fibres are soon laid
  fabric.drape = {};
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.light = {};
  fabric.light.kind = LightKind::headlight;  // the longest name of a light
  fabric.render = {};
  fabric.render.resolution = 1;
  return fabric;
}

void expectWhole(const HeadlessEditor& editor, const std::string& where) {
  for (const auto& [name, text] : editor.snapshot().facts)
    EXPECT_FALSE(name.starts_with("clipped.")) << where << ": " << name << " has lost the end of " << text;
}

void expectInside(const HeadlessEditor& editor, const std::string& widget) {
  const HeadlessEditor::Rect r = editor.rect(widget);
  EXPECT_TRUE(0 <= r.x0 && r.x0 < r.x1 && r.x1 <= editor.screen().x) << widget << " " << r.x0 << " " << r.x1;
  EXPECT_TRUE(0 <= r.y0 && r.y0 < r.y1 && r.y1 <= editor.screen().y) << widget << " " << r.y0 << " " << r.y1;
}

void expectEveryPageWhole(HeadlessEditor::Screen screen) {
  HeadlessEditor editor(screen);
  editor.start(lightFabric());
  editor.untilPictured();
  expectWhole(editor, "the first sight");
  for (const char* page : {"tab.fibre", "tab.cloth", "tab.scene", "tab.yarn", "draft.tab_loom", "draft.tab_colours",
                           "draft.tab_structures"}) {
    editor.click(page);
    expectWhole(editor, page);
  }
}

TEST(LookAtSize, EveryPageIsWholeOnASmallScreen) {
  expectEveryPageWhole(kTightest);
}

TEST(LookAtSize, EveryPageIsWholeOnALargeScreen) {
  expectEveryPageWhole({1920, 1080, 1});
}

TEST(LookAtSize, EveryPageIsWholeOnAFineScreen) {
  expectEveryPageWhole({2560, 1440, 2});
}

class LookAtTightest : public testing::Test {
 protected:
  LookAtTightest() {
    editor.start(lightFabric());
    editor.untilPictured();
  }
  HeadlessEditor editor{kTightest};
};

TEST_F(LookAtTightest, EveryMenuIsWhole) {
  const std::pair<const char*, const char*> menus[] = {{"menu.file", "menu.quit"},
                                                       {"menu.edit", "menu.undo"},
                                                       {"menu.weave", "menu.invert"},
                                                       {"menu.view", "menu.fit"},
                                                       {"menu.help", "menu.about"}};
  for (const auto& [menu, item] : menus) {
    editor.click(menu);
    editor.centre(item);
    expectInside(editor, item);
    expectWhole(editor, menu);
    editor.key("Escape");
    editor.until("Esc shuts the menu", [&, name = item] { return !editor.shows(name); });
  }
}

TEST_F(LookAtTightest, EveryDialogIsWhole) {
  const struct {
    const char *menu, *item, *close;
  } dialogs[] = {
      {"menu.file", "menu.snapshot", "snapshot.close"},      {"menu.edit", "menu.preferences", "preferences.close"},
      {"menu.weave", "menu.structures", "structures.close"}, {"menu.help", "menu.keys", "keys.close"},
      {"menu.file", "menu.presets", "presets.close"},        {"menu.edit", "menu.colourways", "colourways.close"}};
  for (const auto& dialog : dialogs) {
    editor.click(dialog.menu);
    editor.click(dialog.item);
    editor.centre(dialog.close);
    expectInside(editor, dialog.close);
    expectWhole(editor, dialog.item);
    editor.key("Escape");
    editor.until("Esc closes the dialog", [&] { return !editor.shows(dialog.close); });
  }
}

/// 1, 2 and 3 look from above, aslant and along the cloth.
TEST_F(LookAtTightest, KeysTurnTheCloth) {
  for (const char* key : {"3", "2", "1"}) {
    const uint64_t generation = editor.number("generation");
    editor.key(key);
    editor.until(std::string(key) + " turns the cloth", [&] { return editor.number("generation") > generation; });
  }
}

/// Smaller and larger than the monitor asks for, and back; larger as far as leaves room for the cloth.
TEST_F(LookAtTightest, TheInterfaceIsResized) {
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

}  // namespace
}  // namespace loomlight
