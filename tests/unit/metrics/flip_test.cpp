#include "render/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/colour/colour_space.h"
#include "tests/unit/metrics/pictures.h"

namespace loomlight {
namespace {

using test::noise;
using test::picture;
using test::uniform;

double mean(const std::vector<float>& map) {
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

double meanFlip(const LinearPicture& a, const LinearPicture& b, const Viewing& viewing = {}) {
  return mean(flip(a, b, viewing));
}

// FLIP once more, from the paper's text alone: Y Cx Cz, whole two-dimensional kernels, doubles, pixel by pixel.
class Literal {
 public:
  Literal(const LinearPicture& a, const LinearPicture& b, double ppd) : a_(a), b_(b), ppd_(ppd) {}

  double at(int x, int y) const {
    const double qc = 0.7, pc = 0.4, pt = 0.95, sqrtHalf = std::sqrt(0.5);
    const double most = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), qc);
    const double d = std::pow(hyab(blurred(a_, x, y), blurred(b_, x, y)), qc);
    const double colour = d < pc * most ? pt / (pc * most) * d : pt + (d - pc * most) / (most - pc * most) * (1 - pt);
    const double edge = std::abs(feature(a_, x, y, true) - feature(b_, x, y, true));
    const double point = std::abs(feature(a_, x, y, false) - feature(b_, x, y, false));
    return std::pow(colour, 1 - std::sqrt(sqrtHalf * std::max(edge, point)));
  }

 private:
  static glm::dvec3 ycxcz(const LinearPicture& p, int x, int y) {
    x = std::clamp(x, 0, p.width - 1);
    y = std::clamp(y, 0, p.height - 1);
    const glm::dvec3 w = whiteXyzFromLinear(p.pixels[static_cast<size_t>(y * p.width + x)]);
    return {116 * w.y - 16, 500 * (w.x - w.y), 200 * (w.y - w.z)};
  }
  static glm::dvec3 hunt(const glm::dvec3& linear) {
    const Lab lab = labFromLinear(linear);
    return {lab.L, 0.01 * lab.L * lab.a, 0.01 * lab.L * lab.b};
  }
  static double hyab(const glm::dvec3& one, const glm::dvec3& other) {
    const glm::dvec3 d = one - other;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
  }

  glm::dvec3 blurred(const LinearPicture& p, int x, int y) const {
    const double pi = kPi;
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    const auto term = [&](double a, double b, double z) { return a * std::sqrt(pi / b) * std::exp(-pi * pi * z / b); };
    glm::dvec3 total(0), weights(0);
    for (int j = -r; j <= r; ++j) {
      for (int i = -r; i <= r; ++i) {
        const double z = (i * i + j * j) / (ppd_ * ppd_);
        const glm::dvec3 w(term(1, 0.0047, z), term(1, 0.0053, z), term(34.1, 0.04, z) + term(13.5, 0.025, z));
        total += w * ycxcz(p, x + i, y + j);
        weights += w;
      }
    }
    const glm::dvec3 c = total / weights;
    const double white = (c.x + 16) / 116;
    return hunt(glm::clamp(linearFromWhiteXyz({white + c.y / 500, white, white - c.z / 200}), 0.0, 1.0));
  }

  double feature(const LinearPicture& p, int x, int y, bool edge) const {
    const double s = 0.5 * 0.082 * ppd_;
    const int r = static_cast<int>(std::ceil(3 * s));
    glm::dvec2 plus(0), minus(0);
    double plusWeight = 0, minusWeight = 0;
    for (int j = -r; j <= r; ++j) {
      for (int i = -r; i <= r; ++i) {
        const double g = std::exp(-(i * i + j * j) / (2 * s * s));
        const double w = edge ? -i * g : (i * i / (s * s) - 1) * g;
        const glm::dvec2 v((ycxcz(p, x + i, y + j).x + 16) / 116, (ycxcz(p, x + j, y + i).x + 16) / 116);
        (w > 0 ? plus : minus) += w * v;
        (w > 0 ? plusWeight : minusWeight) += w;
      }
    }
    return glm::length(plus / plusWeight - minus / minusWeight);
  }

  const LinearPicture &a_, &b_;
  double ppd_;
};

TEST(Flip, AgreesWithTheFormulasTakenLiterally) {
  // 150 pixels are more than a tile; one row more than the filters are high.
  const LinearPicture a = noise(1, 1, 150, 21);
  LinearPicture b = a;
  for (int y = 0; y < b.height; ++y)
    for (int x = 0; x < b.width; ++x)
      if ((x / 7 + y / 5) % 3 == 0) b.pixels[static_cast<size_t>(y * b.width + x)] *= Rgb(0.3f, 0.9f, 0.6f);
  for (const double ppd : {67.0, 20.0}) {
    const std::vector<float> map = flip(a, b, {.pixelsPerDegree = ppd});
    const Literal literal(a, b, ppd);
    for (const int y : {0, 3, 10, 20})
      for (const int x : {0, 1, 40, 126, 127, 128, 129, 149})
        EXPECT_NEAR(map[static_cast<size_t>(y * a.width + x)], literal.at(x, y), 2e-4) << x << ' ' << y;
  }
}

TEST(Flip, TheSameHasNoDifference) {
  const LinearPicture a = noise(3);
  for (const float error : flip(a, a, {})) EXPECT_EQ(error, 0);
}

TEST(Flip, IsSymmetric) {
  EXPECT_EQ(flip(noise(3), noise(4), {}), flip(noise(4), noise(3), {}));
}

TEST(Flip, IsFromZeroToOne) {
  const LinearPicture stripes = picture(64, 64, [](int x, int) { return Rgb(x % 16 < 8 ? 1.0f : 0.0f); });
  const LinearPicture inverse = picture(64, 64, [](int x, int) { return Rgb(x % 16 < 8 ? 0.0f : 1.0f); });
  const LinearPicture green = uniform({0, 1, 0}, 64, 64),
                      dot = picture(64, 64, [](int x, int y) { return x == 32 && y == 32 ? Rgb(1) : Rgb(0); });
  for (const auto* a : {&stripes, &inverse, &green, &dot}) {
    for (const auto* b : {&stripes, &inverse, &green, &dot}) {
      for (const float error : flip(*a, *b, {})) {
        EXPECT_GE(error, 0);
        EXPECT_LE(error, 1);
      }
    }
  }
}

// The paper's scale ends at green against blue; black against white, 100 L* apart, lies on its upper branch:
// d = 100^0.7 = 25.12, largest = 203.2^0.7 = 41.2, 0.95 + 0.05 (d - 16.5) / 24.7 = 0.967.
TEST(Flip, ExtremesAreWhereTheDefinitionPutsThem) {
  EXPECT_NEAR(meanFlip(uniform({0, 1, 0}), uniform({0, 0, 1})), 1, 1e-6);
  EXPECT_NEAR(meanFlip(uniform(Rgb(0)), uniform(Rgb(1))), 0.967, 1e-3);
}

// Between greys there is only L*: 116 cbrt(Y) - 16, to the power 0.7, on the lower branch of the scale.
TEST(Flip, GrowsWithAUniformErrorOfLight) {
  double last = 0;
  for (const double percent : {0.5, 1.0, 2.0, 3.0, 5.0}) {
    const double level = 0.35, brighter = level * (1 + percent / 100);
    const double lightness = 116 * (std::cbrt(brighter) - std::cbrt(level)), largest = std::pow(203.2, 0.7);
    const double error = meanFlip(uniform(Rgb(0.35f)), uniform(Rgb(static_cast<float>(brighter))));
    EXPECT_GT(error, last);
    EXPECT_NEAR(error, 0.95 * std::pow(lightness, 0.7) / (0.4 * largest), 1e-4);
    last = error;
  }
}

// What a percent means in FLIP, for a cloth: an earlier prototype, written independently, measured these with cloth of
// mean luminance 0.35. Texture and colour raise them above the greys, by how much depends on the cloth.
TEST(Flip, OfAClothAFewPercentTooBrightIsOfTheSizeMeasuredBefore) {
  const auto cloth = [](double gain) {
    return picture(96, 96, [gain](int x, int y) {
      const double yarns = 0.6 * std::cos(x * kPi / 6) * std::cos(y * kPi / 6);
      return Rgb(glm::dvec3(0.39, 0.345, 0.28) * (gain * (1 + yarns)));
    });
  };
  const double percent[] = {0.5, 1, 2, 3, 5}, expected[] = {0.017, 0.028, 0.047, 0.063, 0.091};
  for (int i = 0; i < 5; ++i) {
    const double error = meanFlip(cloth(1), cloth(1 + percent[i] / 100));
    EXPECT_NEAR(error, expected[i], 0.15 * expected[i]) << percent[i] << " %";
  }
}

TEST(Flip, SeenFromFartherFineDifferencesVanish) {
  const LinearPicture checks = picture(96, 96, [](int x, int y) { return Rgb((x + y) % 2 ? 0.8f : 0.2f); });
  const LinearPicture inverse = picture(96, 96, [](int x, int y) { return Rgb((x + y) % 2 ? 0.2f : 0.8f); });
  double last = 2;
  for (const double ppd : {5.0, 20.0, 67.0, 150.0}) {
    const double error = meanFlip(checks, inverse, {.pixelsPerDegree = ppd});
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(last, 0.05);
}

TEST(Flip, ALineThatIsMissingCountsMoreThanItsColour) {
  // The same light, as a line or spread out: the line is a feature.
  const LinearPicture line = picture(65, 65, [](int x, int) { return Rgb(x == 32 ? 0.8f : 0.2f); });
  const LinearPicture plain = uniform(Rgb(0.2f), 65, 65);
  const size_t middle = 32 * 65 + 32;
  const float withFeature = flip(line, plain, {})[middle];
  // What the blur leaves of the line, as a difference between two uniform pictures.
  const double deviation = std::sqrt(0.0047 / 2) / kPi * 67, peak = 0.6 / (deviation * std::sqrt(2 * kPi));
  const double colourAlone = meanFlip(uniform(Rgb(0.2f)), uniform(Rgb(static_cast<float>(0.2 + peak))));
  EXPECT_GT(withFeature, 1.2 * colourAlone);
}

TEST(Flip, ExposureIsAFactorOfLightAndTheDisplayClips) {
  EXPECT_EQ(flip(noise(1, 0.25f), noise(2, 0.25f), {.exposure_stops = 1}),
            flip(noise(1, 0.5f), noise(2, 0.5f), {.exposure_stops = 0}));
  EXPECT_EQ(meanFlip(uniform(Rgb(1.5f)), uniform(Rgb(40))), 0);
  EXPECT_GT(meanFlip(uniform(Rgb(1.5f)), uniform(Rgb(40)), {.exposure_stops = -2}), 0.1);
  EXPECT_EQ(meanFlip(uniform(Rgb(-3)), uniform(Rgb(0))), 0);
}

TEST(Flip, IsTheSameForAnyNumberOfThreads) {
  const LinearPicture a = noise(8, 1, 300, 140), b = noise(9, 1, 300, 140);
  EXPECT_EQ(flip(a, b, {}, 1), flip(a, b, {}, 3));
}

TEST(Flip, TakesPicturesOfOnePixelAndTheExtremesOfDistance) {
  for (const double ppd : {Viewing::kMinPixelsPerDegree, Viewing::kMaxPixelsPerDegree}) {
    EXPECT_NEAR(meanFlip(uniform(Rgb(0), 1, 1), uniform(Rgb(1), 1, 1), {.pixelsPerDegree = ppd}), 0.967, 1e-3);
    for (const float error : flip(noise(1), noise(2), {.pixelsPerDegree = ppd})) EXPECT_TRUE(error >= 0 && error <= 1);
  }
}

}  // namespace
}  // namespace loomlight
