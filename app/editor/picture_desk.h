#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "app/workers/mailbox.h"
#include "app/workers/raster.h"
#include "app/workers/task_queue.h"
#include "core/fabric/fabric.h"
#include "core/fabric/picture_weave.h"
#include "core/fabric/structure_edit.h"
#include "render/film/image.h"
#include "ui/picture_dialog.h"

namespace loomlight {

/// Reads pictures and weaves them on a thread of its own: a hundred million pixels take seconds. What was asked for
/// last is what counts.
class PictureDesk {
 public:
  explicit PictureDesk(std::function<void()> wake);

  void read(const std::string& file);
  /// In the place of the fabric's weave.
  void weave(PictureOrder order, std::shared_ptr<const Fabric> fabric, const LoomLimits& limits);
  /// Whatever comes of it is no longer wanted. A picture that is being decoded is decoded to its end, which takes
  /// seconds at most (readPng() has a limit); nothing else is done with it, and of those that wait none is read.
  void forget() { ++wanted_; }

  /// What has come, once: one of the three.
  struct Result {
    std::shared_ptr<const PictureSource> source;
    std::optional<Rewoven> woven;
    std::string problem;
  };
  std::optional<Result> take();

 private:
  using StillWanted = std::function<bool()>;
  void post(std::function<Result(const StillWanted&)> work);

  std::function<void()> wake_;
  std::atomic<uint64_t> wanted_ = 0;
  Mailbox<std::pair<uint64_t, Result>> results_;
  TaskQueue tasks_;  // last: it ends before what its tasks use is gone
};

}  // namespace loomlight
