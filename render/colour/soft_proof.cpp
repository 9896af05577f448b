#include "render/colour/soft_proof.h"

#include "render/colour/icc_profile.h"

namespace loomlight {

Rgb proofed(const Rgb& encoded, const SoftProof& proof) {
  if (!proof.prints) return encoded;
  const glm::vec4 print = proof.prints->at(encoded);
  return proof.warnsOfGamut && print.a > kOutOfGamut_deltaE ? kGamutWarning : Rgb(print);
}

}  // namespace loomlight
