#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/live/mailbox.h"
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
  uint32_t samples = 0;
  std::string error;  ///< why there is none
};

/// Renders small pictures on a thread of its own, in the order of the newest list: first all of them with a few
/// samples, then all with their own number. What is there already is kept, and cloths that differ in colour
/// alone share their voxels. No call here waits.
class ThumbnailWorker {
 public:
  explicit ThumbnailWorker(std::function<void()> wake);
  ~ThumbnailWorker();

  void request(std::vector<ThumbnailOrder> orders);
  /// The newest of that name; null before the first.
  std::shared_ptr<const Thumbnail> of(const std::string& name) const;

 private:
  void loop(std::stop_token stop);
  bool fulfil(const ThumbnailOrder& order, uint32_t samples, const Task& task);
  void publish(const std::string& name, std::shared_ptr<const Thumbnail> thumbnail);

  std::function<void()> wake_;
  Mailbox<std::vector<ThumbnailOrder>> orders_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Thumbnail>> done_;
  std::shared_ptr<const Scene> scene_;  ///< the thread's own: the last, whose parts the next may share
  std::jthread thread_;                 // last: it stops before what it uses is gone
};

}  // namespace loomlight
