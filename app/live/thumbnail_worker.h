#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/film/film.h"
#include "render/film/image.h"
#include "render/scene/scene.h"

namespace loomlight {

/// A small picture that is wanted: the size, the samples and the method are those of the fabric's RenderSettings.
struct ThumbnailOrder {
  std::string name;  ///< by which it is known
  std::shared_ptr<const Fabric> fabric;
};

struct Thumbnail {
  std::shared_ptr<const Fabric> fabric;  ///< of which it is
  Pixels8 picture;                       ///< three channels, as the display shows it
  uint32_t samples = 0;                  ///< 0: it is a sketch
  std::string error;                     ///< why there is none
};

/// Renders small pictures on a thread of its own, in the order of the newest list: first all of them with a few
/// samples, then all with their own number; before that, where there is none yet, it sketches them. What is there
/// already is kept, and cloths that differ in colour alone share their voxels. No call here waits.
class ThumbnailWorker {
 public:
  /// Draws in a moment what stands in for the picture of a fabric, in three channels and of its size.
  using Sketch = std::function<Pixels8(const Fabric&)>;
  ThumbnailWorker(std::function<void()> wake, Sketch sketch);

  void request(std::vector<ThumbnailOrder> orders) { worker_.ask(std::move(orders)); }
  /// The newest of that name; null before the first.
  std::shared_ptr<const Thumbnail> of(const std::string& name) const;

 private:
  using Orders = std::vector<ThumbnailOrder>;
  using Thumbnails = std::map<std::string, std::shared_ptr<const Thumbnail>>;
  using Rendering = Worker<Orders, std::shared_ptr<const Thumbnails>>;
  void fulfil(const Orders& orders, Rendering::Job& job);
  void sketchMissing(const Orders& orders, Rendering::Job& job);
  std::shared_ptr<const Thumbnail> rendered(const ThumbnailOrder& order, uint32_t samples, const Task& task);

  // The thread's own:
  const Sketch sketch_;
  Thumbnails done_;
  std::shared_ptr<const Scene> scene_;  ///< the last, whose parts the next may share

  Rendering worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
