#include "app/workers/file_job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace loomlight {
namespace {

using Phase = FileJob::State::Phase;

FileJob::State waitForEnd(const FileJob& job) {
  FileJob::State state = job.state();
  while (state.phase == Phase::running) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    state = job.state();
  }
  return state;
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
  while (job.state().progress != 0.5) std::this_thread::yield();
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
