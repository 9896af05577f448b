#include "app/editor/model/view_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/editor/model/sample_fabric.h"
#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

KeptView viewOf(const std::string& id, int side = 8) {
  KeptView view{id, std::make_shared<const Fabric>(sampleFabric()), {}, {side, side, 3, {}}};
  uint32_t noise = 1;
  for (int i = 0; i < 3 * side * side; ++i)
    view.picture.bytes.push_back(static_cast<uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24));
  return view;
}

TEST(ViewFolder, ViewsComeBackInTheirOrder) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("views"), {});
  EXPECT_TRUE(folder.ids().empty());
  const KeptView first = viewOf(ViewFolder::newId()), second = viewOf(ViewFolder::newId(), 9);
  folder.keep(second);
  folder.keep(first);
  EXPECT_EQ(folder.ids(), (std::vector<std::string>{first.id, second.id}));
  const KeptView back = folder.read(second.id);
  EXPECT_EQ(*back.fabric, *second.fabric);
  EXPECT_EQ(back.picture.width, 9);
  EXPECT_EQ(back.picture.bytes, second.picture.bytes);
  folder.remove(first.id);
  EXPECT_EQ(folder.ids(), std::vector<std::string>{second.id});
}

TEST(ViewFolder, ClothComesBackAsItWasLookedAt) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("views"), {});
  KeptView view = viewOf("view-a");
  FlatView flat{{false, 12.5}, {{125.0, 124.75}, {}}};
  flat.sight.camera.elevation_deg = 81.5;
  flat.sight.camera.distance_mm = 333.25;
  for (const ClothView& lookedAt : {ClothView{}, ClothView{false, flat}, ClothView{true, std::nullopt},
                                    ClothView{true, flat}, ClothView{false, std::nullopt, StandardIlluminant::ledB3}}) {
    view.lookedAt = lookedAt;
    folder.keep(view);
    const KeptView back = folder.read("view-a");
    EXPECT_EQ(back.lookedAt, lookedAt);
    EXPECT_EQ(*back.fabric, *view.fabric) << "the cloth keeps its own drape and camera";
  }
}

TEST(ViewFolder, FlatClothThatIsNoneIsRefused) {
  for (const char* text : {"", "{}", "[1]", R"({"in_repeats": true, "count": 1})",
                           R"({"in_repeats": true, "count": 0, "sight": {"loomlight_version": 1}})",
                           R"({"in_repeats": 1, "count": 1, "sight": {"loomlight_version": 1}})",
                           R"({"in_repeats": true, "count": 1, "sight": {"drape": {"width_mm": -1}}})"})
    EXPECT_THROW(flatViewFromJson(text, "a view"), InputError) << text;
}

TEST(ViewFolder, ASideOrALampThatIsNoneIsRefused) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("."), {});
  KeptView view = viewOf("view-a");
  view.lookedAt.back = true;
  view.lookedAt.judgedUnder = StandardIlluminant::f11;
  folder.keep(view);
  std::map<std::string, std::string> texts;
  const Pixels8 picture = readPng(scratch.file("view-a.png"), &texts);
  ASSERT_EQ(texts["loomlight.side"], "back");
  ASSERT_EQ(texts["loomlight.lamp"], "f11");
  for (const char* const key : {"loomlight.side", "loomlight.lamp"}) {
    std::map<std::string, std::string> broken = texts;
    broken[key] = "left";
    writePng(scratch.file("view-a.png"), picture, broken);
    EXPECT_THROW(folder.read("view-a"), InputError) << key;
  }
}

TEST(ViewFolder, OldestGoBeyondTheNumber) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("views"), {3, 1'000'000'000});
  for (const char* id : {"view-a", "view-b", "view-c", "view-d"}) folder.keep(viewOf(id));
  EXPECT_EQ(folder.keep(viewOf("view-e")), std::vector<std::string>{"view-b"});
  EXPECT_EQ(folder.ids(), (std::vector<std::string>{"view-c", "view-d", "view-e"}));
}

TEST(ViewFolder, OldestGoBeyondTheBytes) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("views"), {100, 100'000});  // noise does not compress: 30 kB each
  for (const char* id : {"view-a", "view-b", "view-c", "view-d", "view-e"}) folder.keep(viewOf(id, 100));
  EXPECT_EQ(folder.ids().back(), "view-e");
  EXPECT_LE(folder.ids().size(), 3u);
  EXPECT_GE(folder.ids().size(), 2u);
}

TEST(ViewFolder, WhatIsNoViewIsRefused) {
  const test::ScratchFolder scratch;
  const ViewFolder folder(scratch.file("."), {});
  std::ofstream(scratch.file("broken.png")) << "\x89PNG";
  Pixels8 plain{2, 2, 3, std::vector<uint8_t>(12)};
  writePng(scratch.file("plain.png"), plain);
  EXPECT_TRUE(folder.ids().empty()) << "a picture of somebody else's is left alone";
  EXPECT_THROW(folder.read("broken"), InputError);
  EXPECT_THROW(folder.read("plain"), InputError) << "it holds no fabric";
  EXPECT_THROW(folder.read("missing"), InputError);
}

}  // namespace
}  // namespace loomlight
