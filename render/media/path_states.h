#pragma once

#include <vector>

#include "render/media/medium.h"

namespace loomlight {

/// Where the paths of a batch stand, and what the medium remembers of each: a plain value of its own.
template <class Memory>
class PathStates : public MediumBatch {
 public:
  explicit PathStates(size_t paths) : paths_(paths) {}

  void begin(uint32_t path, const ScenePoint& from, const RayCone&) override { paths_[path] = {from, {}}; }
  const ScenePoint& place(uint32_t path) const override { return paths_[path].place; }
  void copy(uint32_t path, uint32_t to) override { paths_[to] = paths_[path]; }

 protected:
  struct Path {
    ScenePoint place;
    Memory memory;
  };
  std::vector<Path> paths_;
};

}  // namespace loomlight
