#include "app/export/cloth_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/weave/jacquard.h"
#include "core/fabric/weave/structures.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::StartsWith;

/// Coarse white fibres in an open twill, which are soon traced.
Fabric openCloth() {
  Fabric fabric;
  fabric.name = "Open \xE2\x80\x9Ctwill\xE2\x80\x9D";
  fabric.description = "Woven as it comes.";
  fabric.weave = twill(2, 1);
  fabric.ends_per_cm = 4;
  fabric.picks_per_cm = 5;
  fabric.yarns[0].fibresPerPly = 20;
  fabric.yarns[0].layout = FibreLayout::random;
  fabric.fibres[0].radius_um = 40;
  fabric.render.resolution = 1;
  return fabric;
}

class ClothSheet : public testing::Test {
 protected:
  std::string write(const Fabric& fabric, const std::string& name = "sheet.pdf") {
    ClothSheetOptions options;
    options.samplesPerPixel = 1;
    const std::string file = (folder_.path() / name).string();
    EXPECT_TRUE(writeClothSheet(file, fabric, options, {}));
    return readFile(file, 50'000'000);
  }
  test::ScratchFolder folder_;
};

TEST_F(ClothSheet, IsAPage) {
  Fabric fabric = openCloth();
  fabric.colourways = {colourwayOf(fabric, "Moss")};
  EXPECT_THAT(write(fabric), StartsWith("%PDF-"));
}

TEST_F(ClothSheet, TakesAJacquardAndSixtyYarns) {
  Fabric fabric = openCloth();
  fabric.weave = damaskJacquard(400, 300);
  fabric.yarns.resize(60, fabric.yarns[0]);
  fabric.warpSequence.clear();
  for (int i = 0; i < 60; ++i) fabric.warpSequence.insert(fabric.warpSequence.end(), 7, i);
  EXPECT_THAT(write(fabric), StartsWith("%PDF-"));
}

TEST_F(ClothSheet, IsAPdfAndNothingElse) {
  EXPECT_THROW(writeClothSheet((folder_.path() / "sheet.txt").string(), openCloth(), {}, {}), InputError);
}

TEST_F(ClothSheet, WhatIsStoppedLeavesNoFile) {
  std::stop_source stopped;
  stopped.request_stop();
  Task task;
  task.stop = stopped.get_token();
  const std::string file = (folder_.path() / "sheet.pdf").string();
  EXPECT_FALSE(writeClothSheet(file, openCloth(), {}, task));
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace loomlight
