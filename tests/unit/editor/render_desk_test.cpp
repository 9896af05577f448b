#include "app/editor/desks/render_desk.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace loomlight {
namespace {

/// Whether it was written. Only looks: what brings the end is the work's own.
bool waitForEnd(RenderDesk& desk) {
  for (;;) {
    if (const auto written = desk.follow()) return *written;
    std::this_thread::yield();
  }
}

TEST(RenderDesk, SaysWhatWasWritten) {
  RenderDesk desk;
  desk.start([](const Task&) { return std::optional<std::string>("Written: a.png"); });
  EXPECT_TRUE(desk.isRunning());
  EXPECT_TRUE(waitForEnd(desk));
  EXPECT_FALSE(desk.isRunning());
  EXPECT_EQ(desk.progress().outcome, "Written: a.png");
  EXPECT_FALSE(desk.progress().failed);
}

TEST(RenderDesk, SaysWhyNothingWasWritten) {
  RenderDesk desk;
  desk.start([](const Task&) -> std::optional<std::string> { throw std::runtime_error("a.png: disk full"); });
  EXPECT_FALSE(waitForEnd(desk));
  EXPECT_TRUE(desk.progress().failed);
  EXPECT_EQ(desk.progress().outcome, "a.png: disk full");
}

TEST(RenderDesk, TellsHowFarItIsAndCanBeCancelled) {
  RenderDesk desk;
  std::promise<void> halfWay;
  desk.start([&halfWay](const Task& task) -> std::optional<std::string> {
    task.report(0.5);
    halfWay.set_value();
    while (!task.stopped()) std::this_thread::yield();
    return std::nullopt;
  });
  halfWay.get_future().wait();
  EXPECT_EQ(desk.follow(), std::nullopt);
  EXPECT_EQ(desk.progress().fraction, 0.5);
  EXPECT_TRUE(desk.isRunning());
  desk.cancel();
  EXPECT_FALSE(waitForEnd(desk));
  EXPECT_FALSE(desk.progress().failed);
}

TEST(RenderDesk, ItsEndCancelsTheWork) {
  std::atomic<bool> stopped = false;
  std::promise<void> begun;
  {
    RenderDesk desk;
    desk.start([&](const Task& task) -> std::optional<std::string> {
      begun.set_value();
      while (!task.stopped()) std::this_thread::yield();
      stopped = true;
      return std::nullopt;
    });
    begun.get_future().wait();
  }
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace loomlight
