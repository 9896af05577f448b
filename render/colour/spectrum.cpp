#include "render/colour/spectrum.h"
#include "core/base/rgb.h"

#include <cmath>

namespace loomlight {
namespace {

Rgb blackBodyColour(double kelvin) {
  glm::dvec3 xyz(0);
  for (double nm = 380; nm <= 760; nm += 5) xyz += planck(nm, kelvin) * colourMatching(nm);
  return rgbFromXyz(xyz / xyz.y);
}

}  // namespace

double planck(double nm, double kelvin) {
  return std::pow(nm, -5) / std::expm1(1.438777e7 / (nm * kelvin));
}

glm::dvec3 colourMatching(double nm) {
  const auto lobe = [nm](double height, double centre, double below, double above) {
    const double t = (nm - centre) / (nm < centre ? below : above);
    return height * std::exp(-0.5 * t * t);
  };
  return {lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2),
          lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
          lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8)};
}

Rgb rgbFromXyz(glm::vec3 xyz) {
  return glm::max(Rgb(0), Rgb(3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
                              -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
                              0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z));
}

Rgb blackBodyTint(double kelvin) {
  constexpr double kNeutral = 6500;
  if (kelvin == kNeutral) return Rgb(1);
  const Rgb tint = blackBodyColour(kelvin) / blackBodyColour(kNeutral);
  return tint / luminance(tint);
}

}  // namespace loomlight
