#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "render/film/film.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/film/film_samples.h"

namespace loomlight {
namespace {

using test::addAll;
using test::expectSameSums;
using testing::HasSubstr;

constexpr int kWidth = 17, kHeight = 9;

TEST(FilmFile, SumsSurviveARealFileBitForBit) {
  const test::ScratchFolder folder;
  Film film(kWidth, kHeight);
  addAll(film, {0, 1, 2, 3, 4});
  writeExr(folder.file("a.exr"), film.toImage(true));
  expectSameSums(film, Film::fromImage(readExr(folder.file("a.exr")), "a.exr"));
}

TEST(FilmFile, ResumedEqualsUninterrupted) {
  const test::ScratchFolder folder;
  Film whole(kWidth, kHeight), first(kWidth, kHeight);
  addAll(whole, {0, 1, 2, 3, 4, 5, 6});
  addAll(first, {0, 1, 2});
  writeExr(folder.file("a.exr"), first.toImage(true));
  Film resumed = Film::fromImage(readExr(folder.file("a.exr")), "a.exr");
  addAll(resumed, {3, 4, 5, 6});
  expectSameSums(whole, resumed);
}

TEST(FilmFile, TheLargestSumsSurviveToo) {
  Film film(1, 1);
  PathSample s;
  s.alpha = 1;
  s.direct = s.indirect = Rgb(1e30f);
  s.depth_mm = 1e30f;
  s.normal = {1, -1, 1};
  s.tangent = {-1, 1, -1};
  s.yarn = s.end = s.pick = std::numeric_limits<int>::max();
  for (uint32_t i = 0; i < Film::maxSamples; ++i) film.add(0, 0, i, s);
  expectSameSums(film, Film::fromImage(film.toImage(true), "a.exr"));
}

TEST(FilmFile, A4kPictureWithItsSumsCanBeReadBack) {
  // readExr takes 2 GB of pixels.
  const size_t channels = Film(1, 1).toImage(true).channels.size();
  EXPECT_LE(channels * 3840 * 2160 * sizeof(float), size_t{1} << 31);
}

TEST(FilmFile, PicturesWithoutSumsAreRefused) {
  const std::string message = test::messageOf<InputError>([] { Film::fromImage(Film(2, 2).toImage(false), "b.exr"); });
  EXPECT_THAT(message, HasSubstr("b.exr"));
  EXPECT_THAT(message, HasSubstr("no sums"));
}

TEST(FilmFile, MissingChannelsAreNamed) {
  Image image = Film(2, 2).toImage(true);
  std::erase_if(image.channels, [](const Image::Channel& c) { return c.name == "sum.direct.G.1"; });
  EXPECT_THAT(test::messageOf<InputError>([&] { Film::fromImage(image, "b.exr"); }), HasSubstr("sum.direct.G.1"));
}

TEST(FilmFile, OtherVersionsOfTheSumsAreRefused) {
  Image image = Film(2, 2).toImage(true);
  image.metadata["loomlight.sums"] = "99";
  EXPECT_THAT(test::messageOf<InputError>([&] { Film::fromImage(image, "b.exr"); }), HasSubstr("99"));
}

TEST(FilmFile, DamagedSumsAreRefusedWithTheirPixel) {
  Film film(3, 2);
  addAll(film, {0, 1, 2, 3});
  const Image sound = film.toImage(true);
  const float bad[] = {0.5f, -1.0f, 0x1p25f, std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity()};
  size_t tried = 0;
  for (size_t c = 0; c < sound.channels.size(); ++c) {
    if (!sound.channels[c].name.starts_with("sum.") || sound.channels[c].name == "sum.hitDepth") continue;
    Image image = sound;
    image.channels[c].values[4] = bad[c % std::size(bad)];
    EXPECT_THAT(test::messageOf<InputError>([&] { Film::fromImage(image, "b.exr"); }), HasSubstr("pixel 1, 1"))
        << image.channels[c].name;
    ++tried;
  }
  EXPECT_EQ(tried, 42u);
}

TEST(FilmFile, SumsThatCouldOverflowAreRefused) {
  Film film(1, 1);
  addAll(film, {0, 1, 2, 3});
  for (const auto& [name, value] : {std::pair{"sum.samples", 2e6f}, {"sum.hits", 5.0f}, {"sum.normal.X.1", 32767.0f}}) {
    Image image = film.toImage(true);
    for (Image::Channel& channel : image.channels)
      if (channel.name == name) channel.values[0] = value;
    EXPECT_THROW(Film::fromImage(image, "b.exr"), InputError) << name;
  }
}

}  // namespace
}  // namespace loomlight
