#include "render/display/denoise.h"

#include <gtest/gtest.h>

#include <random>

#include "core/fabric/json/fabric_json.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

using Picture = std::vector<glm::vec4>;

glm::dvec4 sumOf(std::span<const glm::vec4> pixels) {
  glm::dvec4 sum(0);
  for (const glm::vec4& pixel : pixels) sum += glm::dvec4(pixel);
  return sum;
}

void expectNear(const glm::dvec4& value, const glm::dvec4& expected, double relative) {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(value[c], expected[c], relative * std::abs(expected[c]));
}

/// Two yarns side by side, dark and bright, under noise of a known deviation.
struct TwoYarns {
  static constexpr int kSide = 24;
  TwoYarns() {
    std::mt19937 random(5);
    std::exponential_distribution<float> noise(1.0f);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const bool left = x < kSide / 2;
        const float level = left ? 0.1f : 0.2f, light = level * noise(random);
        rgba.emplace_back(light, 0.8f * light, 0.5f * light, 1);
        hits.push_back({left ? 0 : 1, left ? 3 : 4, 7, 25});
        variances.push_back(level * level);
      }
  }
  PixelTraits traits() const { return {hits, variances}; }
  glm::dvec4 sumOfLeft() const {
    glm::dvec4 sum(0);
    for (int y = 0; y < kSide; ++y) sum += sumOf(std::span(rgba).subspan(static_cast<size_t>(y) * kSide, kSide / 2));
    return sum;
  }
  double squaresAbout(float level, int begin) const {
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = begin; x < begin + kSide / 2; ++x) {
        const double apart = rgba[static_cast<size_t>(y) * kSide + x].r - level;
        sum += apart * apart;
      }
    return sum;
  }
  Picture rgba;
  std::vector<Film::Hit> hits;
  std::vector<float> variances;
};

TEST(Denoise, TakesNoiseAndNoneOfTheLight) {
  TwoYarns cloth;
  const glm::dvec4 before = sumOf(cloth.rgba);
  const double dark = cloth.squaresAbout(0.1f, 0), bright = cloth.squaresAbout(0.2f, TwoYarns::kSide / 2);
  denoise(cloth.rgba, cloth.traits(), TwoYarns::kSide, TwoYarns::kSide, 2);
  expectNear(sumOf(cloth.rgba), before, 1e-5);
  EXPECT_LT(cloth.squaresAbout(0.1f, 0), 0.5 * dark);
  EXPECT_LT(cloth.squaresAbout(0.2f, TwoYarns::kSide / 2), 0.5 * bright);
}

TEST(Denoise, NoLightPassesFromYarnToYarn) {
  for (const bool known : {true, false}) {
    TwoYarns cloth;
    const glm::dvec4 before = cloth.sumOfLeft();
    denoise(cloth.rgba, {cloth.hits, known ? cloth.variances : std::vector<float>{}}, TwoYarns::kSide, TwoYarns::kSide,
            1);
    expectNear(cloth.sumOfLeft(), before, 1e-5);
  }
}

TEST(Denoise, NoLightPassesFromFoldToFold) {
  TwoYarns cloth;
  for (Film::Hit& hit : cloth.hits) hit = {0, 3, 7, hit.yarn == 0 ? 25.0f : 30.0f};
  const glm::dvec4 before = cloth.sumOfLeft();
  denoise(cloth.rgba, cloth.traits(), TwoYarns::kSide, TwoYarns::kSide, 1);
  expectNear(cloth.sumOfLeft(), before, 1e-5);
}

TEST(Denoise, WithoutNoiseIsThePicture) {
  TwoYarns cloth;
  const Picture before = cloth.rgba;
  cloth.variances.assign(cloth.variances.size(), 0);
  denoise(cloth.rgba, cloth.traits(), TwoYarns::kSide, TwoYarns::kSide, 1);
  EXPECT_EQ(cloth.rgba, before);
}

// No pixel gives more than three quarters away at a time, and none receives from a brighter one more than it has.
TEST(Denoise, MakesNoColourThatWasNotThere) {
  TwoYarns cloth;
  const auto [least, most] =
      std::minmax_element(cloth.rgba.begin(), cloth.rgba.end(), [](auto& a, auto& b) { return a.r < b.r; });
  const float low = least->r, high = most->r;
  denoise(cloth.rgba, cloth.traits(), TwoYarns::kSide, TwoYarns::kSide, 1);
  for (const glm::vec4& pixel : cloth.rgba) {
    EXPECT_GE(pixel.r, low);
    EXPECT_LE(pixel.r, high);
    EXPECT_FLOAT_EQ(pixel.a, 1);
  }
}

// One lucky path to the sun: it is spread, where despeckle() would take its light away.
TEST(Denoise, SpreadsWhatStandsOutAlone) {
  constexpr int kSide = 32, kMiddle = kSide * kSide / 2 + kSide / 2;
  for (const bool known : {true, false}) {
    Picture rgba(kSide * kSide, glm::vec4(0.1f, 0.1f, 0.1f, 1));
    rgba[kMiddle] = {20, 20, 20, 1};
    const std::vector<Film::Hit> hits(rgba.size(), {0, 1, 1, 25});
    std::vector<float> variances(rgba.size(), 1e-4f);
    variances[kMiddle] = 400;
    const glm::dvec4 before = sumOf(rgba);
    denoise(rgba, {hits, known ? variances : std::vector<float>{}}, kSide, kSide, 1);
    expectNear(sumOf(rgba), before, 1e-5);
    EXPECT_LT(rgba[kMiddle].r, 1.0f) << known;
  }
}

TEST(Denoise, TakesPicturesOfAnySize) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {1, 7}, {9, 1}, {2, 3}}) {
    const auto pixels = static_cast<size_t>(width * height);
    Picture rgba(pixels, glm::vec4(1));
    denoise(rgba, {std::vector<Film::Hit>(pixels), std::vector<float>(pixels, 1.0f)}, width, height, 1);
    for (const glm::vec4& pixel : rgba) EXPECT_EQ(pixel, glm::vec4(1));
  }
}

/// Pictures of a sample, seen as the editor's window shows it: a detail at the size of its pixels.
class SampleView {
 public:
  static constexpr int kWidth = 48, kHeight = 32;
  explicit SampleView(const std::string& name) : fabric_(readFabric(LOOMLIGHT_SAMPLES "/" + name + ".json")) {
    constexpr double kWindowHeight = 700;
    fabric_.camera.fov_deg *= kHeight / kWindowHeight;
    fabric_.render.resolution = 4;
    fabric_.drape.kind = DrapeKind::flat;
    fabric_.drape.width_mm = fabric_.drape.height_mm = 6;
    fabric_.camera.target_mm = glm::dvec3(0);
    scene_ = test::sceneOf(fabric_);
    medium_ = makeMedium(*scene_, 1e9, Task{});
  }
  Film traced(uint32_t samples, uint32_t first) const {
    Film film(kWidth, kHeight);
    renderUpTo(samples, *scene_, *medium_, CameraRays(fabric_.camera, kWidth, kHeight), film, Task{},
               {.firstSample = first});
    return film;
  }

 private:
  Fabric fabric_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Medium> medium_;
};

double squaredError(const Picture& picture, const Picture& truth) {
  double sum = 0;
  for (size_t i = 0; i < picture.size(); ++i) {
    const Rgb apart = Rgb(picture[i]) - Rgb(truth[i]);
    sum += glm::dot(apart, apart);
  }
  return sum;
}

// Noise of n samples weighs 1/n, that of the reference 1/96; what is halved is all of it at 1, 4 and 16 samples.
TEST(Denoise, BringsPicturesOfFewSamplesNearerToTheConvergedOne) {
  for (const char* name : {"denim", "wool_suiting", "colourful_cloth"}) {
    const SampleView view(name);
    Picture truth;
    view.traced(96, 16).toDisplayBuffer(truth, 1);
    for (const uint32_t samples : {1u, 4u, 16u}) {
      const Film film = view.traced(samples, 0);
      Picture noisy;
      film.toDisplayBuffer(noisy, 1);
      std::vector<Film::Hit> hits;
      std::vector<float> variances;
      for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
          hits.push_back(film.hit(x, y));
          if (samples > 1) variances.push_back(film.variance(x, y));
        }
      Picture clear = noisy;
      denoise(clear, {hits, variances}, film.width(), film.height(), 1);
      EXPECT_LT(squaredError(clear, truth), 0.5 * squaredError(noisy, truth)) << name << ", " << samples;
      expectNear(sumOf(clear), sumOf(noisy), 1e-5);
    }
  }
}

}  // namespace
}  // namespace loomlight
