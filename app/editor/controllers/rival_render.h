#pragma once

#include <optional>
#include <utility>

#include "app/editor/services/render_service.h"
#include "app/editor/services/view_service.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What a dialog renders into files. It takes the threads that the viewport's picture would, which rests meanwhile and
/// goes on however the work ends.
class RivalRender {
 public:
  explicit RivalRender(ViewService::Rival rival) : rival_(rival) {}

  /// In every frame. Once it is over, whether it was written.
  std::optional<bool> follow(Ui& ui, ViewService& seen) {
    if (isRunning()) ui.wakeWithin(0.1);
    const std::optional<bool> written = rendering_.follow();
    if (written) seen.pause(rival_, false);
    return written;
  }
  void start(RenderService::Work work, ViewService& seen) {
    seen.pause(rival_, true);
    rendering_.start(std::move(work));
  }
  bool isRunning() const { return rendering_.isRunning(); }
  void cancel() { rendering_.cancel(); }
  const RenderJob& progress() const { return rendering_.progress(); }
  /// What is said of the last one, when its dialog opens anew, or asks for another.
  void forget() { rendering_.forget(); }

 private:
  ViewService::Rival rival_;
  RenderService rendering_;
};

}  // namespace loomlight
