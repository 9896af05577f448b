#include "app/export/handover/cloth_handover.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "core/base/error.h"
#include "core/fabric/model/colourways.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/handover/two_sided_cloth.h"

namespace loomlight {
namespace {

DigitalClothOrder few() {
  DigitalClothOrder order;
  order.longestSide = 32;
  order.joinTwist = false;
  order.measuringSamples = 2;
  order.fitSamples = 4;
  return order;
}

Fabric fewSamples() {
  Fabric fabric = test::twoSidedCloth();
  fabric.name = "Check";
  fabric.render.samplesPerPixel = 1;
  return fabric;
}

/// Names that differ for people may be one and the same as those of files.
TEST(ClothHandover, EveryColourwayHasAFolderOfItsOwn) {
  Fabric fabric = fewSamples();
  fabric.colourways = {colourwayOf(fabric, "Sea/sky"), colourwayOf(fabric, "Sea sky")};
  fabric.colourways[1].absorption_per_mm[0] = Rgb(7);
  const auto parts = handoverParts(fabric, "out", true);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(handoverSidecar(parts[0].fabric, parts[0].folder), "out/Check.handover.json");
  EXPECT_EQ(handoverSidecar(parts[1].fabric, parts[1].folder), "out/Sea_sky/Check_Sea_sky.handover.json");
  EXPECT_EQ(handoverSidecar(parts[2].fabric, parts[2].folder), "out/Sea_sky_2/Check_Sea_sky.handover.json");
  EXPECT_EQ(parts[0].fabric.fibres[0].absorption_per_mm, fabric.fibres[0].absorption_per_mm);
  EXPECT_EQ(parts[2].fabric.fibres[0].absorption_per_mm, Rgb(7));
  EXPECT_EQ(handoverParts(fabric, "out", false).size(), 1u);
}

TEST(ClothHandover, FoldersOfColourwaysDifferByMoreThanCapitals) {
  Fabric fabric = fewSamples();
  for (const char* name : {"Sea", "Textures", "sea"}) fabric.colourways.push_back(colourwayOf(fabric, name));
  std::vector<std::string> folders;
  for (const HandoverPart& part : handoverParts(fabric, "out", true)) folders.push_back(part.folder);
  EXPECT_EQ(folders, (std::vector<std::string>{"out", "out/Sea", "out/Textures_2", "out/sea_2"}));
}

TEST(ClothHandover, AStopLeavesNoFolderThatWasNotThere) {
  const test::ScratchFolder folder;
  std::stop_source stop;
  Task task;
  task.stop = stop.get_token();
  task.progress = [&stop](double) { stop.request_stop(); };
  EXPECT_FALSE(handOver({fewSamples(), folder.file("new")}, few(), 1e9, task));
  EXPECT_EQ(folder.entries(), 0u);
  EXPECT_FALSE(handOver({fewSamples(), folder.path().string()}, few(), 1e9, task));
  EXPECT_TRUE(std::filesystem::is_directory(folder.path())) << "it was there before";
}

TEST(ClothHandover, WhatCannotBeWrittenIsSaidBeforeAnyWork) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("file")) << "in the way";
  std::filesystem::create_directories(folder.file("taken/Check.handover.json"));
  std::filesystem::create_directories(folder.file("taken texture/textures/Check_back_BASE.png"));
  std::filesystem::create_directories(folder.file("no folder"));
  std::ofstream(folder.file("no folder/textures")) << "in the way of a folder";
  std::filesystem::create_directories(folder.file("lost link"));
  std::filesystem::create_symlink("nowhere", folder.file("lost link/textures"));
  bool worked = false;
  Task task;
  task.progress = [&worked](double) { worked = true; };
  for (const char* in : {"file", "file/under", "taken", "taken texture", "no folder", "lost link"})
    EXPECT_THROW(handOver({fewSamples(), folder.file(in)}, few(), 1e9, task), InputError) << in;
  EXPECT_FALSE(worked);
}

}  // namespace
}  // namespace loomlight
