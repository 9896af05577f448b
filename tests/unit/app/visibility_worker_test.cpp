#include "app/workers/visibility_worker.h"

#include <gtest/gtest.h>

#include "tests/support/test_cloth.h"
#include "tests/unit/app/worker_window.h"
#include "tests/unit/film/scratch_folder.h"

namespace loomlight {
namespace {

using Window = test::WorkerWindow;
constexpr BvdfOptions kFew{{4, 4, 8, 16}, 100'000};  // its thread is a polite one: on a busy machine it gets little
const BvdfCache kNoCache{std::filesystem::path()};

std::shared_ptr<const Fabric> twoYarns(double count_tex = 20, float absorption = 0) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.fibres[0].radius_um = 20;  // few and coarse: quick to lay
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].count_tex = count_tex / 2;
  fabric.yarns[0].count_tex = count_tex;
  fabric.weftSequence = {1};
  fabric.fibres[0].absorption_per_mm = Rgb(absorption);
  return std::make_shared<const Fabric>(fabric);
}

bool finished(const VisibilityWorker& worker) {
  const auto newest = worker.newest();
  return newest && newest->finished && !worker.status().baking;
}

bool sameRatios(const Bvdf& a, const Bvdf& b) {
  return std::equal(a.ratios().begin(), a.ratios().end(), b.ratios().begin(), b.ratios().end());
}

TEST(VisibilityWorker, ShowsTablesEarlyAndEndsOnWhatTheBakerFinds) {
  Window window;
  VisibilityWorker worker(window.waker(), kFew, kNoCache);
  EXPECT_EQ(worker.newest(), nullptr);
  worker.request(twoYarns(), 1);
  ASSERT_TRUE(window.waitFor([&] { return worker.newest() != nullptr; }));
  const auto first = worker.newest();
  ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
  const auto last = worker.newest();
  EXPECT_LT(first->tables->rays, last->tables->rays);
  EXPECT_EQ(first->bake, last->bake);
  EXPECT_EQ(last->yarn, 1);
  EXPECT_EQ(last->picture.width, VisibilityWorker::kPictureColumns * last->picture.height / 2);
  const auto straight = bakeBvdf(*twoYarns(), kFew, kNoCache, Task{});
  ASSERT_EQ(straight->tables.size(), last->tables->tables.size());
  for (size_t i = 0; i < straight->tables.size(); ++i)
    EXPECT_TRUE(sameRatios(straight->tables[i], last->tables->tables[i]));
}

TEST(VisibilityWorker, AnotherYarnOrColourBakesNothing) {
  Window window;
  VisibilityWorker worker(window.waker(), kFew, kNoCache);
  worker.request(twoYarns(), 0);
  ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
  const auto before = worker.newest();
  worker.request(twoYarns(20, 5), 1);
  ASSERT_TRUE(window.waitFor([&] { return worker.newest()->yarn == 1; }));
  const auto after = worker.newest();
  EXPECT_EQ(after->bake, before->bake);
  EXPECT_TRUE(after->finished);
  EXPECT_NE(after->picture.bytes, before->picture.bytes);
}

TEST(VisibilityWorker, AnEditBeginsAnewAndTheNewestWins) {
  Window window;
  VisibilityWorker worker(window.waker(), kFew, kNoCache);
  worker.request(twoYarns(20), 0);
  ASSERT_TRUE(window.waitFor([&] { return worker.newest() != nullptr; }));
  const uint64_t first = worker.newest()->bake;
  worker.request(twoYarns(25), 0);
  worker.request(twoYarns(30), 0);
  ASSERT_TRUE(window.waitFor([&] { return finished(worker) && worker.newest()->bake > first; }));
  const auto straight = bakeBvdf(*twoYarns(30), kFew, kNoCache, Task{});
  EXPECT_TRUE(sameRatios(straight->tables[0], worker.newest()->tables->tables[0]));
}

TEST(VisibilityWorker, StopsWhenNothingIsWantedAndKeepsWhatWasBaked) {
  const test::ScratchFolder folder;
  const BvdfCache cache(folder.file(""));
  Window window;
  {
    VisibilityWorker worker(window.waker(), {{4, 4, 8, 16}, 500'000'000}, cache);
    worker.request(twoYarns(), 0);
    ASSERT_TRUE(window.waitFor([&] { return worker.newest() != nullptr; }));
    worker.request(nullptr, 0);
    ASSERT_TRUE(window.waitFor([&] { return !worker.status().baking; }));
    EXPECT_FALSE(worker.newest()->finished);
    worker.request(twoYarns(), 0);  // and ends in the middle of it
  }
  {
    VisibilityWorker worker(window.waker(), kFew, cache);
    worker.request(twoYarns(), 0);
    ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
  }
  VisibilityWorker worker(window.waker(), kFew, cache);
  worker.request(twoYarns(), 0);
  ASSERT_TRUE(window.waitFor([&] { return worker.newest() != nullptr; }));
  EXPECT_TRUE(worker.newest()->finished) << "out of the cache";
}

TEST(VisibilityWorker, LendsTheTablesOfTheMostSimilarYarnsAndEndsOnItsOwn) {
  constexpr BvdfOptions kFewer{{4, 4, 8, 16}, 100'000};
  const test::ScratchFolder folder;
  for (const bool fromDisk : {false, true}) {
    SCOPED_TRACE(fromDisk);
    const BvdfCache cache(fromDisk ? std::filesystem::path(folder.file("")) : std::filesystem::path());
    Window window;
    auto worker = std::make_unique<VisibilityWorker>(window.waker(), kFewer, cache);
    worker->request(twoYarns(20), 0);
    ASSERT_TRUE(window.waitFor([&] { return finished(*worker); }));
    const auto similar = worker->newest()->tables;
    if (fromDisk) worker = std::make_unique<VisibilityWorker>(window.waker(), kFewer, cache);
    std::shared_ptr<const BakedVisibility> first;
    worker->request(twoYarns(22), 0);
    ASSERT_TRUE(window.waitFor([&] {
      const auto newest = worker->newest();
      if (!first && newest && newest->tables != similar) first = newest;
      return first && finished(*worker) && worker->newest()->tables != similar;
    }));
    EXPECT_FALSE(first->finished);
    const auto straight = bakeBvdf(*twoYarns(22), kFewer, kNoCache, Task{});
    for (size_t i = 0; i < 2; ++i)
      EXPECT_TRUE(sameRatios(straight->tables[i], worker->newest()->tables->tables[i])) << "no trace of what was lent";
  }
}

}  // namespace
}  // namespace loomlight
