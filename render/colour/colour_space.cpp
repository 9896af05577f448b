#include "render/colour/colour_space.h"

#include <cmath>

// How it works. Linear sRGB becomes CIE XYZ by the matrix of its primaries, here divided by the white, so that white
// is (1, 1, 1); XYZ becomes CIELAB by the cube root that goes on as a line below (6/29)^3 (CIE 15). The difference
// of two colours is CIEDE2000 (Sharma, Wu and Dalal 2005), which weights lightness, chroma and hue as the eye does.
// Angles are in degrees, as in the paper. Cost: some hundred operations a pair.

namespace loomlight {
namespace {

// Columns are the primaries.
const glm::dmat3 kXyzFromLinear{{0.4123907993, 0.2126390059, 0.0193308187},
                                {0.3575843394, 0.7151686788, 0.1191947798},
                                {0.1804807884, 0.0721923154, 0.9505321522}};

glm::dmat3 whiteXyzMatrix() {
  const glm::dvec3 white = kXyzFromLinear * glm::dvec3(1);
  glm::dmat3 matrix = kXyzFromLinear;
  for (int i = 0; i < 3; ++i) matrix[i] /= white;
  return matrix;
}

const glm::dmat3 kWhiteXyzFromLinear = whiteXyzMatrix();
const glm::dmat3 kLinearFromWhiteXyz = glm::inverse(kWhiteXyzFromLinear);

constexpr double kDelta = 6.0 / 29;  // below it CIELAB goes on along the tangent of its cube root

double labCurve(double t) {
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}
double inverseLabCurve(double f) {
  return f > kDelta ? f * f * f : 3 * kDelta * kDelta * (f - 4.0 / 29);
}

double degrees(double radians) {
  return radians * 180 / kPi;
}
double radians(double degrees) {
  return degrees * kPi / 180;
}
double cosDegrees(double angle) {
  return std::cos(radians(angle));
}

/// In [0, 360); 0 for greys.
double hue_deg(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double hue = degrees(std::atan2(b, a));
  return hue < 0 ? hue + 360 : hue;
}

}  // namespace

glm::dvec3 d65Xyz() {
  return kXyzFromLinear * glm::dvec3(1);
}
glm::dvec3 whiteXyzFromLinear(const glm::dvec3& linear) {
  return kWhiteXyzFromLinear * linear;
}
glm::dvec3 linearFromWhiteXyz(const glm::dvec3& xyz) {
  return kLinearFromWhiteXyz * xyz;
}

Lab labFromWhiteXyz(const glm::dvec3& xyz) {
  const double x = labCurve(xyz.x), y = labCurve(xyz.y), z = labCurve(xyz.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

glm::dvec3 whiteXyzFromLab(const Lab& lab) {
  const double y = (lab.L + 16) / 116;
  return {inverseLabCurve(y + lab.a / 500), inverseLabCurve(y), inverseLabCurve(y - lab.b / 200)};
}

// Numbers in the comments are equations of Sharma et al. 2005.
double ciede2000(const Lab& one, const Lab& other, double kL) {
  const auto saturating = [](double c) {
    const double c7 = std::pow(c, 7);
    return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
  };
  const double meanC = 0.5 * (std::hypot(one.a, one.b) + std::hypot(other.a, other.b));  // 2, 3
  const double scaleOfA = 1 + 0.5 * (1 - saturating(meanC));  // 4, 5: near greys a counts more
  const double a1 = scaleOfA * one.a, a2 = scaleOfA * other.a;
  const double c1 = std::hypot(a1, one.b), c2 = std::hypot(a2, other.b);  // 6
  const double h1 = hue_deg(a1, one.b), h2 = hue_deg(a2, other.b);        // 7
  const bool grey = c1 * c2 == 0;

  double turn = grey ? 0 : h2 - h1;  // 10
  if (turn > 180) turn -= 360;
  if (turn < -180) turn += 360;
  const double dL = other.L - one.L, dC = c2 - c1;                         // 8, 9
  const double dH = 2 * std::sqrt(c1 * c2) * std::sin(radians(turn / 2));  // 11

  const double meanL = 0.5 * (one.L + other.L), meanCp = 0.5 * (c1 + c2);  // 12, 13
  double meanH = h1 + h2;                                                  // 14; greys have no hue of their own
  if (!grey) {
    if (std::abs(h1 - h2) > 180) meanH += meanH < 360 ? 360 : -360;
    meanH /= 2;
  }
  const double t = 1 - 0.17 * cosDegrees(meanH - 30) + 0.24 * cosDegrees(2 * meanH) + 0.32 * cosDegrees(3 * meanH + 6) -
                   0.20 * cosDegrees(4 * meanH - 63);  // 15
  const double inBlue = (meanH - 275) / 25;
  const double rotation = 30 * std::exp(-inBlue * inBlue);  // 16
  const double fromMiddle = (meanL - 50) * (meanL - 50);
  const double sL = 1 + 0.015 * fromMiddle / std::sqrt(20 + fromMiddle);        // 18
  const double sC = 1 + 0.045 * meanCp, sH = 1 + 0.015 * meanCp * t;            // 19, 20
  const double rT = -std::sin(radians(2 * rotation)) * 2 * saturating(meanCp);  // 17, 21
  const double l = dL / (kL * sL), c = dC / sC, h = dH / sH;
  return std::sqrt(l * l + c * c + h * h + rT * c * h);  // 22
}

}  // namespace loomlight
