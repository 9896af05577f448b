#include "app/live/preview_policy.h"

#include <algorithm>

#include "render/display/preview_quality.h"

namespace loomlight {

PreviewStart previewStart(const PreviewHave& have) {
  constexpr int kFiner = 3;                                // the nine first fibres take 1.7 times as long as the path
  constexpr double kPatience_s = 0.3, kFollowing_s = 0.1;  // the first pass of a scene cannot be stopped
  PreviewStart start;
  // On another drape the cloth may fill the picture as it did not before, or be slower to trace.
  start.knowsCost = have.sincePicture && !have.sincePicture->stages.any(Stage::drape);
  const bool sameView = have.sameSize && have.sinceClear && !have.sinceClear->stages.any(Stage::camera | Stage::drape);
  if (have.sameRequest && have.divider > 0) {
    start.reached = have.divider;
  } else if (have.sameRequest || sameView) {
    start.first = {FirstPass::kLegible, kPatience_s, kFiner};
  } else if (start.knowsCost) {
    start.first = {FirstPass::kInMotion, kFollowing_s, kFiner};
  } else {
    start.first.finer = kFiner;
  }
  return start;
}

ClearHelp clearHelp(const Changes& sinceClear, const PreviewSize& clear, const PreviewSize& wanted) {
  if (clear == wanted && sinceClear.crossingsAlone()) return ClearHelp::patched;
  const bool wouldBlur = 4 * wanted.height > 5 * clear.height;
  return sinceClear.picture() || wouldBlur ? ClearHelp::none : ClearHelp::reframed;
}

bool isOnlyMoved(const Changes& sinceEarlier) {
  return sinceEarlier.stages.any(Stage::camera) && sinceEarlier.stages.within(Stage::label | Stage::camera);
}

bool wantsHelp(int samples, int clearSamples) {
  return samples < std::min(clearSamples, kClearSamples);
}

bool supersedes(unsigned samples, double variance, const RecolouredPicture& recoloured) {
  constexpr unsigned kFewest = 4;  // to know a variance by
  return samples >= recoloured.worth_samples ||
         (!recoloured.fading && samples >= kFewest && variance <= recoloured.variance);
}

}  // namespace loomlight
