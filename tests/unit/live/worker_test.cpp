#include "app/live/worker.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <latch>
#include <new>
#include <stdexcept>
#include <thread>

#include "tests/support/wakes.h"

namespace loomlight {
namespace {

using Numbers = Worker<int, int>;

int failedAs(const int& request, const std::string&) {
  return -request;
}

/// Brings what it was asked for; work on 0 first waits to be let go.
class Doubtful {
 public:
  explicit Doubtful(Backlog backlog)
      : worker(
            wakes.callback(),
            [this](int request, auto&) {
              if (request == 0) {
                begun.count_down();
                letGo.wait();
              }
              done.push_back(request);
              return request;
            },
            failedAs, backlog) {}

  std::optional<int> brought() {
    std::optional<int> come;
    wakes.until([&] { return (come = worker.take()).has_value(); });
    return come;
  }

  Wakes wakes;
  std::latch begun{1}, letGo{1};
  std::vector<int> done;  ///< the thread's, until it has brought what is looked for
  Numbers worker;
};

TEST(Worker, BringsWhatItWasAskedForOnce) {
  Doubtful of(Backlog::newest);
  of.worker.ask(7);
  EXPECT_EQ(of.brought(), 7);
  EXPECT_EQ(of.worker.take(), std::nullopt);
  EXPECT_TRUE(of.worker.isTaken());
  of.worker.ask(8);  // on another thread, once the first had nothing left to do
  EXPECT_EQ(of.brought(), 8);
}

TEST(Worker, OfWhatWaitsOnlyTheNewestIsDone) {
  Doubtful of(Backlog::newest);
  of.worker.ask(0);
  of.begun.wait();
  EXPECT_FALSE(of.worker.isWaiting());
  for (int i = 1; i < 20; ++i) of.worker.ask(i);
  EXPECT_TRUE(of.worker.isWaiting());
  of.letGo.count_down();
  ASSERT_TRUE(of.wakes.until([&] { return of.worker.newest() == 19; }));
  EXPECT_EQ(of.worker.take(), 19);
  EXPECT_EQ(of.done, (std::vector<int>{0, 19}));
}

// ThreadSanitizer sees where the answer is read without its lock.
TEST(Worker, MayBeAskedWhetherItWaitsAtAnyMoment) {
  Doubtful of(Backlog::every);
  for (int i = 1; i <= 200; ++i) of.worker.ask(i);
  while (of.worker.isWaiting()) std::this_thread::yield();
  int last = 0;
  ASSERT_TRUE(of.wakes.until([&] {
    while (const std::optional<int> come = of.worker.take()) last = *come;
    return last == 200;
  }));
  EXPECT_EQ(of.done.size(), 200u);
}

TEST(Worker, DoesEverythingInOrderBeforeItEnds) {
  std::vector<int> done;
  std::latch begun{1}, letGo{1};
  {
    Numbers worker(
        {},
        [&](int request, auto&) {
          if (request == 0) {
            begun.count_down();
            letGo.wait();
          }
          done.push_back(request);
          return request;
        },
        failedAs, Backlog::every);
    for (int i = 0; i < 50; ++i) worker.ask(i);
    begun.wait();
    EXPECT_EQ(worker.take(), std::nullopt);
    letGo.count_down();
  }
  ASSERT_EQ(done.size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<size_t>(i)], i);
}

TEST(Worker, KeepsEveryResultWhereEveryRequestCounts) {
  Doubtful of(Backlog::every);
  for (int i = 1; i < 4; ++i) of.worker.ask(i);
  for (int i = 1; i < 4; ++i) EXPECT_EQ(of.brought(), i);
}

// One that ends the thread ends the program.
TEST(Worker, WhateverIsThrownIsAResult) {
  Wakes wakes;
  std::vector<std::string> problems;
  Worker<int, std::string> worker(
      wakes.callback(),
      [](int request, auto&) -> std::string {
        if (request == 1) throw std::bad_alloc();
        if (request == 2) throw std::runtime_error("a.json: no cloth");
        if (request == 3) throw 3;
        return "done";
      },
      [](int, const std::string& problem) { return problem; }, Backlog::every);
  for (int i = 1; i <= 4; ++i) worker.ask(i);
  ASSERT_TRUE(wakes.until([&] {
    while (auto come = worker.take()) problems.push_back(*come);
    return problems.size() == 4;
  }));
  EXPECT_EQ(problems[0], "It needs more memory than there is.");
  EXPECT_EQ(problems[1], "a.json: no cloth");
  EXPECT_FALSE(problems[2].empty());
  EXPECT_EQ(problems[3], "done");
}

TEST(Worker, GoesOnWhereNotEvenTheProblemCanBeSaid) {
  Wakes wakes;
  Numbers worker(
      wakes.callback(),
      [](int request, auto&) {
        if (request == 1) throw std::bad_alloc();
        return request;
      },
      [](int, const std::string&) -> int { throw std::bad_alloc(); }, Backlog::every);
  worker.ask(1);
  worker.ask(2);
  EXPECT_TRUE(wakes.until([&] { return worker.take() == 2; }));
}

TEST(Worker, CancelStopsTheWorkThatMayStillSayHowFarItCame) {
  Wakes wakes;
  std::latch begun{1};
  Numbers worker(
      wakes.callback(),
      [&](int request, Numbers::Job& job) {
        begun.count_down();
        job.rest(std::chrono::hours(1));  // ends with the stop
        return job.isStopped() ? request : 0;
      },
      failedAs);
  worker.ask(3);
  begun.wait();
  worker.cancel();
  EXPECT_TRUE(wakes.until([&] { return worker.take() == 3; }));
}

TEST(Worker, NothingComesOfWhatIsForgotten) {
  Doubtful of(Backlog::every);  // which keeps every result that counts
  of.worker.ask(0);
  of.begun.wait();
  of.worker.ask(1);
  of.worker.forget();
  EXPECT_FALSE(of.worker.isWaiting());
  of.worker.ask(2);
  of.letGo.count_down();
  EXPECT_EQ(of.brought(), 2);
  EXPECT_EQ(of.done, (std::vector<int>{0, 2}));
  of.worker.ask(3);
  ASSERT_TRUE(of.wakes.until([&] { return !of.worker.isTaken(); }));
  of.worker.forget();
  EXPECT_EQ(of.worker.take(), std::nullopt) << "though it had come";
}

TEST(Worker, TheEndStopsWorkThatNobodyWillSee) {
  std::latch begun{1};
  std::atomic<bool> stopped = false;
  {
    Numbers worker(
        {},
        [&](int request, Numbers::Job& job) {
          begun.count_down();
          job.rest(std::chrono::hours(1));
          stopped = job.isStopped();
          return request;
        },
        failedAs);
    worker.ask(1);
    begun.wait();
    worker.ask(2);
  }
  EXPECT_TRUE(stopped);
}

// A bake goes on for another colour of the same yarns, and gives way to other yarns.
TEST(Worker, WorkMayServeANewerRequestOrGiveWayToIt) {
  Wakes wakes;
  std::latch asked{1};
  Numbers worker(
      wakes.callback(),
      [&](int request, Numbers::Job& job) -> std::optional<int> {
        if (request != 1) return request;
        job.bring(1);
        asked.wait();
        const auto newer = job.takeNewer();
        if (!newer) return std::nullopt;
        job.giveWayTo(*newer);
        EXPECT_TRUE(job.isStopped());
        EXPECT_FALSE(job.takeNewer()) << "a job that is over takes nothing from the next";
        return std::nullopt;
      },
      failedAs, Backlog::newest);
  worker.ask(1);
  ASSERT_TRUE(wakes.until([&] { return worker.newest() == 1; })) << "what is brought on the way";
  worker.ask(2);
  asked.count_down();
  EXPECT_TRUE(wakes.until([&] { return worker.newest() == 2; }));
}

TEST(Worker, GivesWayToTheNewestOfAll) {
  Wakes wakes;
  std::latch begun{1}, first{1}, taken{1}, second{1};
  Numbers worker(
      wakes.callback(),
      [&](int request, Numbers::Job& job) -> std::optional<int> {
        if (request != 1) return request;
        begun.count_down();
        first.wait();
        const auto newer = job.takeNewer();
        taken.count_down();
        second.wait();
        if (newer) job.giveWayTo(*newer);
        return std::nullopt;
      },
      failedAs);
  worker.ask(1);
  begun.wait();
  worker.ask(2);
  first.count_down();
  taken.wait();
  worker.ask(3);
  second.count_down();
  ASSERT_TRUE(wakes.until([&] { return !worker.isTaken(); }));
  EXPECT_EQ(worker.take(), 3);
}

TEST(Worker, WhatHangsHoldsUpNeitherTheNextNorTheEnd) {
  // All that hanging work uses outlives its worker.
  const auto hanging = std::make_shared<std::latch>(1);
  const std::shared_ptr<std::latch> begun[] = {std::make_shared<std::latch>(1), std::make_shared<std::latch>(1)};
  std::atomic<int> wakes = 0;
  Wakes came;
  {
    Numbers worker(
        [&, wake = came.callback()] {
          ++wakes;
          wake();
        },
        [hanging, first = begun[0], second = begun[1]](int request, auto&) {
          if (request < 3) {
            (request == 1 ? first : second)->count_down();
            hanging->wait();
          }
          return request;
        },
        failedAs, Backlog::hanging);
    worker.ask(1);
    begun[0]->wait();
    worker.ask(2);
    begun[1]->wait();
    worker.ask(3);
    ASSERT_TRUE(came.until([&] { return wakes == 1; }));
    EXPECT_EQ(worker.take(), 3);
  }
  EXPECT_EQ(wakes, 1);
  hanging->count_down();  // only now: the end has not waited for it
}

TEST(Worker, NoMoreThanAFewHangAtOnce) {
  const auto hanging = std::make_shared<std::latch>(1);
  const auto begun = std::make_shared<std::atomic<int>>(0);
  Wakes wakes;
  Numbers worker(
      wakes.callback(),
      [hanging, begun](int request, auto&) {
        ++*begun;
        hanging->wait();
        return request;
      },
      failedAs, Backlog::hanging);
  for (int i = 0; i < 20; ++i) worker.ask(i);
  hanging->count_down();
  ASSERT_TRUE(wakes.until([&] { return worker.newest() == 19; }));
  EXPECT_LE(*begun, 4) << "three at once, and the last";
}

// Freeing a scene takes a while; nobody who only asks may wait for it.
TEST(Worker, IsOpenWhileWhatItDropsDies) {
  std::latch begun{1}, letGo{1};
  bool sawTheNewOne = false;
  Worker<std::shared_ptr<void>, int> worker(
      {},
      [&](const std::shared_ptr<void>& request, auto&) {
        if (!request) {
          begun.count_down();
          letGo.wait();
        }
        return 0;
      },
      [](const auto&, const std::string&) { return 0; });
  worker.ask(nullptr);
  begun.wait();
  worker.ask(std::shared_ptr<void>(nullptr, [&](void*) { sawTheNewOne = worker.isWaiting(); }));
  worker.ask(std::make_shared<int>(1));
  EXPECT_TRUE(sawTheNewOne);
  letGo.count_down();
}

#ifdef __linux__
TEST(Worker, WorkInTheBackgroundLetsOthersGoFirst) {
  const int own = getpriority(PRIO_PROCESS, 0);
  for (const auto priority : {Priority::background, Priority::picture}) {
    Wakes wakes;
    Numbers worker(
        wakes.callback(), [](int, auto&) { return getpriority(PRIO_PROCESS, 0); }, failedAs, Backlog::newest, priority);
    worker.ask(1);
    ASSERT_TRUE(wakes.until([&] { return !worker.isTaken(); }));
    EXPECT_EQ(worker.take(), priority == Priority::picture ? own : 10);
  }
}
#endif

}  // namespace
}  // namespace loomlight
