#pragma once

#include "core/base/spectrum.h"
#include "render/colour/colour_space.h"
#include "render/colour/tristimulus.h"

/// What a dyer reports of a standard and a sample; CIEDE2000 is in colour_space.h.
namespace loomlight {

/// CIELAB of a reflectance under the light of the weights, whose perfect diffuser is L* = 100.
Lab labUnder(const TristimulusWeights& weights, const Spectrum& reflectance);

/// The colour that CIELAB means for that white (XYZ), adapted to D65 (Bradford), as linear Rec. 709; the colours of
/// books, whose white is mostly D50, among them. Outside of the gamut channels are beyond [0, 1].
glm::dvec3 linearUnder(const glm::dvec3& white, const Lab& lab);

/// CMC(l:c) of the Society of Dyers and Colourists (ISO 105-J03). Not the same both ways: the standard says how large
/// the ellipsoid is. The textile trade takes l = 2 and c = 1 to pass or fail.
double cmcDifference(const Lab& standard, const Lab& sample, double l = 2, double c = 1);

/// How a sample is off, in the words of a dyer: lighter (+) or darker, fuller (+) or duller, and by its hue, + where
/// that goes from red to yellow, green and blue. The squares of the three add up to that of the distance in CIELAB.
struct LchDifference {
  double L = 0, C = 0, H = 0;
};
LchDifference lchDifference(const Lab& standard, const Lab& sample);

/// What dyers say of a sample beside a standard under one lamp.
struct Judgement {
  Lab standard, sample;
  double ciede2000 = 0;
  double cmc = 0;         ///< CMC(2:1)
  double metamerism = 0;  ///< special index, for the change to this lamp from the reference
  bool passes(double tolerance_cmc) const { return cmc <= tolerance_cmc; }
};
Judgement judged(const Spectrum& standard, const Spectrum& sample, const TristimulusWeights& lamp,
                 const TristimulusWeights& reference);

/// The special metamerism index for a change of illuminant (CIE 15:2018, 9.2): the CIEDE2000 that is between standard
/// and sample under `test` when they match under `reference`. Where they do not quite, the sample's X, Y and Z are
/// first multiplied by what is missing there. 0 for two that match under both, whatever their spectra.
double metamerismIndex(const Spectrum& standard, const Spectrum& sample, const TristimulusWeights& reference,
                       const TristimulusWeights& test);

}  // namespace loomlight
