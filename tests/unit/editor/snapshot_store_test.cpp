#include "app/editor/services/snapshot_store.h"

#include <gtest/gtest.h>

#include "app/editor/model/sample_fabric.h"
#include "tests/support/memory_driver.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

class SnapshotStoreTest : public testing::Test {
 protected:
  /// A picture that does not compress: 30 kB.
  static std::string keep(SnapshotStore& store) {
    constexpr int kSide = 100;
    Pixels8 picture{kSide, kSide, 3, {}};
    uint32_t noise = 1;
    for (int i = 0; i < 3 * kSide * kSide; ++i)
      picture.bytes.push_back(static_cast<uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24));
    return store.keep(std::make_shared<const Fabric>(sampleFabric()), {}, std::move(picture));
  }
  static std::vector<std::string> shown(const SnapshotStore& store) {
    std::vector<std::string> ids;
    for (const SnapshotItem& item : store.items()) ids.push_back(item.id);
    return ids;
  }

  MemoryDriver driver_;
  Wakes wakes_;
  test::ScratchFolder folder_;
};

TEST_F(SnapshotStoreTest, AViewIsMeantWhereverItLies) {
  SnapshotStore store(folder_.path(), driver_, wakes_.callback(), {2, 1'000'000});
  keep(store);
  const std::string second = keep(store), third = keep(store);
  EXPECT_EQ(shown(store), (std::vector<std::string>{second, third})) << "the oldest goes";
  EXPECT_EQ(store.view(third).id, third);
  store.remove(second);
  EXPECT_EQ(shown(store), std::vector<std::string>{third});
}

/// What lasts no longer is shown no longer.
TEST_F(SnapshotStoreTest, WhatThereIsNoRoomForOnTheDiskLeavesTheStrip) {
  SnapshotStore store(folder_.path(), driver_, wakes_.callback(), {100, 100'000});
  std::string last;
  for (int i = 0; i < 5; ++i) last = keep(store);
  EXPECT_TRUE(wakes_.until([&] {
    store.follow();
    return shown(store).size() <= 3;
  }));
  EXPECT_EQ(shown(store).back(), last);
}

}  // namespace
}  // namespace loomlight
