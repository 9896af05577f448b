#include "app/live/fetcher.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <vector>

namespace loomlight {
namespace {

/// What hangs until it is let go.
struct Hanging {
  std::promise<void> letGo;
  std::shared_future<void> gone{letGo.get_future()};
  std::shared_ptr<std::atomic<int>> begun = std::make_shared<std::atomic<int>>(0);

  Fetcher<int>::Fetch fetch(int value) const {
    return [value, gone = gone, begun = begun](const Fetcher<int>::StillWanted&) {
      ++*begun;
      gone.wait();
      return value;
    };
  }
};

void awaitBegun(const Hanging& hanging, int count) {
  while (*hanging.begun < count) std::this_thread::yield();
}

Fetcher<int>::Fetch quick(int value) {
  return [value](const Fetcher<int>::StillWanted&) { return value; };
}

std::optional<int> brought(Fetcher<int>& fetcher) {
  for (int i = 0; i < 2000; ++i) {
    if (auto come = fetcher.take()) return come;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return std::nullopt;
}

TEST(Fetcher, BringsWhatWasAskedForLastOnce) {
  std::promise<void> woken;
  Fetcher<int> fetcher([&woken] { woken.set_value(); });
  fetcher.ask(quick(7));
  woken.get_future().wait();
  EXPECT_EQ(fetcher.take(), 7);
  EXPECT_FALSE(fetcher.take());
}

TEST(Fetcher, WhatHangsHoldsUpNeitherTheNextNorTheEnd) {
  Hanging hanging;
  std::atomic<int> wakes = 0;
  {
    Fetcher<int> fetcher([&wakes] { ++wakes; });
    for (const int number : {1, 2}) {
      fetcher.ask(hanging.fetch(number));
      awaitBegun(hanging, number);
    }
    fetcher.ask(quick(3));
    EXPECT_EQ(brought(fetcher), 3);
  }
  EXPECT_EQ(wakes, 1);
  hanging.letGo.set_value();  // only now: the end has not waited for it
}

TEST(Fetcher, OfWhatWaitsOnlyTheLastIsBegun) {
  Hanging hanging;
  Fetcher<int> fetcher([] {});
  for (int i = 0; i < 20; ++i) fetcher.ask(hanging.fetch(i));
  hanging.letGo.set_value();
  EXPECT_EQ(brought(fetcher), 19);
  EXPECT_LE(*hanging.begun, 4) << "three at once, and the last";
}

TEST(Fetcher, WhatIsForgottenIsNoLongerWanted) {
  Hanging hanging;
  std::promise<bool> answer;
  Fetcher<int> fetcher([] {});
  fetcher.ask([&answer, wait = hanging.fetch(1)](const Fetcher<int>::StillWanted& stillWanted) {
    EXPECT_TRUE(stillWanted());
    const int value = wait(stillWanted);
    answer.set_value(stillWanted());
    return value;
  });
  awaitBegun(hanging, 1);
  fetcher.forget();
  hanging.letGo.set_value();
  EXPECT_FALSE(answer.get_future().get());
  EXPECT_FALSE(fetcher.take());
}

}  // namespace
}  // namespace loomlight
