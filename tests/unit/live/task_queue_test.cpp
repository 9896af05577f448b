#include "app/live/task_queue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace loomlight {
namespace {

TEST(TaskQueue, DoesAllInOrderBeforeItEnds) {
  std::vector<int> done;
  {
    TaskQueue queue;
    for (int i = 0; i < 50; ++i)
      queue.post([&done, i] {
        if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));  // the others wait in line
        done.push_back(i);
      });
  }
  ASSERT_EQ(done.size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<size_t>(i)], i);
}

}  // namespace
}  // namespace loomlight
