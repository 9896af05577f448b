#include "app/editor/services/render_service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace loomlight {
namespace {

/// Whether it was written. Only looks: what brings the end is the work's own.
bool waitForEnd(RenderService& service) {
  for (;;) {
    if (const auto written = service.follow()) return *written;
    std::this_thread::yield();
  }
}

TEST(RenderService, SaysWhatWasWritten) {
  RenderService service;
  service.start([](const Task&) { return std::optional<std::string>("Written: a.png"); });
  EXPECT_TRUE(service.isRunning());
  EXPECT_TRUE(waitForEnd(service));
  EXPECT_FALSE(service.isRunning());
  EXPECT_EQ(service.progress().outcome, "Written: a.png");
  EXPECT_FALSE(service.progress().failed);
}

TEST(RenderService, SaysWhyNothingWasWritten) {
  RenderService service;
  service.start([](const Task&) -> std::optional<std::string> { throw std::runtime_error("a.png: disk full"); });
  EXPECT_FALSE(waitForEnd(service));
  EXPECT_TRUE(service.progress().failed);
  EXPECT_EQ(service.progress().outcome, "a.png: disk full");
}

TEST(RenderService, TellsHowFarItIsAndCanBeCancelled) {
  RenderService service;
  std::promise<void> halfWay;
  service.start([&halfWay](const Task& task) -> std::optional<std::string> {
    task.report(0.5);
    halfWay.set_value();
    while (!task.stopped()) std::this_thread::yield();
    return std::nullopt;
  });
  halfWay.get_future().wait();
  EXPECT_EQ(service.follow(), std::nullopt);
  EXPECT_EQ(service.progress().fraction, 0.5);
  EXPECT_TRUE(service.isRunning());
  service.cancel();
  EXPECT_FALSE(waitForEnd(service));
  EXPECT_FALSE(service.progress().failed);
}

TEST(RenderService, ItsEndCancelsTheWork) {
  std::atomic<bool> stopped = false;
  std::promise<void> begun;
  {
    RenderService service;
    service.start([&](const Task& task) -> std::optional<std::string> {
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
