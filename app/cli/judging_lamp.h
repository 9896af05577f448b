#pragma once

#include <string>

#include "render/colour/illuminants.h"
#include "render/colour/tristimulus.h"

namespace loomlight {

/// A lamp that colours are judged under; where a wanted one cannot be had, the nearest is nearest under it.
struct JudgingLamp {
  std::string name;
  TristimulusWeights weights;
};

/// `illuminant` is a name or a file (illuminantCalled(), which says what it throws).
inline JudgingLamp judgingLamp(const std::string& illuminant, Observer observer) {
  return {illuminant, tristimulusWeights(illuminantCalled(illuminant), observer)};
}

}  // namespace loomlight
