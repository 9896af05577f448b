#include "app/workers/display_picture.h"

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
  const Pixels8 a{2, 1, 3, {10, 20, 30, 200, 100, 0}}, b{2, 1, 3, {10, 25, 30, 100, 100, 0}};
  EXPECT_EQ(differencePicture(a, a).bytes, std::vector<uint8_t>(6, 0));
  EXPECT_EQ(differencePicture(a, b).bytes, (std::vector<uint8_t>{0, 20, 0, 255, 0, 0}));
  const Pixels8 one{1, 1, 3, {10, 20, 30}};
  EXPECT_EQ(differencePicture(a, one).bytes, (std::vector<uint8_t>{0, 0, 0, 255, 255, 120})) << "stretched over it";
}

}  // namespace
}  // namespace loomlight
