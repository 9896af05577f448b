#include "app/export/file_job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace loomlight {
namespace {

using Phase = FileJob::State::Phase;

/// Whether it comes true within a generous minute.
template <class Condition>
bool comes(Condition&& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

FileJob::State waitForEnd(const FileJob& job) {
  EXPECT_TRUE(comes([&job] { return job.state().phase != Phase::running; }));
  return job.state();
}

TEST(FileJob, SaysWhatWasWritten) {
  const FileJob job([](const Task&) { return std::optional<std::string>("Written: a.png"); });
  const FileJob::State state = waitForEnd(job);
  EXPECT_EQ(state.phase, Phase::written);
  EXPECT_EQ(state.outcome, "Written: a.png");
}

TEST(FileJob, SaysWhyNothingWasWritten) {
  const FileJob job([](const Task&) -> std::optional<std::string> { throw std::runtime_error("a.png: disk full"); });
  const FileJob::State state = waitForEnd(job);
  EXPECT_EQ(state.phase, Phase::failed);
  EXPECT_EQ(state.outcome, "a.png: disk full");
}

TEST(FileJob, TellsHowFarItIsAndCanBeCancelled) {
  FileJob job([](const Task& task) -> std::optional<std::string> {
    task.report(0.5);
    while (!task.stopped()) std::this_thread::yield();
    return std::nullopt;
  });
  ASSERT_TRUE(comes([&job] { return job.state().progress == 0.5; }));
  EXPECT_EQ(job.state().phase, Phase::running);
  job.cancel();
  EXPECT_EQ(waitForEnd(job).phase, Phase::cancelled);
}

TEST(FileJob, ItsEndCancelsTheWork) {
  std::atomic<bool> stopped = false;
  {
    const FileJob job([&stopped](const Task& task) -> std::optional<std::string> {
      while (!task.stopped()) std::this_thread::yield();
      stopped = true;
      return std::nullopt;
    });
  }
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace loomlight
