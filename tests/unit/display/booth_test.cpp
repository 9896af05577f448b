#include "render/display/booth.h"

#include <gtest/gtest.h>

#include <array>

#include "render/display/recolour.h"
#include "render/transport/path_light.h"
#include "tests/support/narrow_dye.h"

namespace loomlight {
namespace {

constexpr int kWidth = 40, kHeight = 24;
using Lamps = std::array<Recolouring, kBoothLamps.size()>;

Fabric dyed() {
  Fabric fabric;
  fabric.light.kind = LightKind::dome;
  fabric.fibres[0].absorption_per_mm = Absorption(test::narrowDye(60));
  return fabric;
}

Fabric lit(Fabric fabric, StandardIlluminant lamp) {
  fabric.light = underLamp(fabric.light, lamp);
  return fabric;
}

Lamps lampsOf(const Fabric& fabric) {
  Lamps lamps;
  for (size_t i = 0; i < lamps.size(); ++i) lamps[i] = recolouringTo(lit(fabric, kBoothLamps[i]), fabric.light);
  return lamps;
}

/// Of light that has gone so far through the dye.
Rgb seen(float length_mm, const Colouring& colouring) {
  return colourOf({Rgb(0.8f)}, std::array{length_mm}, colouring);
}

/// A record of one path through each pixel, which has gone as far as `length_mm` says.
class Walked : public PathRecords {
 public:
  template <class Length>
  Walked(const Fabric& fabric, const Length& length_mm) : PathRecords(kWidth, kHeight, 1, size_t{1} << 20) {
    const Colouring colouring = colouringOf(fabric);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        PathLog log;
        log.gathers({Rgb(0.8f)}, std::array{length_mm(x, y)}, 1);
        add(x, y, seen(length_mm(x, y), colouring), log);
      }
  }
};

/// Every pixel is told from every other.
Frame frameOf(int width, int height) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      frame.rgba.emplace_back(0.1f + 0.01f * static_cast<float>(x), 0.2f + 0.01f * static_cast<float>(y), 0.5f, 0.75f);
      Film::Hit hit;
      hit.yarn = 0;
      hit.end = x;
      hit.pick = y;
      frame.hits.push_back(hit);
    }
  return frame;
}

void expectNear(const Rgb& a, const Rgb& b, float within) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], within) << c;
}

TEST(BoothPixel, EveryQuarterShowsTheMiddle) {
  constexpr glm::ivec2 kSizes[] = {{8, 6}, {9, 7}, {2, 1}, {1, 1}};
  for (const glm::ivec2 size : kSizes) {
    const PixelRect piece = boothPiece(size.x, size.y);
    EXPECT_LE(std::abs(2 * piece.x + piece.width - size.x), 1) << "in the middle";
    EXPECT_LE(std::abs(2 * piece.y + piece.height - size.y), 1);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const BoothPixel at = boothPixel(x, y, size.x, size.y);
        const bool right = x >= piece.width, low = y >= piece.height;
        EXPECT_EQ(at.lamp, (low ? 2u : 0u) + (right ? 1u : 0u));
        EXPECT_EQ(at.x, piece.x + (right ? x - piece.width : x));
        EXPECT_EQ(at.y, piece.y + (low ? y - piece.height : y));
        EXPECT_LT(at.x, piece.x + piece.width);
        EXPECT_LT(at.y, piece.y + piece.height);
      }
  }
}

// Scarlet has hardly any green by daylight: what noise has left of it says nothing by its ratio.
TEST(LightChange, AWeakChannelIsNoSpark) {
  const Rgb to(0.5f, 0.03f, 0.04f);
  for (const float green : {-0.001f, 0.0f, 1e-5f, 0.002f, 0.01f}) {
    const Rgb from(0.4f, green, 0.02f), quiet(0.2f, 0.006f, 0.01f);
    const LightChange change = changeOfLight(from, to, Rgb(1));
    expectNear(change(from), to, 1e-6f);
    EXPECT_NEAR(change(quiet).r, 0.25f, 1e-6f) << "what is strong changes by its ratio";
    // The luminance of `quiet` is about half of that of `from`, so it takes up half of what green is gained.
    EXPECT_NEAR(change(quiet).g, 0.006f + 0.5f * (to.g - green), 0.004f) << green;
  }
}

TEST(Booth, EachQuarterHasTheColourOfItsLamp) {
  const Fabric fabric = dyed();
  const Lamps lamps = lampsOf(fabric);
  constexpr float kLength_mm = 0.04f;
  const Walked records(fabric, [](int, int) { return kLength_mm; });
  const BoothChanges changes = boothChanges(Film(kWidth, kHeight), records, nullptr, lamps, 1);
  const Rgb inDaylight = seen(kLength_mm, colouringOf(fabric));
  for (size_t i = 0; i < lamps.size(); ++i) {
    const Rgb underLamp = seen(kLength_mm, colouringOf(lit(fabric, kBoothLamps[i])));
    for (size_t k = 0; k < i; ++k)
      EXPECT_GT(glm::length(underLamp - seen(kLength_mm, lamps[k].colouring)), 0.02f) << "lamps that look alike";
    const Frame frame = frameOf(kWidth, kHeight);
    const std::vector<glm::vec4> picture = boothPicture(frame, changes);
    ASSERT_EQ(picture.size(), frame.rgba.size());
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const BoothPixel from = boothPixel(x, y, kWidth, kHeight);
        if (from.lamp != i) continue;
        const glm::vec4 whole = frame.rgba[static_cast<size_t>(from.y) * kWidth + static_cast<size_t>(from.x)];
        const glm::vec4 shown = picture[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)];
        expectNear(Rgb(shown), Rgb(whole) * underLamp / inDaylight, 1e-4f);
        EXPECT_EQ(shown.a, whole.a);
      }
  }
}

// A picture that is shown in other colours than it was traced in: its daylight is what is shown already.
TEST(Booth, OfARecolouredPictureIsThatOfTheNewDye) {
  const Fabric traced = dyed();
  Fabric wanted = traced;
  wanted.fibres[0].absorption_per_mm = Absorption(test::narrowDye(25));
  const Recolouring shown = recolouringTo(wanted, traced.light);
  const Walked records(traced, [](int, int) { return 0.04f; });
  const BoothChanges changes = boothChanges(Film(kWidth, kHeight), records, &shown, lampsOf(wanted), 2);
  const LampChanges& at = changes.at(kWidth / 2, kHeight / 2, kWidth, kHeight);
  const Rgb asShown = seen(0.04f, colouringOf(wanted));
  expectNear(at[0](asShown), asShown, 1e-5f);
  for (size_t i = 1; i < at.size(); ++i)
    expectNear(at[i](asShown), seen(0.04f, colouringOf(lit(wanted, kBoothLamps[i]))), 1e-4f);
}

// The paths of a coarse pass say what they know to a fine frame, at the same place.
TEST(Booth, APassServesAPictureOfAnySize) {
  const Fabric fabric = dyed();
  const auto length_mm = [](int x, int y) { return 0.01f + 0.001f * static_cast<float>(x / 10 + 3 * (y / 6)); };
  const BoothChanges changes =
      boothChanges(Film(kWidth, kHeight), Walked(fabric, length_mm), nullptr, lampsOf(fabric), 1);
  for (const int y : {8, 15})  // in the middle of steps, where all around are alike
    for (const int x : {14, 25})
      for (size_t i = 0; i < kBoothLamps.size(); ++i) {
        const Rgb inDaylight = seen(length_mm(x, y), colouringOf(fabric));
        const Rgb expected = seen(length_mm(x, y), colouringOf(lit(fabric, kBoothLamps[i])));
        expectNear(changes.at(x, y, kWidth, kHeight)[i](inDaylight), expected, 1e-4f);
        expectNear(changes.at(4 * x + 3, 4 * y, 4 * kWidth, 4 * kHeight)[i](inDaylight), expected, 1e-4f);
      }
}

TEST(Booth, WhereThereAreNoPathsLightStaysAsItIs) {
  const PathRecords none(kWidth, kHeight, 1, size_t{1} << 20);
  const BoothChanges changes = boothChanges(Film(kWidth, kHeight), none, nullptr, lampsOf(dyed()), 1);
  const Rgb light(0.5f, 0.01f, 0.2f);
  for (const LightChange& change : changes.at(kWidth / 2, kHeight / 2, kWidth, kHeight))
    EXPECT_EQ(change(light), light);
}

TEST(Booth, CrossingsAreDividedAsThePictureIs) {
  const Frame frame = frameOf(9, 7);
  const std::vector<Film::Hit> hits = boothHits(frame);
  ASSERT_EQ(hits.size(), frame.hits.size());
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) {
      const BoothPixel from = boothPixel(x, y, 9, 7);
      EXPECT_EQ(hits[static_cast<size_t>(9 * y + x)].end, from.x);
      EXPECT_EQ(hits[static_cast<size_t>(9 * y + x)].pick, from.y);
    }
}

TEST(Booth, ItsLampsHaveNoTint) {
  Light light;
  light.illuminant = StandardIlluminant::blackBody;
  light.temperature_K = 2856;
  EXPECT_EQ(underLamp(light, StandardIlluminant::blackBody), light);
  EXPECT_EQ(underLamp(light, StandardIlluminant::d65).temperature_K, 6500) << "that was another lamp's";
  light.illuminant = StandardIlluminant::d65;
  EXPECT_EQ(underLamp(light, StandardIlluminant::d65).temperature_K, 6500) << "what it says is daylight";
}

}  // namespace
}  // namespace loomlight
