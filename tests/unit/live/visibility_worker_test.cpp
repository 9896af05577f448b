#include "app/live/visibility_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/worker_window.h"

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
  const VisibilityWorker* told = nullptr;
  std::shared_ptr<const BakedVisibility> first;  // as its own thread tells: whoever only looks may come too late
  const auto take = [&, wake = window.waker()] {
    if (!first) first = told->newest();
    wake();
  };
  VisibilityWorker worker(take, kFew, kNoCache);
  told = &worker;
  EXPECT_EQ(worker.newest(), nullptr);
  worker.request(twoYarns(), 1);
  ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
  ASSERT_NE(first, nullptr);
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
    const VisibilityWorker* told = nullptr;
    std::atomic<uint64_t> lenders = std::numeric_limits<uint64_t>::max();  // the bake of the yarns that lend
    std::shared_ptr<const BakedVisibility> first;                          // of the next, as its own thread tells
    const auto take = [&, wake = window.waker()] {
      const auto newest = told->newest();
      if (!first && newest && newest->bake > lenders) first = newest;
      wake();
    };
    auto worker = std::make_unique<VisibilityWorker>(take, kFewer, cache);
    told = worker.get();
    worker->request(twoYarns(20), 0);
    ASSERT_TRUE(window.waitFor([&] { return finished(*worker); }));
    if (fromDisk) {
      worker.reset();
      worker = std::make_unique<VisibilityWorker>(take, kFewer, cache);
      told = worker.get();
    }
    lenders = worker->newest() ? worker->newest()->bake : 0;
    worker->request(twoYarns(22), 0);
    ASSERT_TRUE(window.waitFor([&] {
      const auto newest = worker->newest();
      return newest && newest->bake > lenders && finished(*worker);
    }));
    ASSERT_NE(first, nullptr);
    EXPECT_FALSE(first->finished);
    EXPECT_LT(first->rays, worker->newest()->rays);
    const auto straight = bakeBvdf(*twoYarns(22), kFewer, kNoCache, Task{});
    for (size_t i = 0; i < 2; ++i)
      EXPECT_TRUE(sameRatios(straight->tables[i], worker->newest()->tables->tables[i])) << "no trace of what was lent";
  }
}

double distance(const BvdfSet& a, const BvdfSet& b) {
  double squares = 0;
  size_t count = 0;
  for (size_t table = 0; table < a.tables.size(); ++table)
    for (size_t bin = 0; bin < a.tables[table].ratios().size(); ++bin, ++count)
      squares += std::pow(a.tables[table].ratios()[bin] - b.tables[table].ratios()[bin], 2);
  return std::sqrt(squares / static_cast<double>(count));
}

// No stage is a leap: each is nearer to the next than what was borrowed is to the end, and what is borrowed fades.
TEST(VisibilityWorker, APictureGoesFromBorrowedTablesToItsOwnInSmallSteps) {
  constexpr BvdfOptions kLong{{4, 4, 8, 16}, 300'000};
  Window window;
  const VisibilityWorker* shown = nullptr;
  std::vector<std::shared_ptr<const BakedVisibility>> stages;  // of the second bake: all, as its own thread tells
  const auto take = [&, wake = window.waker()] {
    const auto newest = shown->newest();
    if (newest && newest->bake > 1 && (stages.empty() || worthTaking(*newest, *stages.back())))
      stages.push_back(newest);
    wake();
  };
  VisibilityWorker worker(take, kLong, kNoCache);
  shown = &worker;
  worker.request(twoYarns(20), 0);
  ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
  ASSERT_EQ(worker.newest()->bake, 1u);
  worker.request(twoYarns(60), 0);
  ASSERT_TRUE(window.waitFor([&] { return worker.newest()->bake > 1 && finished(worker); }));
  ASSERT_GE(stages.size(), 3u) << "what is borrowed, what comes first of its own, and the end";
  const BvdfSet& end = *stages.back()->tables;
  const double leap = distance(*stages.front()->tables, end);
  for (size_t i = 1; i < stages.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_GT(stages[i]->rays, stages[i - 1]->rays);
    EXPECT_LT(distance(*stages[i]->tables, *stages[i - 1]->tables), leap);
    EXPECT_LE(distance(*stages[i]->tables, end), distance(*stages[i - 1]->tables, end));
  }
}

TEST(VisibilityWorker, EndsOnTheSameTablesByWhateverWay) {
  Window window;
  std::vector<std::shared_ptr<const BvdfSet>> ends;
  for (const std::vector<double>& way : {std::vector<double>{30}, {20, 30}, {45, 30}}) {
    VisibilityWorker worker(window.waker(), kFew, kNoCache);
    for (const double count_tex : way) {
      const uint64_t before = worker.newest() ? worker.newest()->bake : 0;
      worker.request(twoYarns(count_tex), 0);
      // One bake is broken off.
      ASSERT_TRUE(window.waitFor([&] {
        const auto newest = worker.newest();
        return newest && newest->bake > before && (newest->finished || count_tex == 45);
      }));
    }
    ASSERT_TRUE(window.waitFor([&] { return finished(worker); }));
    ends.push_back(worker.newest()->tables);
  }
  for (const auto& end : ends) EXPECT_TRUE(end->tables == ends[0]->tables);
}

TEST(WorthTaking, IsWhatIsOfOtherYarnsOrClearlyBetter) {
  const auto set = std::make_shared<const BvdfSet>();
  const auto baked = [](uint64_t bake, uint64_t rays, bool finished,
                        const std::shared_ptr<const BvdfSet>& tables = nullptr) {
    BakedVisibility made;
    made.tables = tables ? tables : std::make_shared<const BvdfSet>();
    made.bake = bake;
    made.rays = rays;
    made.finished = finished;
    return made;
  };
  EXPECT_TRUE(worthTaking(baked(2, 0, false), baked(1, 1000, true)));
  EXPECT_FALSE(worthTaking(baked(2, 0, false, set), baked(1, 1000, true, set))) << "the very tables";
  EXPECT_TRUE(worthTaking(baked(2, 100, false), baked(2, 0, false)));
  EXPECT_FALSE(worthTaking(baked(2, 399, false), baked(2, 100, false)));
  EXPECT_TRUE(worthTaking(baked(2, 400, false), baked(2, 100, false)));
  EXPECT_TRUE(worthTaking(baked(2, 401, true), baked(2, 400, false)));
  EXPECT_FALSE(worthTaking(baked(2, 401, true), baked(2, 401, true)));
  const auto doubled = std::make_shared<BvdfSet>();
  doubled->tableOfYarn = {0, 0};
  EXPECT_TRUE(worthTaking(baked(2, 401, true, doubled), baked(2, 401, true))) << "numbered anew";
}

}  // namespace
}  // namespace loomlight
