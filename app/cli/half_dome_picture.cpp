#include "app/cli/half_dome_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

/// Reflectance factor of a camera; azimuths go round.
Rgb factorAt(const HalfDomeMeasure& measure, double paperRadiance, int azimuth, int inclination) {
  const int n = measure.grid.azimuths;
  const size_t i = static_cast<size_t>(inclination) * static_cast<size_t>(n) + static_cast<size_t>((azimuth + n) % n);
  return measure.radiance[i] / static_cast<float>(paperRadiance);
}

/// Between the four cameras next to a direction given in steps of the grid.
Rgb between(const HalfDomeMeasure& measure, double paperRadiance, double azimuth, double inclination) {
  const double row = std::clamp(inclination, 0.0, measure.grid.inclinations - 1.0);
  const int x = static_cast<int>(std::floor(azimuth)), y = static_cast<int>(row);
  const auto dx = static_cast<float>(azimuth - x), dy = static_cast<float>(row - y);
  const int below = std::min(y + 1, measure.grid.inclinations - 1);
  const auto at = [&](int i, int j) { return factorAt(measure, paperRadiance, i, j); };
  return glm::mix(glm::mix(at(x, y), at(x + 1, y), dx), glm::mix(at(x, below), at(x + 1, below), dx), dy);
}

}  // namespace

Pixels8 halfDomePicture(const HalfDomeMeasure& measure, double paperRadiance, const Tone& tone, int side) {
  Pixels8 pixels{side, side, 4, {}};
  pixels.bytes.resize(static_cast<size_t>(side) * side * 4);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (2 * column + 1.0) / side - 1, y = 1 - (2 * row + 1.0) / side;
      const double radius = std::hypot(x, y);
      if (radius > 1) continue;
      const double turn = std::atan2(y, x) / (2 * kPi);
      const Rgb colour =
          toDisplay(between(measure, paperRadiance, (turn < 0 ? turn + 1 : turn) * measure.grid.azimuths - 0.5,
                            radius * measure.grid.inclinations - 0.5),
                    tone);
      uint8_t* pixel = &pixels.bytes[(static_cast<size_t>(row) * side + column) * 4];
      for (int c = 0; c < 3; ++c) pixel[c] = byteOf(colour[c]);
      pixel[3] = 255;
    }
  return pixels;
}

Image halfDomeImage(const HalfDomeMeasure& measure, double paperRadiance) {
  Image image;
  image.width = measure.grid.azimuths;
  image.height = measure.grid.inclinations;
  constexpr const char* kNames[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = image.add(kNames[c]);
    for (size_t i = 0; i < values.size(); ++i) values[i] = measure.radiance[i][c] / static_cast<float>(paperRadiance);
  }
  return image;
}

std::string halfDomeCsv(const HalfDomeMeasure& measure, double paperRadiance) {
  std::string text = "azimuth_deg,inclination_deg,red,green,blue\n";
  for (int j = 0; j < measure.grid.inclinations; ++j)
    for (int i = 0; i < measure.grid.azimuths; ++i) {
      const Rgb c = factorAt(measure, paperRadiance, i, j);
      text += fmt::format("{:.4f},{:.4f},{:.6g},{:.6g},{:.6g}\n", measure.grid.azimuth_deg(i),
                          measure.grid.inclination_deg(j), c.r, c.g, c.b);
    }
  return text;
}

}  // namespace loomlight
