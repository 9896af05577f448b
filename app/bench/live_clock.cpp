#include "app/bench/live_clock.h"

#include <chrono>
#include <limits>

#include "core/base/error.h"

namespace loomlight {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kForEver_s = 1e9;

}  // namespace

LiveClock::LiveClock(int width, int height, int threads)
    : width_(width),
      height_(height),
      renderer_(
          [this] {
            {
              std::lock_guard lock(mutex_);
              news_ = true;
            }
            woken_.notify_one();
          },
          threads) {}

void LiveClock::send(const Fabric& fabric) {
  renderer_.request({std::make_shared<const Fabric>(fabric), width_, height_, ++generation_, nullptr});
}

template <class Done>
bool LiveClock::lookUntil(const Done& done, double seconds, const std::stop_token& stop) {
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (!done()) {
    std::unique_lock lock(mutex_);
    const bool woken = woken_.wait_until(lock, stop, end, [this] { return news_; });
    if (stop.stop_requested()) return false;
    if (!woken) return true;
    news_ = false;
    lock.unlock();
    if (const std::string error = renderer_.status().error; !error.empty()) throw InputError(error);
  }
  return true;
}

std::optional<LiveTimes> LiveClock::show(const Fabric& fabric, bool wholeSample, const std::stop_token& stop) {
  LiveTimes times;
  const LiveStatus before = renderer_.status();
  const auto start = Clock::now();
  send(fabric);
  const auto done = [&] {
    const double now = secondsSince(start);
    if (times.volume_s == 0 && renderer_.status().builtGeneration >= generation_) times.volume_s = now;
    const auto frame = renderer_.frame();
    if (!frame || frame->generation < generation_) return false;
    if (times.coarse_s == 0) times.coarse_s = now;
    if (times.volume_s == 0 || frame->quality == PreviewQuality::sketch) return false;
    if (frame->samples == 0) return !wholeSample;
    times.sample_s = now;
    return true;
  };
  if (!lookUntil(done, kForEver_s, stop)) return std::nullopt;
  const LiveStatus after = renderer_.status();
  if (after.buildSeconds != before.buildSeconds) times.build_s = after.buildSeconds;
  times.bricks = after.bricksVoxelised - before.bricksVoxelised;
  return times;
}

std::vector<double> LiveClock::play(std::span<const Fabric> fabrics, double interval_s, const std::stop_token& stop) {
  std::vector<double> sent_s, waited_s;
  const uint64_t first = generation_ + 1;
  const auto start = Clock::now();
  const auto look = [&] {
    const auto frame = renderer_.frame();
    while (frame && waited_s.size() < sent_s.size() && frame->generation >= first + waited_s.size())
      waited_s.push_back(secondsSince(start) - sent_s[waited_s.size()]);
    return false;
  };
  for (const Fabric& fabric : fabrics) {
    const double due_s = interval_s * static_cast<double>(sent_s.size());
    if (!lookUntil(look, due_s - secondsSince(start), stop)) return {};
    sent_s.push_back(secondsSince(start));
    send(fabric);
  }
  const auto done = [&] { return look() || waited_s.size() == fabrics.size(); };
  return lookUntil(done, kForEver_s, stop) ? waited_s : std::vector<double>{};
}

bool LiveClock::drag(std::span<const Fabric> steps, double interval_s,
                     const std::function<void(std::shared_ptr<const Frame>, size_t, double)>& look,
                     const std::stop_token& stop) {
  const uint64_t first = generation_ + 1;
  const auto start = Clock::now();
  std::shared_ptr<const Frame> last;
  const auto lookAgain = [&] {
    auto frame = renderer_.frame();
    if (!frame || frame == last || frame->generation < first) return false;
    last = std::move(frame);
    look(last, last->generation - first, secondsSince(start));
    return false;
  };
  for (size_t sent = 0; sent < steps.size(); ++sent) {
    send(steps[sent]);
    const double next_s = interval_s * static_cast<double>(sent + 1);
    if (!lookUntil(lookAgain, next_s - secondsSince(start), stop)) return false;
  }
  return true;
}

bool LiveClock::watch(const Fabric& fabric, double seconds,
                      const std::function<void(std::shared_ptr<const Frame>, double)>& look,
                      const std::stop_token& stop) {
  const auto start = Clock::now();
  send(fabric);
  std::shared_ptr<const Frame> last;
  const auto seen = [&] {
    auto frame = renderer_.frame();
    if (frame && frame != last && frame->generation >= generation_) look(last = std::move(frame), secondsSince(start));
    return last != nullptr;
  };
  const auto never = [&] { return seen(), false; };
  return lookUntil(seen, kForEver_s, stop) && lookUntil(never, seconds - secondsSince(start), stop);
}

}  // namespace loomlight
