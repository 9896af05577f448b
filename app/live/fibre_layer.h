#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/live/refinement.h"
#include "app/live/worker.h"
#include "render/scene/fibre_extent.h"

namespace loomlight {

/// Lays the explicit fibres of the newest cloth on a thread of its own, for the reference inset: brick by brick, or
/// where a cloth is of too many kinds of cells for that, all in one. Says beforehand what they will take, and refuses
/// where that is more than it may be. No call here waits (destruction does, for what it stops). lay() and clear() are
/// called one at a time.
class FibreLayer {
 public:
  struct Status {
    enum class Phase { none, laying, laid, tooLarge, failed };
    Phase phase = Phase::none;
    double progress = 0;
    FibreSize size;     ///< as estimated, before anything is laid
    std::string error;  ///< what else went wrong
  };

  /// Called from the thread: `wake` when status() has changed, `deliver` with what is laid, and with null pointers as
  /// soon as that is no longer wanted. Nothing of it is kept here.
  FibreLayer(std::function<void()> wake, std::function<void(Traceable)> deliver, int threads);

  /// Fibres of this scene's cloth are wanted from now on. Those that are there or under way are kept if they are its
  /// own.
  void lay(std::shared_ptr<const Scene> scene, double limit_bytes);
  /// None are wanted.
  void clear();

  Status status() const;

 private:
  struct Wish {
    std::shared_ptr<const Scene> scene;  ///< null: none
    double limit_bytes = 0;
  };
  using Laying = Worker<Wish, Status>;
  void post(Wish wish);
  std::optional<Status> fulfil(const Wish& wish, const Laying::Job& job);

  std::function<void(Traceable)> deliver_;
  int threads_;
  Wish newest_;
  Laying worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
