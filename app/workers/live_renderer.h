#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fabric/fabric.h"
#include "core/geometry/cloth_geometry.h"
#include "core/volume/cloth_volume.h"
#include "render/film/film.h"

namespace loomlight {

/// What the viewport wants to see. `generation` counts up with every request and comes back in every frame.
struct ViewRequest {
  std::shared_ptr<const Fabric> fabric;
  int width = 0, height = 0;  ///< pixels of the viewport
  uint64_t generation = 0;
};

/// A picture of the viewport, immutable. Coarse first passes have fewer pixels than were asked for: show them
/// stretched.
struct Frame {
  int width = 0, height = 0;
  std::vector<glm::vec4> rgba;  ///< linear, premultiplied by alpha; row by row from the top left
  std::vector<Film::Hit> hits;  ///< yarn and crossing per pixel; -1 where there is no cloth
  uint64_t generation = 0;      ///< of the request it answers
  int samples = 0;              ///< per pixel; 0 for a coarse pass
  int divider = 1;              ///< of the resolution
  double seconds = 0;           ///< since the tracing of this request began
};

struct LiveStatus {
  enum class Phase { idle, voxelising, tracing, converged };
  Phase phase = Phase::idle;
  double buildProgress = 1;      ///< 0..1, of the voxelisation under way
  uint64_t builtGeneration = 0;  ///< newest request whose volume is ready
  VolumeCounts counts;
  ClothMeasures measures;
  double buildSeconds = 0;  ///< of the last voxelisation
  double pathsPerSecond = 0;
  std::string error;                 ///< of the newest request, for the user; empty if it could be built
  std::vector<std::string> notices;  ///< repairs of a mesh and the like
};

/// The two workers behind the viewport: the builder turns the newest fabric into a scene, the tracer refines pictures
/// of the newest scene. No call here ever waits for either of them (destruction does: one brick, one path).
class LiveRenderer {
 public:
  /// `wake` is called from the workers when there is something new to show.
  /// `threads`: for tracing; 0 leaves one hardware thread to the window.
  explicit LiveRenderer(std::function<void()> wake, int threads = 0);
  ~LiveRenderer();
  LiveRenderer(const LiveRenderer&) = delete;
  LiveRenderer& operator=(const LiveRenderer&) = delete;

  void request(ViewRequest request);
  std::shared_ptr<const Frame> frame() const;  ///< the newest; null before the first
  LiveStatus status() const;
  void pause(bool paused);  ///< stops tracing (a snapshot needs the cores); the picture stays

 private:
  struct Workers;
  std::unique_ptr<Workers> workers_;
};

}  // namespace loomlight
