#pragma once

#include <vector>

#include "app/live/refinement.h"
#include "render/display/booth.h"

namespace loomlight {

/// What a light booth shows of the picture that is traced: nothing more is traced for it. The paths on record of every
/// pass, coarse ones too, say how light changes under each lamp.
class BoothView {
 public:
  /// What comes is another view.
  void forget() { changes_ = {}; }
  /// What comes is the same view, better: its first paths take the place of those that are known.
  void renew() { bytes_ = 0; }
  /// From a picture that is shown as it is traced.
  void learn(const Refinement& picture, int threads) { learn(picture, *picture.scene().fabric, nullptr, threads); }
  /// From one that is shown in the colours of the wanted fabric, which `shown` gives it.
  void learn(const Refinement& picture, const Fabric& wanted, const Recolouring& shown, int threads) {
    learn(picture, wanted, &shown, threads);
  }
  /// Learns from the picture as it is traced while that is worth it: what is known stays until half as many paths again
  /// have come.
  void follow(const Refinement& picture, int threads);
  /// A frame of the view, divided (Frame::booth); empty where nothing is known so far.
  std::vector<glm::vec4> divided(const Frame& frame) const;

 private:
  void learn(const Refinement& picture, const Fabric& wanted, const Recolouring* shown, int threads);

  BoothChanges changes_;
  size_t bytes_ = 0;  ///< of the paths that they are from
};

}  // namespace loomlight
