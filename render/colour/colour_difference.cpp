#include "render/colour/colour_difference.h"

#include <algorithm>
#include <cmath>

namespace loomlight {

Lab labUnder(const TristimulusWeights& weights, const Spectrum& reflectance) {
  return labFromWhiteXyz(weighted(weights, reflectance) / whiteXyz(weights));
}

glm::dvec3 linearUnder(const glm::dvec3& white, const Lab& lab) {
  const glm::dvec3 d65 = d65Xyz();
  return linearFromWhiteXyz(bradford(white, d65) * (whiteXyzFromLab(lab) * white) / d65);
}

double cmcDifference(const Lab& standard, const Lab& sample, double l, double c) {
  const double chroma = std::hypot(standard.a, standard.b);
  const double dL = sample.L - standard.L, dC = std::hypot(sample.a, sample.b) - chroma;
  const double da = sample.a - standard.a, db = sample.b - standard.b;
  const double dH2 = std::max(0.0, da * da + db * db - dC * dC);

  constexpr double kDegree = kPi / 180;
  double hue = std::atan2(standard.b, standard.a) / kDegree;
  if (hue < 0) hue += 360;
  const double t = hue >= 164 && hue <= 345 ? 0.56 + std::abs(0.2 * std::cos((hue + 168) * kDegree))
                                            : 0.36 + std::abs(0.4 * std::cos((hue + 35) * kDegree));
  const double c4 = std::pow(chroma, 4);
  const double f = std::sqrt(c4 / (c4 + 1900));
  const double sL = standard.L < 16 ? 0.511 : 0.040975 * standard.L / (1 + 0.01765 * standard.L);
  const double sC = 0.0638 * chroma / (1 + 0.0131 * chroma) + 0.638;
  const double sH = sC * (f * t + 1 - f);
  return std::hypot(dL / (l * sL), dC / (c * sC), std::sqrt(dH2) / sH);
}

LchDifference lchDifference(const Lab& standard, const Lab& sample) {
  const double one = std::hypot(standard.a, standard.b), other = std::hypot(sample.a, sample.b);
  const double turn =
      std::atan2(standard.a * sample.b - standard.b * sample.a, standard.a * sample.a + standard.b * sample.b);
  return {sample.L - standard.L, other - one, 2 * std::sqrt(one * other) * std::sin(turn / 2)};
}

Judgement judged(const Spectrum& standard, const Spectrum& sample, const TristimulusWeights& lamp,
                 const TristimulusWeights& reference) {
  Judgement judgement{labUnder(lamp, standard), labUnder(lamp, sample)};
  judgement.ciede2000 = ciede2000(judgement.standard, judgement.sample);
  judgement.cmc = cmcDifference(judgement.standard, judgement.sample);
  judgement.metamerism = metamerismIndex(standard, sample, reference, lamp);
  return judgement;
}

double metamerismIndex(const Spectrum& standard, const Spectrum& sample, const TristimulusWeights& reference,
                       const TristimulusWeights& test) {
  const glm::dvec3 wanted = weighted(reference, standard), got = weighted(reference, sample);
  glm::dvec3 corrected = weighted(test, sample);
  for (int i = 0; i < 3; ++i)
    if (got[i] > 0) corrected[i] *= wanted[i] / got[i];
  return ciede2000(labUnder(test, standard), labFromWhiteXyz(corrected / whiteXyz(test)));
}

}  // namespace loomlight
