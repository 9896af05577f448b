#include "app/editor/model/yarn_close_up.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/fabric/yarn/presets.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// The pixels of a column that show fibres: how many they are, and their middle.
struct Strand {
  int pixels = 0;
  double middle = 0;
};
Strand strandIn(const Film& film, int x) {
  Strand strand;
  double sum = 0;
  for (int y = 0; y < film.height(); ++y)
    if (film.hit(x, y).yarn >= 0) {
      ++strand.pixels;
      sum += y + 0.5;
    }
  strand.middle = sum / std::max(1, strand.pixels);
  return strand;
}

// The finest, one between and the coarsest: it runs through the middle from one side to the other, and cloth is seen
// neither above nor below it.
TEST(YarnCloseUp, ShowsEachYarnAsAStrandAcrossThePicture) {
  constexpr int kWidth = 30, kHeight = 24, kThreads = 1;
  std::vector<YarnPreset> presets = yarnPresets();
  std::sort(presets.begin(), presets.end(),
            [](const YarnPreset& a, const YarnPreset& b) { return a.yarn.count_tex < b.yarn.count_tex; });
  for (const YarnPreset& preset : {presets.front(), presets[presets.size() / 2], presets.back()}) {
    SCOPED_TRACE(preset.yarn.name);
    Fabric fabric;
    fabric.fibres = {preset.fibre};
    fabric.yarns = {preset.yarn};
    const auto closeUp = std::make_shared<const Fabric>(yarnCloseUp(fabric, 0, kWidth, kHeight));
    Task task;
    task.threads = kThreads;
    const auto scene = makeScene(closeUp, task);
    const auto medium = makeMedium(*scene, 1e9, task);
    Film film(kWidth, kHeight);
    ASSERT_TRUE(renderUpTo(1, *scene, *medium, CameraRays(closeUp->camera, kWidth, kHeight), film, task).complete);
    // The picture is 2.4 diameters high; rays pass between the fibres of a soft yarn, and hairs stand off it.
    for (const int x : {0, kWidth / 2, kWidth - 1}) {
      const Strand strand = strandIn(film, x);
      EXPECT_GE(strand.pixels, kHeight / 5) << x;
      EXPECT_LE(strand.pixels, 4 * kHeight / 5) << x;
      EXPECT_NEAR(strand.middle, kHeight / 2.0, kHeight / 5.0) << x;
    }
  }
}

}  // namespace
}  // namespace loomlight
