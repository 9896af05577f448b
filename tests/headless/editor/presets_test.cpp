/// The browser of presets: kept, found, renamed, duplicated, removed and brought back; cloths, yarns, fibres and
/// colours apart.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/editor/model/user_folders.h"
#include "core/base/file.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

Fabric rustCheck() {
  Fabric fabric = smallCloth("Rust check");
  fabric.ends_per_cm = fabric.picks_per_cm = 14;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.fibres[0].absorption_per_mm = Rgb(4, 14, 30);
  return fabric;
}

class Presets : public testing::Test {
 protected:
  Presets() {
    editor.start(rustCheck());
    editor.key("ctrl+b");
    untilCards("the browser shows cloths", {"Denim"});
  }
  static std::string card(const std::string& name) { return "presets.card/" + name; }
  void untilCards(const std::string& what, const std::vector<std::string>& there,
                  const std::vector<std::string>& gone = {}) {
    editor.until(what, [&] {
      for (const std::string& name : there)
        if (!editor.shows(card(name))) return false;
      for (const std::string& name : gone)
        if (editor.shows(card(name))) return false;
      return true;
    });
  }
  void search(const std::string& text) {
    editor.click("presets.search");
    editor.key("ctrl+a");
    if (text.empty())
      editor.key("Delete");
    else
      editor.type(text);
  }
  void keepCloth() {
    editor.click("presets.keep");
    untilCards("the cloth is kept", {"Rust check"});
  }
  void duplicate(const std::string& name) {
    editor.click(card(name));
    editor.click("presets.duplicate");
    untilCards("there is a duplicate", {name + " 2"});
  }
  void tag(const std::string& name, const std::string& tags) {
    editor.click(card(name));
    editor.click("presets.tags");
    editor.key("ctrl+a");
    editor.type(tags);
    editor.click("presets.tag");
  }
  void use(const std::string& name) {
    editor.click(card(name));
    editor.click("presets.use");
    editor.untilNoDialogIsOpen();
  }
  /// As they are on the disk.
  static std::string tagsOf(const std::string& name) {
    const std::filesystem::path file = presetFolder() / "tags";
    if (!std::filesystem::exists(file)) return {};
    return nlohmann::json::parse(readFile(file.string(), 100'000)).value(name, "");
  }

  HeadlessEditor editor;
};

TEST_F(Presets, ACardShowsTheCloth) {
  keepCloth();
  editor.until("it is pictured", [&] {
    const Pixels8* picture = editor.pictureIn(card("Rust check"));
    return picture && spreadOf(*picture).deviation > 0.05;
  });
  EXPECT_EQ(editor.fact("dirty"), "no") << "what is kept is no edit of the cloth";
}

TEST_F(Presets, AreSearchedRenamedAndRemovedAndAllIsTakenBack) {
  keepCloth();
  search("rus");
  untilCards("others are hidden", {"Rust check"}, {"Denim"});
  duplicate("Rust check");
  editor.click(card("Rust check 2"));
  editor.click("presets.name");
  editor.key("ctrl+a");
  editor.type("Rusty");
  editor.click("presets.rename");
  untilCards("it has another name", {"Rusty"}, {"Rust check 2"});
  editor.click(card("Rusty"));
  editor.click("presets.remove");
  untilCards("it is removed", {}, {"Rusty"});
  editor.click("presets.undo");
  untilCards("undo brings it back", {"Rusty"});
  editor.click("presets.undo");
  untilCards("undo takes the name back", {"Rust check 2"}, {"Rusty"});
}

/// A designer's own cloth may be called as one is that came with the program, which lies behind it.
TEST(PresetsOfOneName, TheOneThatIsClickedIsMeant) {
  HeadlessEditor editor;
  Fabric cloth = rustCheck();
  cloth.name = "Denim";
  editor.start(cloth);
  editor.key("ctrl+b");
  const std::string card = "presets.card/Denim";
  editor.centre(card);
  const HeadlessEditor::Rect alone = editor.rect(card);
  editor.click("presets.keep");
  editor.until("the cloth is kept", [&] { return !(editor.rect(card) == alone); });
  editor.click(card);
  EXPECT_EQ(editor.fact("presets.removable"), "no") << "it came with the program";
  editor.edits("the other cloth is used", [&] { editor.click("presets.use"); });
  EXPECT_NE(editor.saved().ends_per_cm, 14);
}

/// Where the name is taken, it is another one.
TEST_F(Presets, WhatIsRenamedStaysChosen) {
  keepCloth();
  search("rus");
  duplicate("Rust check");
  const auto rename = [&](const std::string& name) {
    editor.click(card(name));
    editor.click("presets.name");
    editor.key("ctrl+a");
    editor.type("Rusty");
    editor.click("presets.rename");
  };
  rename("Rust check 2");
  untilCards("it has the name", {"Rusty"}, {"Rust check 2"});
  rename("Rust check");
  untilCards("the name is taken", {"Rusty", "Rusty 2"}, {"Rust check"});
  editor.click("presets.remove");
  untilCards("the one that was renamed is removed", {"Rusty"}, {"Rusty 2"});
}

/// Also what came with the program is tagged, and the tags go with what they are of.
TEST_F(Presets, TagsAreSearchedAndDuplicated) {
  keepCloth();
  duplicate("Rust check");
  for (const char* name : {"Denim", "Rust check 2"}) tag(name, "winter, client A");
  search("winter");
  untilCards("tags are searched", {"Denim", "Rust check 2"}, {"Rust check", "Sheer silk"});
  duplicate("Rust check 2");
  editor.click("presets.undo");
  editor.click("presets.undo");
  untilCards("undo takes the tags off", {"Denim"}, {"Rust check 2"});
}

/// Of what is removed no tag is left for another of that name, until it is brought back.
TEST_F(Presets, TagsGoWithWhatTheyAreOf) {
  keepCloth();
  search("rust");
  tag("Rust check", "autumn");
  const auto untilTagged = [&](const std::string& what, const std::string& tags) {
    editor.until(what, [&] { return tagsOf("Rust check") == tags; });
  };
  untilTagged("it is tagged", "autumn");
  editor.click("presets.remove");
  untilTagged("its tags go with it", "");
  editor.click("presets.undo");
  untilTagged("they come back with it", "autumn");
  untilCards("it comes back", {"Rust check"});
}

TEST_F(Presets, AYarnIsUsed) {
  editor.click("presets.kind/Yarns");
  search("silk 20");
  untilCards("yarns are found", {"Silk 20/22 den"});
  use("Silk 20/22 den");
  EXPECT_EQ(editor.fact("dirty"), "yes") << "the cloth has another yarn";
  editor.click("tab.cloth");
  editor.until("it is of silk", [&] { return editor.fact("cloth.warp_count") == "2.3 tex"; });
  editor.key("ctrl+z");
  editor.until("undo takes it out", [&] { return editor.fact("dirty") == "no"; });
}

/// Those of a cloth that came with the program, and the designer's own, which bring them back.
TEST_F(Presets, ColoursAreUsed) {
  editor.click("presets.kind/Colours");
  search("");
  editor.click("presets.keep");
  untilCards("the cloth's colours are kept", {"Rust check", "Denim"});
  editor.edits("the cloth is dyed", [&] { use("Denim"); });
  EXPECT_NE(editor.saved().fibres[0].absorption_per_mm, Rgb(4, 14, 30));
  editor.key("ctrl+b");
  editor.edits("its own colours come back", [&] { use("Rust check"); });
  EXPECT_EQ(editor.saved().fibres[0].absorption_per_mm, Rgb(4, 14, 30));
}

TEST_F(Presets, AClothIsUsedAndKeptFromTheMenu) {
  search("denim");
  use("Denim");
  editor.until("the cloth is denim", [&] { return editor.fact("name") == "Denim"; });
  editor.click("menu.file");
  editor.click("menu.save_preset");
  editor.until("the editor says so",
               [&] { return editor.fact("message").find("\"Denim\" is among the presets now.") != std::string::npos; });
  editor.answer();
}

}  // namespace
}  // namespace loomlight
