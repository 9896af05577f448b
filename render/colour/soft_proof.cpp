#include "render/colour/soft_proof.h"

#include <algorithm>

#include "render/colour/icc_profile.h"

namespace loomlight {

bool isBeyondSrgb(const Rgb& linear) {
  const float most = std::max({linear.r, linear.g, linear.b}), least = std::min({linear.r, linear.g, linear.b});
  return most > 0 && least < -kBeyondSrgb * most;
}

Rgb proofed(const Rgb& encoded, const SoftProof& proof) {
  if (!proof.prints) return encoded;
  const glm::vec4 print = proof.prints->at(encoded);
  return proof.warnsOfGamut && print.a > kOutOfGamut_deltaE ? kGamutWarning : Rgb(print);
}

}  // namespace loomlight
