#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "app/live/pass_scheduler.h"
#include "core/base/task.h"
#include "render/display/frame.h"
#include "render/display/picture_buckets.h"
#include "render/display/recolour.h"
#include "render/display/stand_in.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"
#include "render/share/moved_view.h"
#include "render/share/shared_light.h"

namespace loomlight {

/// A scene and what its light is traced through, made of the scene's TraceData.
struct Traceable {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Medium> medium;
};

/// A picture that grows pass by pass, coarse first: of the whole viewport, or of a window onto it that may be moved.
/// A pass that takes long is done bucket by bucket, from the middle outwards, and each bucket is shown as it is done.
/// The window looks at a film of the viewport's size, so each pixel's samples are those that it has in the whole
/// picture, and what a window has once shown is still there when it comes back. Pixels that were never looked at take
/// no memory.
class Refinement {
 public:
  /// What it is from its first pass to its last.
  struct Options {
    double secondsPerPath = 0;  ///< as measured before; 0: unknown
    /// The cloth is still being built, and its builder needs the processor: the picture rests when it is in light that
    /// was known before, or at a half or a third of its resolution, and no first fibres are found for shared light.
    bool isSketch = false;
    bool asTraced = false;  ///< frames have no hits, and are as they were traced: for the inset
    /// What recolouring needs is kept within so many bytes; of coarse passes too, one after the other. 0: it is not.
    size_t paths_bytes = 0;
  };
  /// The window is the whole. Throws InputError where memory does not suffice.
  Refinement(Traceable cloth, int width, int height, const Options& options);

  void look(const PixelRect& window);  ///< within the film
  /// Before the first pass: no coarser than this, because the old picture says more than a coarser one would.
  /// In light that is known a pixel of it is seen as `finer` by `finer` of its own, so it may be coarser, as in a drag.
  void beginWith(const FirstPass& first);
  /// Leaves out all passes whose divider is this or larger: for a picture that another one stands in for, or that is
  /// not shown before it has many samples. A sketch makes its last pass all the same.
  void skipCoarse(int divider = 1) {
    history_.divider = options_.isSketch ? std::max(divider, kCoarseEnough) : divider;
  }
  /// Another picture of the same view, of the window or more, shown where this one is not as good yet.
  void standIn(std::shared_ptr<const Frame> earlier) { standIn_.emplace(std::move(earlier)); }
  /// A picture of the same cloth in the same light, of the whole window at full resolution, seen by another camera:
  /// what it shows of this view stands in from the first pass on. Before the first pass.
  void movedFrom(std::shared_ptr<const Frame> earlier, const Camera& camera) {
    seenBefore_.emplace(std::move(earlier), camera);
  }
  /// Whether the picture that stands in is still to be seen.
  bool fading() const { return standIn_ && history_.samples < standIn_->samples(); }
  /// Whether it shows this same view.
  bool fadesFromSameView() const { return fading() && !standIn_->isMoved(); }
  /// With so many samples another picture is as good as what this one shows, stand-in included.
  uint32_t worth_samples() const { return fading() ? standIn_->samples() : history_.samples; }
  /// Whether frames with hits have a copy with less noise for the display.
  void denoise(bool wanted) { denoised_ = wanted; }
  /// So many samples a pixel are enough; those that there are stay.
  void restAt(uint32_t samples) { rest_ = samples; }

  /// From now on shows light that repeats share, while it is better than the film. `earlier` (may be null) is that of
  /// another picture, and `edit` what came between.
  void shareLight(std::unique_ptr<SharedLight> earlier, const Changes& edit);
  /// Null where none is shared; it is then no longer.
  std::unique_ptr<SharedLight> takeSharedLight() { return std::move(shared_); }

  /// Whether a pass has filled the window, or those that would were left out.
  bool begun() const { return history_.divider != 0; }
  bool converged() const;
  int divider() const { return history_.divider; }
  uint32_t samples() const { return history_.samples; }
  double spent_s() const { return spent_s_; }
  /// Whether no pass but the first is done, and that one has the light that was known before.
  bool showsKnownLight() const { return known_.has_value(); }
  double secondsPerPath() const { return history_.secondsPerPath; }
  /// Whether most of what its pixels show is this view's own, each in its place: traced light, or light that is shared.
  bool hasDetail() const;
  const Film& film() const { return fine_; }
  /// The paths on record of the finest pass that has filled the picture, and the film they went into; null where there
  /// are none. A large picture may have no room for those of its fine passes.
  struct Paths {
    const Film* film = nullptr;
    const PathRecords* records = nullptr;
  };
  Paths paths() const;
  const PixelRect& window() const { return window_; }
  const Scene& scene() const { return *cloth_.scene; }
  const Medium& medium() const { return *cloth_.medium; }

  /// The next pass, or some buckets of one. False when stopped: then it goes on where it was.
  bool advance(const Task& task);
  /// Whether the last advance() has changed what frame() is to show: first fibres are seen when every pixel has them.
  bool isNews() const { return isNews_; }

  Frame frame() const;
  /// The picture at full resolution in other colours, with what stands in for it in these colours too, and the noise of
  /// its own samples: the mean variance of their luminance. Of a picture that keeps its paths and has samples.
  Frame recoloured(const Recolouring& recolouring, int threads, double& variance) const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int kCoarseEnough = 4;  ///< a sketch rests at the first divider below this

  /// A pass under way: what is to be done, and how far it is.
  struct Pass {
    PassPlan plan;
    PictureBuckets buckets;
  };

  struct SeenBefore {
    std::shared_ptr<const Frame> frame;
    Camera camera;
  };

  uint32_t samplesWanted() const;
  Film& filmFor(int divider);
  std::unique_ptr<PathRecords> recordsFor(const Film& film) const;
  Pass beginPass() const;
  void endPass();
  uint32_t hitsWanted() const;
  bool hitsAreNext() const;
  bool showDetail(const Task& task);
  bool showKnownLight(const Task& task);
  Frame inKnownLight() const;
  std::optional<MovedView> moved(int threads);
  void showMoved(MovedView view);
  bool showsMoved() const;
  float standInShare(int x, int y) const;
  Frame traced(const Film& film, int divider) const;
  glm::vec4 faded(const glm::vec4& own, int x, int y, const LightChange& change) const;
  void finish(Frame& frame) const;
  float youth(const Frame& frame, bool isKept) const;
  void takeNoise(Frame& frame) const;
  bool sharesLight() const;
  void share(Frame& frame) const;
  std::vector<float> variances(const Frame& frame) const;

  Traceable cloth_;
  Options options_;
  Film fine_;
  bool fineBegun_ = false;
  std::unique_ptr<PathRecords> records_;  ///< of fine_; null where none are kept
  std::unique_ptr<SharedLight> shared_;   ///< null where none is shared
  bool knowsLight_ = false;               ///< from the picture before
  bool isHitsTurn_ = true;                ///< the next pass begins with the first fibres of some pixels
  bool isNews_ = true;                    ///< the last step has changed what is to be seen
  /// Of coarse passes: the last that is done, and a finer one under way.
  std::vector<CoarseFilm> coarse_;
  std::unique_ptr<PathRecords> coarseRecords_;  ///< of the last of coarse_
  bool denoised_ = false;
  uint32_t rest_ = kUsualRest;  ///< samples a pixel
  int threads_ = 1;             ///< of the last pass
  std::optional<Pass> pass_;
  std::optional<StandIn> standIn_;
  std::optional<SeenBefore> seenBefore_;
  std::optional<Frame> known_;  ///< the first pass, in light that was known before; until a finer one is seen
  PixelRect window_;
  PassHistory history_;
  Clock::time_point start_;
  double spent_s_ = 0;
};

}  // namespace loomlight
