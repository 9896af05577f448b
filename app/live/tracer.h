#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/live/preview_policy.h"
#include "app/live/refinement.h"
#include "app/live/turns.h"
#include "render/display/difference.h"

namespace loomlight {

/// What the truth lens shows. Both parts are immutable and may be shared with the one before.
struct LensFrame {
  std::shared_ptr<const Frame> fibres;
  std::shared_ptr<const Difference> difference;  ///< null while unknown
};

/// Refines pictures of the newest scene on a thread of its own: the viewport's, and beside it, in turns and with the
/// same threads, the truth lens's. At least one pass of each scene is shown before the next takes its place, so that a
/// steady drag moves the picture. No call here waits (destruction does: one path).
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
    Phase picture = Phase::idle, lens = Phase::idle;
    double pathsPerSecond = 0;  ///< of the viewport's picture
    std::string error;          ///< of the newest scene
  };

  /// `wake` is called when there is something new to show.
  Tracer(std::function<void()> wake, int threads);
  ~Tracer();

  /// A scene to show. One of the same generation and size as the one before only shows the same better: the old picture
  /// gives way sample by sample. One that differs in colour alone is shown at once, as converged as
  /// the old picture, from the paths of that; it stays until a picture traced anew has as little noise. The paths kept
  /// for it take at most 256 MB, and as much again while there are two pictures.
  void show(Request request);
  /// Where the lens is; null: it is closed.
  void lens(std::optional<PixelRect> window);
  /// What the lens looks at; null pointers: nothing yet. Used with every scene of the same cloth.
  void fibres(Traceable laid);
  void pause(bool paused);  ///< the picture stays
  /// Whether frames have a copy with less noise for the display. The lens has none: it is there for the truth.
  void denoise(bool wanted);
  /// Whether the next pictures show light that repeats of the cloth share (render/share); they do unless told
  /// otherwise.
  void shareLight(bool wanted);

  std::shared_ptr<const Frame> frame() const;
  std::shared_ptr<const LensFrame> lensFrame() const;  ///< null while there is nothing to show in it
  State state() const;

 private:
  /// What has been asked for since the thread last looked.
  struct News {
    std::optional<Request> request;
    std::optional<std::optional<PixelRect>> lens;
    std::optional<Traceable> fibres;
    std::optional<bool> denoise, share;
    bool empty() const { return !request && !lens && !fibres && !denoise && !share; }
  };

  void loop(const std::stop_token& stop);
  bool goOn(News news);  ///< one pass; false when there is nothing to do
  void take(News news);
  void begin(Request request);
  bool recolour(const Request& request);
  std::shared_ptr<const Frame> newestFrame() const;
  void beginPicture(double secondsPerPath, std::unique_ptr<SharedLight> light, const Changes& edit);
  Frame cleared(Frame fresh) const;
  void changeDenoising(bool wanted);
  bool worthShowing() const;
  std::shared_ptr<Frame> framed(Frame frame) const;
  void showPicture();
  void openLens();
  void tracePicture();
  void traceLens();
  void showLens();
  std::optional<Task> beginPass(const Refinement& refinement);
  void publish();
  void lookForDifference();
  Contender contender(const std::optional<Refinement>& refinement, double spentBefore) const;
  void giveUp(const std::string& reason);
  void interrupt();  ///< with the mutex held

  std::function<void()> wake_;
  int threads_;

  mutable std::mutex mutex_;
  std::condition_variable_any arrived_;
  News news_;
  State state_;
  std::shared_ptr<const Frame> frame_;
  std::shared_ptr<const LensFrame> lensFrame_;
  std::stop_source passStop_;
  bool passMayBeCancelled_ = false;  ///< not before the scene's first pass has been shown
  bool paused_ = false, ending_ = false;

  // The thread's own:
  Request request_;
  std::optional<Refinement> picture_, lens_;
  std::optional<PixelRect> lensWindow_;
  Traceable fibres_;
  bool denoised_ = false, shared_ = true;
  std::optional<Refinement> dyed_;  ///< the old picture, shown in other colours until picture_ is as good
  double varianceToBeat_ = 0;       ///< of it
  double spentBeforeLens_s_ = 0;    ///< on the picture, before the lens was opened
  double lensSecondsPerPath_ = 0;   ///< of the last lens
  /// The last picture with samples at full resolution, and of what: while crossings alone change, or the viewport's
  /// size, its pixels stand in.
  std::shared_ptr<const Frame> clear_;
  std::shared_ptr<const Fabric> clearFabric_;
  ClearHelp clearHelp_ = ClearHelp::none;        ///< of it for the picture under way
  std::shared_ptr<const Frame> picturePending_;  ///< traced, not shown yet
  std::shared_ptr<const Frame> lensPending_;
  std::shared_ptr<const Difference> difference_;

  std::jthread thread_;  // last: it stops before what it uses is gone
};

}  // namespace loomlight
