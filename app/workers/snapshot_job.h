#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/fabric/fabric.h"
#include "render/film/image.h"
#include "render/film/tone.h"

namespace loomlight {

/// Renders a fabric's own RenderSettings to a file (.exr with AOVs and metadata, or .png) on a thread of its own.
/// Cancelling keeps nothing; the destructor cancels and waits for one path.
class SnapshotJob {
 public:
  /// What is particular to a .png.
  struct Print {
    std::function<Pixels8(Pixels8)> finish;  ///< makes of the display's pixels what is written; empty: these themselves
    double dpi = 0;                          ///< its size on paper; 0: none
  };
  SnapshotJob(std::shared_ptr<const Fabric> fabric, std::string file, Tone tone, Print print);
  ~SnapshotJob();
  void cancel();
  struct State {
    bool finished = false;
    bool cancelled = false;
    double progress = 0;
    std::string error;  ///< empty when all went well
  };
  State state() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace loomlight
