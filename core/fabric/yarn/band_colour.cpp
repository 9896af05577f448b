#include "core/fabric/yarn/band_colour.h"

namespace loomlight {
namespace {

// Tristimulus weights of CIE D65 and the CIE 1931 observer by ASTM E2022, those of the ends beyond the bands added to
// the first and the last, taken to the primaries of ITU-R BT.709. The tests of render/colour, which computes weights
// for any light, compare them.
constexpr Spectrum kRed = {
    {6.72373935e-05f, 0.000186352074f, 0.000842681911f, 0.00310164178f, 0.00959407166f,  0.0178193823f,
     0.0217783991f,   0.0161976591f,   0.00204025558f,  -0.0161876995f, -0.0334235765f,  -0.0466936603f,
     -0.0640345216f,  -0.0836665109f,  -0.0921074972f,  -0.0819569677f, -0.0532066524f,  -0.0126066105f,
     0.0373315811f,   0.0922749043f,   0.146172062f,    0.183831617f,   0.209852159f,    0.209649578f,
     0.180132523f,    0.133582607f,    0.0928307027f,   0.0576695912f,  0.0334601551f,   0.0181677528f,
     0.00913787447f,  0.0041186139f,   0.00203565159f,  0.00106313208f, 0.000474964647f, 0.000470540661f}};
constexpr Spectrum kGreen = {
    {-5.67558636e-05f, -0.000159055169f, -0.000725602731f, -0.00270874123f,  -0.00856748316f, -0.0165197551f,
     -0.0217594393f,   -0.0199153349f,   -0.0111266542f,   0.00376818795f,   0.0217382237f,   0.0393835083f,
     0.0636079013f,    0.0959349275f,    0.126911044f,     0.147376016f,     0.149860293f,    0.141784161f,
     0.122188471f,     0.0958983824f,    0.0667558163f,    0.0362396352f,    0.0130140483f,   -0.00233800779f,
     -0.00933203008f,  -0.0100334361f,   -0.00831556041f,  -0.0056697228f,   -0.00345020695f, -0.00191753928f,
     -0.000979468459f, -0.000446331367f, -0.000221251612f, -0.000115522496f, -5.1603929e-05f, -5.11232611e-05f}};
constexpr Spectrum kBlue = {
    {0.000396190881f,  0.00111429521f,   0.00509155076f,   0.0190929677f,    0.0615388528f,    0.124807172f,
     0.182753369f,     0.20741497f,      0.196242794f,     0.148611531f,     0.0910754502f,    0.0471069589f,
     0.0228142515f,    0.00652780803f,   -0.00571609102f,  -0.0123981507f,   -0.0155824861f,   -0.0166234691f,
     -0.0156975836f,   -0.0137000578f,   -0.0111930585f,   -0.00817973819f,  -0.00582878618f,  -0.00393683044f,
     -0.00247823284f,  -0.00145375892f,  -0.000843566668f, -0.000461610616f, -0.000247815537f, -0.000128995394f,
     -6.30003124e-05f, -2.77851777e-05f, -1.36515591e-05f, -7.13307372e-06f, -3.18763273e-06f, -3.15794341e-06f}};

float weighted(const Spectrum& weights, const Spectrum& reflectance) {
  float sum = 0;
  for (size_t j = 0; j < kBands; ++j) sum += weights[j] * reflectance[j];
  return sum;
}

}  // namespace

Rgb linearFromReflectance(const Spectrum& reflectance) {
  return {weighted(kRed, reflectance), weighted(kGreen, reflectance), weighted(kBlue, reflectance)};
}

}  // namespace loomlight
