/// The cloth handed over to other programs: in a folder that is chosen, in all colourways, cancelled, refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/fabric/model/colourways.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

class HandOver : public testing::Test {
 protected:
  HandOver() {
    Fabric cloth = smallCloth("Blue");
    cloth.colourways = {colourwayOf(cloth, "Rust")};
    editor.start(cloth);
  }
  void ask(const std::string& folder, const std::string& samples) {
    editor.click("menu.file");
    editor.click("menu.handover");
    editor.until("its size is known", [&] { return editor.fact("handover.size_mm").ends_with("mm"); });
    editor.click("handover.twist/Off");
    editor.enter("handover.size", "32");
    editor.enter("handover.samples", samples);
    editor.enter("handover.measure", "2");
    editor.enter("handover.folder", folder);
  }
  void close() {
    editor.click("handover.close");
    editor.untilNoDialogIsOpen();
    EXPECT_EQ(editor.fact("dirty"), "no") << "a hand-over is no edit of the cloth";
  }
  bool isThere(const std::string& file) const { return std::filesystem::exists(editor.home() / file); }

  HeadlessEditor editor{{1280, 1000, 1}};
};

TEST_F(HandOver, WritesAllFormatsInEveryColourwayWhereItIsTold) {
  ask(editor.homeFile("elsewhere"), "1");
  editor.click("handover.colourways/On");
  std::filesystem::create_directories(editor.home() / "maker");
  editor.click("handover.browse");
  editor.nameFile(editor.homeFile("maker"));
  editor.click("handover.start");
  editor.until("it is written", [&] { return editor.fact("handover.outcome").starts_with("Written"); });
  EXPECT_NE(editor.fact("handover.outcome").find(" % behind (RMS)"), std::string::npos) << "how far off the fit is";
  close();
  for (const char* ending : {".u3m", ".u3ma", ".glb", "_back.glb", ".mtlx", "_back.mtlx", ".handover.json"}) {
    EXPECT_TRUE(isThere(std::string("maker/Blue") + ending)) << ending;
    EXPECT_TRUE(isThere(std::string("maker/Rust/Blue_Rust") + ending)) << ending;
  }
  EXPECT_FALSE(isThere("elsewhere"));
  const auto told = nlohmann::json::parse(readFile(editor.homeFile("maker/Blue.handover.json"), 1'000'000));
  EXPECT_EQ(std::max(told["width_px"].get<int>(), told["height_px"].get<int>()), 32);
  EXPECT_FALSE(told["twist_joins"].get<bool>());
}

TEST_F(HandOver, CancelLeavesNothing) {
  ask(editor.homeFile("given up"), "65536");
  editor.click("handover.start");
  editor.until("it runs", [&] { return editor.fact("handover.outcome") == "running"; });
  editor.click("handover.close");
  editor.until("it has ended", [&] { return editor.fact("handover.outcome").starts_with("Cancelled"); });
  EXPECT_FALSE(isThere("given up"));
  close();
}

TEST_F(HandOver, SaysWhatIsInTheWay) {
  std::ofstream(editor.homeFile("file")) << "in the way";
  ask(editor.homeFile("file"), "1");
  editor.click("handover.start");
  editor.until("it is said",
               [&] { return editor.fact("handover.outcome").find("a folder that can be made") != std::string::npos; });
  close();
}

TEST_F(HandOver, ReplacesByItsButtonAlone) {
  std::filesystem::create_directories(editor.home() / "before");
  std::ofstream(editor.homeFile("before/Blue.handover.json")) << "{}";
  ask(editor.homeFile("before"), "1");
  editor.key("Return");
  for (int i = 0; i < 6; ++i) editor.frame();
  EXPECT_EQ(editor.fact("handover.outcome"), "") << "Enter has begun to replace what is there";
  close();
}

}  // namespace
}  // namespace loomlight
