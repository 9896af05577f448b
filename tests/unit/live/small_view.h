#pragma once

#include <memory>

#include "app/live/live_renderer.h"

namespace loomlight::test {

/// What a viewport of 64 x 48 pixels asks for.
inline ViewRequest smallView(const Fabric& fabric, uint64_t generation) {
  return {std::make_shared<const Fabric>(fabric), 64, 48, generation, nullptr};
}

}  // namespace loomlight::test
