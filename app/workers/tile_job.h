#pragma once

#include <memory>
#include <string>
#include <thread>

#include "core/fabric/fabric.h"

namespace loomlight {

/// Makes the maps of a tile (tile.h) on a thread of its own. Cancelling writes nothing; the destructor cancels and
/// waits for one path.
class TileJob {
 public:
  TileJob(std::shared_ptr<const Fabric> fabric, std::string stem, int longestSide, int samplesPerPixel);
  void cancel() { thread_.request_stop(); }
  struct State {
    bool finished = false;
    double progress = 0;
    std::string outcome;  ///< once it is finished: what was written, or why nothing was
    bool failed = false;
  };
  State state() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace loomlight
