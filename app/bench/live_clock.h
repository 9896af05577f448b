#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "app/live/live_renderer.h"
#include "core/base/stopwatch.h"

namespace loomlight {

/// How long a LiveRenderer, driven as the window drives it, takes to answer an edit. All from the moment of the edit.
struct LiveTimes {
  double volume_s = 0;  ///< to the scene with its volume
  double coarse_s = 0;  ///< to the first picture of it, however coarse
  double sample_s = 0;  ///< to one sample of every pixel; 0 where nobody waited for it
  double build_s = 0;   ///< what the builder itself took for the volume; 0 where it is the one before
  uint64_t bricks = 0;  ///< voxelised for it
};

/// An editor without a window: sends fabrics to a LiveRenderer of its own, and looks at what it shows when it is woken.
class LiveClock {
 public:
  /// Pixels of the picture; threads as LiveRenderer has them.
  LiveClock(int width, int height, int threads);

  /// Waits for the first picture of the fabric and for its volume, or for one sample of every pixel. nullopt when
  /// stopped. Throws InputError where the fabric cannot be shown.
  std::optional<LiveTimes> show(const Fabric& fabric, bool wholeSample, const std::stop_token& stop);
  /// Sends one fabric after another at this interval, however long they take. Returns how long each of them waited for
  /// its own picture or a later one, in seconds; empty when stopped.
  std::vector<double> play(std::span<const Fabric> fabrics, double interval_s, const std::stop_token& stop);

  /// Sends the fabric and tells `look` of every picture of it that is shown within so many seconds, and when; of the
  /// first one however late it is. False when stopped.
  bool watch(const Fabric& fabric, double seconds,
             const std::function<void(std::shared_ptr<const Frame> shown, double since_s)>& look,
             const std::stop_token& stop);
  /// Sends one fabric after another at this interval, as a mouse does that moves, and tells `look` of every picture of
  /// them that is shown meanwhile: of which, and how long after the first was sent. False when stopped.
  bool drag(std::span<const Fabric> steps, double interval_s,
            const std::function<void(std::shared_ptr<const Frame> shown, size_t step, double since_s)>& look,
            const std::stop_token& stop);

  LiveStatus status() const { return renderer_.status(); }
  void shareLight(bool wanted) { renderer_.shareLight(wanted); }
  void pause(bool paused) { renderer_.pause(paused); }

 private:
  void send(const Fabric& fabric);
  /// Looks after every wake, until done() or the time is over; false when stopped.
  template <class Done>
  bool lookUntil(const Done& done, double seconds, const std::stop_token& stop);

  int width_, height_;
  uint64_t generation_ = 0;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  bool news_ = false;
  LiveRenderer renderer_;  // last: it wakes the others
};

}  // namespace loomlight
