#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/tracer.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/bvdf/bvdf_set.h"

namespace loomlight {

/// What the viewport wants to see. `generation` counts up with what is to be seen, and comes back in every frame; a
/// request of the same generation may only bring better tables of visibility.
struct ViewRequest {
  std::shared_ptr<const Fabric> fabric;
  int width = 0, height = 0;  ///< pixels of the viewport
  uint64_t generation = 0;
  /// For Estimator::report: the best that is known. Null, or of other yarns: what is expected without any.
  std::shared_ptr<const BvdfSet> visibility;
};

/// Where the reference inset is: explicit fibres in a part of the viewport.
struct InsetRequest {
  PixelRect window;
  double memoryLimit_bytes = 0;  ///< that explicit fibres may take
  bool operator==(const InsetRequest&) const = default;
};

/// How far the reference inset is.
struct InsetStatus {
  enum class Phase {
    closed,
    waiting,    ///< for the cloth to be built
    needless,   ///< the viewport shows explicit fibres itself
    laying,     ///< fibres
    tooLarge,   ///< they would take more than the limit
    failed,     ///< for another reason: `error`
    tracing,    ///< fibres are laid, and samples are still to come
    converged,  ///< all samples that are asked for are there
  };
  Phase phase = Phase::closed;
  double progress = 0;             ///< 0..1, of laying
  double segments = 0, bytes = 0;  ///< of the fibres, as estimated before they are laid
  bool isWholePiece = true;        ///< false: of one repeat, which stands side by side
  std::string error;
};

struct LiveStatus {
  enum class Phase { idle, voxelising, tracing, converged };
  Phase phase = Phase::idle;
  double buildProgress = 1;      ///< 0..1, of the voxelisation under way
  uint64_t builtGeneration = 0;  ///< newest request whose volume is ready
  VolumeCounts counts;
  ClothMeasures measures;
  double buildSeconds = 0;           ///< of the last voxelisation
  uint64_t bricksVoxelised = 0;      ///< by all of them
  std::string error;                 ///< of the newest request, for the user; empty if it could be built
  std::vector<std::string> notices;  ///< repairs of a mesh and the like
  InsetStatus inset;
};

/// The workers behind the viewport: the builder turns the newest fabric into a scene, the tracer refines pictures of
/// the newest scene, and while the inset is open, explicit fibres are laid for it to look at. No call here ever waits
/// for any of them (destruction does: one brick, one path).
class LiveRenderer {
 public:
  /// `wake` is called from the workers when there is something new to show.
  /// `threads`: for tracing; 0: all that the machine has, as the window needs little.
  explicit LiveRenderer(std::function<void()> wake, int threads = 0);
  ~LiveRenderer();
  LiveRenderer(const LiveRenderer&) = delete;
  LiveRenderer& operator=(const LiveRenderer&) = delete;

  void request(ViewRequest request);
  void inset(std::optional<InsetRequest> request);       ///< null: closed
  std::shared_ptr<const Frame> frame() const;            ///< the newest; null before the first
  std::shared_ptr<const InsetFrame> insetFrame() const;  ///< null while there is nothing to show in the inset
  /// The newest that has been built, or is being built and has all its yarns; null before the first.
  std::shared_ptr<const Scene> scene() const;
  LiveStatus status() const;
  void denoise(bool wanted);      ///< whether frames have a copy with less noise for the display
  void restAt(uint32_t samples);  ///< a pixel, at which pictures rest; kUsualRest unless told
  void booth(bool wanted);        ///< whether frames are divided among the lamps of a booth
  void shareLight(bool wanted);   ///< whether the next pictures show light that repeats share; true unless told
  void pause(bool paused);        ///< stops tracing (a snapshot needs the cores); the picture stays

 private:
  struct Workers;
  std::unique_ptr<Workers> workers_;
};

}  // namespace loomlight
