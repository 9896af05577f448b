#pragma once

#include <gtest/gtest.h>

#include "app/live/refinement.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight::test {

/// A small white cloth, seen in a small picture that is refined on one thread.
class RefiningTest : public testing::Test {
 protected:
  static constexpr int kWidth = 60, kHeight = 44;

  static Traceable makeCloth() {
    Fabric fabric = whiteCotton();
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 8;
    Traceable made;
    made.scene = sceneOf(fabric);
    made.medium = makeMedium(*made.scene, 1e9, Task{});
    return made;
  }
  static void refine(Refinement& refinement, uint32_t samples) {
    while (refinement.samples() < samples) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  }

  const Traceable cloth = makeCloth();
};

}  // namespace loomlight::test
