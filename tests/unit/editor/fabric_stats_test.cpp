#include "app/editor/services/fabric_stats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <new>

#include "app/editor/controllers/status_model.h"
#include "app/editor/model/sample_fabric.h"
#include "core/fabric/weave/turned_over.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

TEST(FabricStatsWorker, TooLittleMemoryIsSaidAndTheNextClothIsKnownAgain) {
  Wakes wakes;
  const auto fits = std::make_shared<const Fabric>(sampleFabric());
  auto tooLarge = std::make_shared<Fabric>(sampleFabric());
  tooLarge->name = "too large";
  FabricStatsWorker worker(wakes.callback(), [](const Fabric& fabric) {
    if (fabric.name == "too large") throw std::bad_alloc();
    FabricStats stats;
    stats.floats.warpFace = 77;
    return stats;
  });
  worker.request(fits, 0, nullptr);
  ASSERT_TRUE(wakes.until([&] { return worker.newest() != nullptr; }));
  worker.request(tooLarge, 0, nullptr);
  ASSERT_TRUE(wakes.until([&] { return !worker.problem().empty(); }));
  EXPECT_EQ(worker.problem(), "It needs more memory than there is.");
  EXPECT_EQ(worker.newest()->fabric, fits) << "what was known before is still shown";
  worker.request(fits, 0, nullptr);
  EXPECT_TRUE(wakes.until([&] { return worker.problem().empty(); }));
  EXPECT_EQ(worker.newest()->floats.warpFace, 77);
}

TEST(YarnSection, ShowsEveryFibreOnceInsideTheYarn) {
  Fabric fabric = sampleFabric();
  fabric.weave = Weave({{1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 1, 1}});
  fabric.ends_per_cm = 10;
  fabric.crowding = 3;  // its axis is not in the middle of its cell
  for (FibreLayout layout : {FibreLayout::random, FibreLayout::packed}) {
    Yarn& yarn = fabric.yarns[0];
    yarn.layout = layout;
    yarn.hairiness_per_mm = 0;
    yarn.plies = 3;
    yarn.yarnTwist_per_m = 400;
    yarn.fibresPerPly = 37;
    const YarnSection section = yarnSection(ClothGeometry(fabric, 4, 4), fabric, 0);
    EXPECT_EQ(section.points.size(), 3u * 37u);
    for (const YarnSection::Point& point : section.points) {
      EXPECT_LT(std::abs(point.at_mm.x), 1.05 * section.halfWidth_mm);
      EXPECT_LT(std::abs(point.at_mm.y), 1.05 * section.halfHeight_mm);
    }
  }
}

TEST(FabricStatsWorker, AnswersTheNewestRequest) {
  Wakes wakes;
  FabricStatsWorker worker(wakes.callback());
  std::shared_ptr<const Fabric> last;
  for (int i = 0; i < 20; ++i) {
    Fabric fabric = sampleFabric();
    fabric.ends_per_cm = 20 + i;
    last = std::make_shared<const Fabric>(std::move(fabric));
    worker.request(last, 0, nullptr);
  }
  EXPECT_TRUE(wakes.until([&] {
    const auto newest = worker.newest();
    return newest && newest->fabric == last;
  }));
}

// The section is of the fibres that the cloth was built of, and follows an edit when the cloth does.
TEST(FabricStatsWorker, TheSectionIsThatOfTheClothThatWasBuilt) {
  Wakes wakes;
  FabricStatsWorker worker(wakes.callback());
  const auto fabric = std::make_shared<const Fabric>(sampleFabric());
  const auto scene = makeScene(fabric, Task{});
  worker.request(fabric, 0, nullptr);
  ASSERT_TRUE(wakes.until([&] { return worker.newest() != nullptr; }));
  EXPECT_FALSE(worker.newest()->section);
  worker.request(fabric, 0, scene);
  ASSERT_TRUE(wakes.until([&] { return worker.newest()->section.has_value(); }));
  const ClothGeometry& cloth = scene->cloth->volume->geometry();
  const size_t fibres = cloth.yarns().model(System::warp, cloth.geometryClass(System::warp, 0)).fibreCount();
  const size_t points = worker.newest()->section->points.size();
  EXPECT_GE(points, fibres) << "each fibre of the body, and perhaps hairs";

  Fabric edited = *fabric;
  edited.yarns[0].fibresPerPly = 2 * edited.yarns[0].fibresPerPly.value();
  const auto next = std::make_shared<const Fabric>(edited);
  worker.request(next, 0, nullptr);
  ASSERT_TRUE(wakes.until([&] { return worker.newest()->fabric == next; }));
  EXPECT_EQ(worker.newest()->section->points.size(), points) << "as it was, until the cloth is built";
  worker.request(next, 0, makeScene(next, Task{}, scene.get()));
  EXPECT_TRUE(wakes.until([&] { return worker.newest()->section->points.size() > points; }));
}

/// The back of a cloth has its ends in the opposite order: its first is another yarn.
TEST(FabricStatsWorker, TheSectionIsOfTheSameYarnFromTheBack) {
  Fabric fabric = sampleFabric();
  fabric.yarns[0].hairiness_per_mm = 0;
  fabric.yarns[0].plies = 2;
  fabric.yarns[0].fibresPerPly = 20;
  const int thicker = static_cast<int>(fabric.yarns.size());
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns.back().fibresPerPly = 60;
  fabric.weave = Weave({{1, 0, 1, 0}, {0, 1, 0, 1}});
  fabric.draft.reset();
  fabric.warpSequence = {0, 0, 0, thicker};
  const auto front = std::make_shared<const Fabric>(fabric);
  for (const auto& seen : {front, std::make_shared<const Fabric>(turnedOver(fabric))}) {
    Wakes wakes;
    FabricStatsWorker worker(wakes.callback());
    worker.request(front, 0, makeScene(seen, Task{}));
    ASSERT_TRUE(wakes.until([&] { return worker.newest() && worker.newest()->section; }));
    EXPECT_EQ(worker.newest()->section->points.size(), 2u * 20u);
  }
}

/// Peirce's formula knows nothing of how yarns lie; it is the geometry that is asked.
TEST(StatusModel, SaysWhatYarnsCoverAsTheyLie) {
  FabricStats stats;
  stats.fabric = std::make_shared<const Fabric>();
  LiveStatus status;
  status.measures.thickness_mm = 0.3;
  status.measures.cover = 0.75;
  EXPECT_DOUBLE_EQ(statusModel(&stats, status, {}, nullptr).coverPercent, 75);
}

TEST(YarnSection, OfAYarnThatTheClothDoesNotUseIsThatOfPlainCloth) {
  Fabric fabric = sampleFabric();
  const ClothGeometry cloth(fabric, 4, 4);
  fabric.yarns.push_back(fabric.yarns[0]);
  const YarnSection section = yarnSection(cloth, fabric, static_cast<int>(fabric.yarns.size()) - 1);
  EXPECT_GT(section.points.size(), 10u);
  EXPECT_GT(section.halfWidth_mm, 0);
}

}  // namespace
}  // namespace loomlight
