#include "render/display/display_picture.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(DisplayPicture, IsWhatAPngOfTheSameLightIs) {
  Film film(2, 1);
  PathSample sample;
  sample.direct = Rgb(0.4f, 0.1f, 0.02f);
  sample.alpha = 1;
  film.add(0, 0, 0, sample);
  film.add(1, 0, 0, PathSample{});
  Frame frame;
  frame.width = 2;
  frame.height = 1;
  film.toDisplayBuffer(frame.rgba);
  Tone tone;
  tone.exposure_stops = 1.5f;
  const Pixels8 png = toPixels(film, tone), shown = displayPicture(frame, tone);
  ASSERT_EQ(shown.bytes.size(), png.bytes.size());
  for (size_t i = 0; i < png.bytes.size(); ++i) EXPECT_NEAR(shown.bytes[i], png.bytes[i], 1) << i;
}

TEST(DisplayPicture, IsOfWhatWasTracedWhateverTheDisplayShows) {
  Frame frame;
  frame.width = frame.height = 1;
  frame.rgba = {glm::vec4(0.2f, 0.4f, 0.1f, 1)};
  const Pixels8 traced = displayPicture(frame, Tone{});
  frame.helped = {glm::vec4(0.5f, 0.1f, 0.3f, 1)};
  EXPECT_EQ(frame.shown()[0], frame.helped[0]);
  EXPECT_EQ(displayPicture(frame, Tone{}).bytes, traced.bytes);
  frame.denoised = {glm::vec4(0.7f, 0.2f, 0.2f, 1)};
  EXPECT_EQ(frame.shown()[0], frame.denoised[0]);
  EXPECT_EQ(displayPicture(frame, Tone{}).bytes, traced.bytes);
}

TEST(DifferencePicture, IsBlackWhereTheyAreAlikeAndBrightensFourTimes) {
  const Pixels8 a{1, 1, 3, {10, 20, 200}}, b{1, 1, 3, {10, 25, 100}};
  EXPECT_EQ(differencePicture(a, a).bytes, std::vector<uint8_t>(3, 0));
  EXPECT_EQ(differencePicture(a, b).bytes, (std::vector<uint8_t>{0, 20, 255}));
}

TEST(DifferencePicture, IsOfMeansSoThatNoiseIsNoDifference) {
  Pixels8 even{12, 12, 3, std::vector<uint8_t>(3 * 144, 100)}, noisy = even;
  for (size_t i = 0; i < 144; ++i)
    for (size_t c = 0; c < 3; ++c) noisy.bytes[3 * i + c] = static_cast<uint8_t>((i + i / 12) % 2 == 0 ? 120 : 80);
  // Of 3 x 3 alternating pixels one is left over, at the edges none of fewer.
  for (const uint8_t byte : differencePicture(even, noisy).bytes) EXPECT_LE(byte, 4 * 20 / 9 + 1);
}

TEST(DifferencePicture, ShowsThreadsOfTwoPixelsThatAreTurnedOver) {
  Pixels8 weave{16, 16, 3, {}}, turned{16, 16, 3, {}};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool up = (x / 2 + y / 2) % 2 == 0;
      weave.bytes.insert(weave.bytes.end(), 3, up ? 60 : 180);
      turned.bytes.insert(turned.bytes.end(), 3, up ? 180 : 60);
    }
  // Of 3 x 3 pixels over checks of 2 x 2, nine, three or one are of one side more than of the other.
  for (const uint8_t byte : differencePicture(weave, turned).bytes) EXPECT_GE(byte, 4 * 120 / 9);
}

TEST(DifferencePicture, LeavesGreyBesideANarrowerOneAndComparesHeights) {
  const Pixels8 wide{6, 2, 3, std::vector<uint8_t>(36, 50)}, narrow{4, 4, 3, std::vector<uint8_t>(48, 60)};
  const Pixels8 found = differencePicture(wide, narrow);
  for (size_t y = 0; y < 2; ++y)
    for (size_t x = 0; x < 6; ++x) EXPECT_EQ(found.bytes[3 * (6 * y + x)], x < 2 || x > 3 ? 118 : 40) << x << ", " << y;
  const Pixels8 back = differencePicture(narrow, wide);
  EXPECT_EQ(back.bytes, std::vector<uint8_t>(48, 40)) << "what the wider one shows beyond is not seen";
}

}  // namespace
}  // namespace loomlight
