#include "app/editor/services/snapshot_store.h"

#include <gtest/gtest.h>

#include <atomic>

#include "app/editor/model/sample_fabric.h"
#include "tests/support/full_disk.h"
#include "tests/support/memory_driver.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

class SnapshotStoreTest : public testing::Test {
 protected:
  /// A picture that does not compress: 30 kB.
  static std::string keep(SnapshotStore& store, int side = 100) {
    Pixels8 picture{side, side, 3, {}};
    uint32_t noise = 1;
    for (int i = 0; i < 3 * side * side; ++i)
      picture.bytes.push_back(static_cast<uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24));
    return store.keep(std::make_shared<const Fabric>(sampleFabric()), {}, std::move(picture));
  }
  static std::vector<std::string> shown(const SnapshotStore& store) {
    std::vector<std::string> ids;
    for (const SnapshotItem& item : store.items()) ids.push_back(item.id);
    return ids;
  }

  void untilAllIsWell(SnapshotStore& store) {
    EXPECT_TRUE(wakes_.until([&] {
      store.follow();
      return store.problem().empty();
    }));
  }
  void untilAViewWillNotLast(SnapshotStore& store) {
    EXPECT_TRUE(wakes_.until([&] {
      store.follow();
      return !store.problem().empty();
    }));
  }
  std::vector<std::string> onDisk() const { return ViewFolder(folder_.path(), {}).ids(); }

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

constexpr int kNoMoreThanASmallOne = 20'000;  // bytes

/// That there is room for another one is no comfort; once there is room for both, both are kept.
TEST_F(SnapshotStoreTest, AViewThatFindsNoRoomIsToldOfUntilItHasFoundSome) {
  std::atomic<int> done = 0;
  SnapshotStore store(folder_.path(), driver_, [&, wake = wakes_.callback()] {
    ++done;
    wake();
  });
  std::string large, small;
  {
    const test::FullDisk full(kNoMoreThanASmallOne);
    large = keep(store);
    small = keep(store, 10);
    EXPECT_TRUE(wakes_.until([&] { return done >= 2; }));
    store.follow();
    EXPECT_NE(store.problem().find("File too large"), std::string::npos) << "the other one is kept";
    // The large one is tried once more, and then no more.
    EXPECT_TRUE(wakes_.until([&] { return done >= 3; }));
    store.follow();
    EXPECT_NE(store.problem(), "");
    EXPECT_EQ(onDisk(), std::vector<std::string>{small});
  }
  const std::string last = keep(store, 10);
  untilAllIsWell(store);
  EXPECT_EQ(onDisk(), (std::vector<std::string>{large, small, last}));
}

TEST_F(SnapshotStoreTest, AViewThatFoundNoRoomIsTriedOnceMoreAtTheEnd) {
  std::string view;
  {
    SnapshotStore store(folder_.path(), driver_, wakes_.callback());
    const test::FullDisk full(kNoMoreThanASmallOne);  // it has room again before the store ends
    view = keep(store);
    untilAViewWillNotLast(store);
  }
  EXPECT_EQ(onDisk(), std::vector<std::string>{view});
}

TEST_F(SnapshotStoreTest, AViewThatIsRemovedNeedsNoRoom) {
  SnapshotStore store(folder_.path(), driver_, wakes_.callback());
  const test::FullDisk full(kNoMoreThanASmallOne);
  const std::string view = keep(store);
  untilAViewWillNotLast(store);
  store.remove(view);
  EXPECT_EQ(store.problem(), "");
}

}  // namespace
}  // namespace loomlight
