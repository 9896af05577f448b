#pragma once

#include <span>

#include "core/base/task.h"
#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/share/cell_sums.h"
#include "render/share/light_cell_key.h"
#include "render/transport/path_tracer.h"

namespace loomlight {

/// Paths from the eye that end at the first fibre that they meet, and so cost a fraction of one that looks for light:
/// the cell that the fibre lies in may know it. For one thread. Scene, medium and camera must outlive it.
class FirstFibres {
 public:
  FirstFibres(const Scene& scene, const Medium& medium, const CameraRays& camera);

  /// Follows these samples of pixels, whose listeners become its own. False when stopped: then there are none.
  bool trace(std::span<PixelSample> wanted, const Task& task);

  // Of the last call, by index into its list:
  const Collision* at(size_t i) const { return tracer_.first(i); }  ///< null where the path met none
  /// Whether a path that met none went through the cloth, between its fibres, and not past it.
  bool isThrough(size_t i) const;

  /// Of a fibre that the sample has met. Keys are of a place near it, by chance, so that borders of cells do not show;
  /// but of its own where no light is known of cloth that lies as it does there.
  LightCellPath cellsOf(const PixelSample& sample, const Collision& at, const CellSums& known);

 private:
  class End final : public PathSink {
   public:
    bool meets(const Collision&, uint32_t) override { return false; }
  };

  const Scene& scene_;
  PathTracer tracer_;
  LightCellKeys keys_;
  End end_;
};

/// Whether a ray from the eye goes through the cloth rather than past it.
bool goesThrough(const Scene& scene, const Ray& ray);

}  // namespace loomlight
