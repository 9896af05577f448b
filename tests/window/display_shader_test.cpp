/// The shader of the display beside the C++ that pictures are written with: the same colours, so that a PNG looks like
/// the viewport. Needs a display; run by tests/e2e/editor/display_shader_test.py.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "app/editor/display/texture_id.h"
#include "app/editor/gl/display_pass.h"
#include "app/editor/gl/opengl_driver.h"
#include "app/editor/gl/window.h"
#include "render/colour/icc_profile.h"
#include "render/display/display_picture.h"

namespace loomlight {
namespace {

/// A block of equal pixels for each light, and what lies between pixels is no matter: the middle is looked at.
constexpr int kBlock = 5;

/// Without infinity, of which a filter makes something else, and which no film holds.
std::vector<glm::vec4> lights() {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> values = {0,    1e-40f, 1e-6f, 0.0031307f, 0.0031308f, 0.0031309f, 0.6999f, 0.7f,
                               1e4f, 1e10f,  1e30f, 3e38f,      -1e-3f,     -1,         -1e30f,  kNone};
  for (int i = 0; i < 60; ++i) values.push_back(std::exp2(-10 + 0.25f * static_cast<float>(i)));  // 0.001 to 27
  std::vector<glm::vec4> lights;
  for (const float v : values)
    for (const float alpha : {1.0f, 0.4f, 0.0f}) {
      lights.emplace_back(v, v, v, alpha);
      lights.emplace_back(v, 0.2f, 0.05f, alpha);
      lights.emplace_back(0.9f, v, 1e-3f, alpha);
      lights.emplace_back(0.0f, 3.0f, v, alpha);
    }
  return lights;
}

Frame blocksOf(const std::vector<glm::vec4>& lights) {
  const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(lights.size()))));
  Frame frame;
  frame.width = frame.height = side * kBlock;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const size_t block =
          static_cast<size_t>(y / kBlock) * static_cast<size_t>(side) + static_cast<size_t>(x / kBlock);
      frame.rgba.push_back(lights[std::min(block, lights.size() - 1)]);
    }
  return frame;
}

/// As the viewport shows it, in four channels.
std::vector<uint8_t> shownByShader(const Frame& frame, const Tone& tone, const SoftProof& proof = {}) {
  OpenGlDriver driver;
  const auto viewport = driver.makeViewport();
  viewport->upload(frame.width, frame.height, frame.rgba, {});
  const ImTextureID shown = viewport->display(frame.width, frame.height, tone, proof, std::nullopt);
  std::vector<uint8_t> pixels(4 * frame.rgba.size());
  glBindTexture(GL_TEXTURE_2D, textureNumber(shown));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

/// Both round to one of 256 steps; a value between two of them may go either way.
void expectSame(const Frame& frame, const Tone& tone) {
  const std::vector<uint8_t> shader = shownByShader(frame, tone);
  const Pixels8 written = displayPicture(frame, tone);
  for (int y = kBlock / 2; y < frame.height; y += kBlock)
    for (int x = kBlock / 2; x < frame.width; x += kBlock) {
      const size_t i = static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x);
      const glm::vec4& light = frame.rgba[i];
      for (size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(shader[4 * i + c], written.bytes[3 * i + c], 1)
            << "channel " << c << " of " << light.r << " " << light.g << " " << light.b << " alpha " << light.a
            << " at " << tone.exposure_stops << " stops, " << (tone.filmic ? "filmic" : "plain");
    }
}

TEST(DisplayShader, EqualsWhatPicturesAreWrittenWith) {
  Window window("Shader", 960, 600, 1);
  const Frame frame = blocksOf(lights());
  for (const bool filmic : {true, false})
    for (const float stops : {-3.0f, 0.0f, 2.5f})
      for (const Rgb background : {Rgb(0.18f), Rgb(0.02f, 0.3f, 0.9f)}) expectSame(frame, {stops, filmic, background});
}

/// A print that is paler than the picture, and the further from it the purer a colour is.
std::shared_ptr<const ColourCube> palePrints() {
  std::vector<glm::vec4> corners;
  constexpr int n = ColourCube::kSide;
  for (int i = 0; i < n * n * n; ++i) {
    const glm::vec3 c(ColourCube::cornerAt(i % n), ColourCube::cornerAt(i / n % n), ColourCube::cornerAt(i / n / n));
    const float chroma = std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
    corners.emplace_back(0.2f + 0.7f * c, 8 * chroma);
  }
  return std::make_shared<const ColourCube>(std::move(corners));
}

TEST(DisplayShader, ShowsTheSameProofAsTheCode) {
  Window window("Shader", 960, 600, 1);
  const Tone tone;
  std::vector<glm::vec4> lights;
  for (int i = 0; i < 200; ++i) {
    const auto channel = [i](int step) { return 0.02f * static_cast<float>((i * step) % 37); };
    lights.emplace_back(channel(7), channel(11), channel(17), 1);
  }
  const Frame frame = blocksOf(lights);
  const auto prints = palePrints();
  for (const bool warns : {false, true}) {
    const SoftProof proof{prints, warns};
    const std::vector<uint8_t> shader = shownByShader(frame, tone, proof);
    int marked = 0;
    for (int y = kBlock / 2; y < frame.height; y += kBlock)
      for (int x = kBlock / 2; x < frame.width; x += kBlock) {
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x);
        const Rgb encoded = toDisplay(Rgb(frame.rgba[i]), tone), expected = proofed(encoded, proof);
        marked += expected == kGamutWarning ? 1 : 0;
        // Where the mark begins either is right.
        if (warns && std::abs(prints->at(encoded).a - kOutOfGamut_deltaE) < 0.05f) continue;
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(shader[4 * i + static_cast<size_t>(c)], 255 * expected[c], 1.5f) << x << " " << y;
      }
    EXPECT_EQ(marked > 10, warns);
  }
}

/// Without a print what sRGB has not is marked, where that was asked for; with one the printer's gamut is meant.
TEST(DisplayShader, MarksTheSameColoursBeyondSrgbAsTheCode) {
  Window window("Shader", 960, 600, 1);
  const Tone tone;
  std::vector<glm::vec4> lights;
  for (int i = 0; i < 200; ++i) lights.emplace_back(0.5f, 0.2f, 0.001f * static_cast<float>(i % 50 - 40) + 1e-4f, 1);
  const Frame frame = blocksOf(lights);
  for (const SoftProof& proof : {SoftProof{}, SoftProof{nullptr, true}, SoftProof{palePrints(), false}}) {
    const std::vector<uint8_t> shader = shownByShader(frame, tone, proof);
    int marked = 0;
    for (int y = kBlock / 2; y < frame.height; y += kBlock)
      for (int x = kBlock / 2; x < frame.width; x += kBlock) {
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x);
        const Rgb light(frame.rgba[i]);
        const bool marks = proof.warnsOfGamut && isBeyondSrgb(light);
        const Rgb expected = marks ? kGamutWarning : proofed(toDisplay(light, tone), proof);
        marked += marks ? 1 : 0;
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(shader[4 * i + static_cast<size_t>(c)], 255 * expected[c], 1.5f) << light.b;
      }
    EXPECT_EQ(marked > 10, proof.warnsOfGamut);
  }
}

/// All that is drawn between begin() and end().
TEST(DisplayPass, BringsWhatIsDrawnThroughTheCube) {
  Window window("Shader", 960, 600, 1);
  DisplayPass pass;
  const float encoded[] = {0.6f, 0.3f, 0.1f};
  const auto shown = [&](const std::shared_ptr<const ColourCube>& cube) {
    pass.use(cube);
    pass.begin(64, 64);
    glClearColor(encoded[0], encoded[1], encoded[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    pass.end();
    std::vector<uint8_t> pixel(4);
    glReadPixels(10, 10, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    return pixel;
  };
  const std::vector<uint8_t> plain = shown(nullptr), through = shown(palePrints()), again = shown(nullptr);
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(plain[c], 255 * encoded[c], 1);
    EXPECT_NEAR(through[c], 255 * (0.2f + 0.7f * encoded[c]), 1.5);
    EXPECT_EQ(again[c], plain[c]);
  }
}

/// A frame that changes nothing is not computed again; one that does, is.
TEST(DisplayShader, FollowsTonePictureAndSize) {
  Window window("Shader", 960, 600, 1);
  OpenGlDriver driver;
  const auto viewport = driver.makeViewport();
  const auto shown = [&](float light, const Tone& tone, int side) {
    const std::vector<glm::vec4> pixels(16, glm::vec4(light, light, light, 1));
    if (light >= 0) viewport->upload(4, 4, pixels, {});
    const ImTextureID texture = viewport->display(side, side, tone, SoftProof{}, std::nullopt);
    std::vector<uint8_t> bytes(static_cast<size_t>(4 * side * side));
    glBindTexture(GL_TEXTURE_2D, textureNumber(texture));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes[bytes.size() / 2];
  };
  constexpr float kSame = -1;  // the picture of before
  Tone tone;
  const uint8_t first = shown(0.2f, tone, 8);
  EXPECT_EQ(shown(kSame, tone, 8), first);
  tone.exposure_stops = 1;
  EXPECT_GT(shown(kSame, tone, 8), first) << "exposure";
  tone.exposure_stops = 0;
  EXPECT_EQ(shown(kSame, tone, 16), first) << "another size";
  EXPECT_LT(shown(0.1f, tone, 16), first) << "another picture";
}

/// How far the accent lies over grey cloth of the crossing (0, 0) of a repeat of 2 x 2, at most: 0 to 1. Each crossing
/// is so many pixels wide.
double strongestAccent(int pixelsOfCrossing) {
  constexpr int kSide = 64;
  OpenGlDriver driver;
  const auto viewport = driver.makeViewport();
  const std::vector<glm::vec4> grey(kSide * kSide, glm::vec4(0.2f, 0.2f, 0.2f, 1));
  std::vector<Film::Hit> hits;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) hits.push_back({0, x / pixelsOfCrossing, y / pixelsOfCrossing, 1});
  viewport->upload(kSide, kSide, grey, hits);
  const auto redsWith = [&](const std::optional<ViewportPicture::Outline>& outline) {
    glBindTexture(GL_TEXTURE_2D, textureNumber(viewport->display(kSide, kSide, Tone{}, SoftProof{}, outline)));
    std::vector<uint8_t> bytes(4 * kSide * kSide);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  };
  ViewportPicture::Outline outline;
  outline.ends = outline.picks = 2;
  outline.colour = Rgb(1, 0, 0);
  const std::vector<uint8_t> plain = redsWith(std::nullopt), outlined = redsWith(outline);
  double most = 0;
  for (size_t i = 0; i < plain.size(); i += 4) most = std::max(most, (outlined[i] - plain[i]) / (255.0 - plain[i]));
  return most;
}

/// Seen small, outlines in every repeat would lie over the cloth as specks.
TEST(DisplayShader, OutlinesCrossingsThatAreWideAndTintsThoseThatAreNot) {
  Window window("Shader", 960, 600, 1);
  EXPECT_NEAR(strongestAccent(16), 0.9, 0.02);
  EXPECT_NEAR(strongestAccent(4), 0.18, 0.02);
}

/// Rows of the picture lie further apart than those of the part.
TEST(DisplayShader, TakesAPartOfThePictureAlone) {
  Window window("Shader", 960, 600, 1);
  OpenGlDriver driver;
  const auto viewport = driver.makeViewport();
  std::vector<glm::vec4> pixels(16, glm::vec4(0.1f, 0.1f, 0.1f, 1));
  viewport->upload(4, 4, pixels, {});
  const auto greens = [&] {
    const ImTextureID texture = viewport->display(4, 4, Tone{}, SoftProof{}, std::nullopt);
    std::vector<uint8_t> bytes(4 * 16);
    glBindTexture(GL_TEXTURE_2D, textureNumber(texture));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<uint8_t> greens;
    for (size_t i = 1; i < bytes.size(); i += 4) greens.push_back(bytes[i]);
    return greens;
  };
  const std::vector<uint8_t> before = greens();
  for (size_t i = 0; i < 16; ++i) pixels[i] = glm::vec4(0.01f * static_cast<float>(20 + i));
  viewport->uploadParts(4, 4, pixels, {}, {1, 2, 2, 2}, {});
  const std::vector<uint8_t> after = greens();
  viewport->upload(4, 4, pixels, {});
  const std::vector<uint8_t> whole = greens();
  for (size_t i = 0; i < 16; ++i) {
    const bool isNew = i % 4 >= 1 && i % 4 <= 2 && i / 4 >= 2;
    EXPECT_EQ(after[i], isNew ? whole[i] : before[i]) << i;
    EXPECT_NE(before[i], whole[i]);
  }
}

// A window that leaves out frames which look alike asks the driver whether the pictures in them still do.
TEST(DisplayShader, ItsDriverKnowsWhenAPictureShowsSomethingElse) {
  Window window("Shader", 960, 600, 1);
  OpenGlDriver driver;
  const auto viewport = driver.makeViewport();
  const auto texture = driver.makeTexture();
  Frame frame;
  frame.width = frame.height = 4;
  frame.rgba.assign(16, glm::vec4(0.1f, 0.1f, 0.1f, 1));
  uint64_t before = driver.changes();
  const auto changed = [&] { return std::exchange(before, driver.changes()) != before; };
  const auto display = [&](float exposure_stops) {
    viewport->display(4, 4, Tone{.exposure_stops = exposure_stops}, SoftProof{}, std::nullopt);
    return changed();
  };
  viewport->upload(4, 4, frame.rgba, {});
  EXPECT_TRUE(display(0));
  EXPECT_FALSE(display(0)) << "nothing is new";
  EXPECT_TRUE(display(1));
  viewport->upload(4, 4, frame.rgba, {});
  EXPECT_TRUE(display(1)) << "another picture at the same exposure";
  texture->upload(displayPicture(frame, Tone{}));
  EXPECT_TRUE(changed());
}

}  // namespace
}  // namespace loomlight
