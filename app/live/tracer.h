#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/live/booth_view.h"
#include "app/live/pass_scheduler.h"
#include "app/live/preview_policy.h"
#include "app/live/refinement.h"
#include "app/live/worker.h"
#include "render/display/difference.h"

namespace loomlight {

/// What the reference inset shows. Both pictures are immutable and may be shared with the one before.
struct InsetFrame {
  std::shared_ptr<const Frame> fibres;
  std::shared_ptr<const Difference> difference;  ///< null while unknown
};

/// Refines pictures of the newest scene on a thread of its own: the viewport's, and beside it, pass by pass and with
/// the same threads, the inset's. At least one pass of each scene is shown before the next takes its place, so
/// that a steady drag moves the picture. No call here waits (destruction does: one path).
class Tracer {
 public:
  struct Request {
    Traceable cloth;
    int width = 0, height = 0;
    uint64_t generation = 0;
    bool sketch = false;  ///< of what there is of a cloth that is still being built
  };
  struct State {
    enum class Phase { idle, tracing, converged };
    Phase picture = Phase::idle, inset = Phase::idle;
    std::string error;  ///< of the newest scene
  };

  /// `wake` is called when there is something new to show.
  Tracer(std::function<void()> wake, int threads);

  /// A scene to show. One of the same generation and size as the one before only shows the same better: the old picture
  /// gives way sample by sample. One that differs in colour alone is shown at once, as converged as
  /// the old picture, from the paths of that; it stays until a picture traced anew has as little noise. The paths kept
  /// for it take at most 256 MB, twice that until its first fine pass is done, and as much again while there are two
  /// pictures.
  void show(Request request);
  /// Where the inset is; null: it is closed.
  void inset(std::optional<PixelRect> window);
  /// What the inset looks at; null pointers: nothing yet. Used with every scene of the same cloth.
  void fibres(Traceable laid);
  void pause(bool paused);  ///< the picture stays
  /// Whether frames have a copy with less noise for the display. The inset has none: it is there for the truth.
  void denoise(bool wanted);
  /// Samples a pixel at which pictures rest, until something else is to be seen.
  void restAt(uint32_t samples);
  /// Whether frames are divided, to be seen under the lamps of a booth.
  void booth(bool wanted);
  /// Whether the next pictures show light that repeats of the cloth share (render/share); they do unless told
  /// otherwise.
  void shareLight(bool wanted);

  std::shared_ptr<const Frame> frame() const { return shown().frame; }
  std::shared_ptr<const InsetFrame> insetFrame() const { return shown().insetFrame; }  ///< null: nothing to show in it
  State state() const;

 private:
  /// All that has been asked for.
  struct Wanted {
    Request request;
    uint64_t requests = 0;  ///< that have come; the picture begins anew with each
    std::optional<PixelRect> inset;
    Traceable fibres;
    bool denoised = false, booth = false, shared = true, paused = false;
    uint32_t rest = kUsualRest;  ///< samples a pixel
  };
  struct Shown {
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const InsetFrame> insetFrame;
    State state;
    uint64_t requests = 0;  ///< that had come
  };
  using Tracing = Worker<Wanted, Shown>;

  template <class Change>
  void want(const Change& change);
  Shown shown() const { return worker_.newest().value_or(Shown{}); }

  // The thread's:
  void trace(const Wanted& wanted, const Tracing::Job& job);
  void take(const Wanted& wanted);
  bool mayGoOn(Subject next) const;
  Subject nextToTrace() const;
  void begin(const Request& before);
  bool recolour(const std::optional<Changes>& sincePicture);
  std::shared_ptr<const Frame> newestFrame() const;
  void beginPicture(double secondsPerPath, std::unique_ptr<SharedLight> light, const Changes& edit);
  Frame cleared(Frame fresh) const;
  void showOtherwise();
  bool worthShowing() const;
  std::shared_ptr<Frame> framed(Frame frame) const;
  std::shared_ptr<Frame> pictured(Frame frame) const;
  void showPicture();
  void showRecoloured();
  void openInset();
  void tracePicture(const std::stop_token& stop);
  void traceInset(const std::stop_token& stop);
  void showInset();
  std::optional<Task> beginPass(const Refinement& refinement, const std::stop_token& stop);
  void publish();
  void bring(const Tracing::Job& job);
  void lookForDifference();
  Shown givenUp(const std::string& reason);

  int threads_;

  mutable std::mutex mutex_;  ///< of the next two
  Wanted wanted_;
  bool passMayBeCancelled_ = false;  ///< not before the scene's first pass has been shown

  // The thread's own:
  Wanted taken_;  ///< what it works for
  Shown shown_;
  bool isNews_ = false;  ///< shown_ has changed since it was brought
  std::optional<Refinement> picture_, inset_;
  std::optional<Refinement> recoloured_;  ///< the old picture, shown in other colours until picture_ is as good
  Recolouring recolouring_;               ///< the colours that recoloured_ is shown in
  double varianceToBeat_ = 0;             ///< noise of recoloured_, which picture_ must not exceed to take its place
  double spentBeforeInset_s_ = 0;         ///< on the picture, before the inset was opened
  double insetSecondsPerPath_ = 0;        ///< of the last inset
  /// The last picture with detail of its own in this view, and of what: while crossings alone change, or the viewport's
  /// size, its pixels stand in.
  std::shared_ptr<const Frame> clear_;
  std::shared_ptr<const Fabric> clearFabric_;
  ClearHelp clearHelp_ = ClearHelp::none;  ///< of it for the picture under way
  /// The last picture that had detail of its own, and of what: while only the camera moves, it shows what the new one
  /// sees of it.
  std::shared_ptr<const Frame> detailed_;
  std::shared_ptr<const Fabric> detailedFabric_;
  std::optional<BoothView> booth_;               ///< where it is asked for
  std::shared_ptr<const Frame> picturePending_;  ///< traced, not shown yet
  std::shared_ptr<const Frame> insetPending_;
  std::shared_ptr<const Difference> difference_;

  Tracing worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
