#include "app/cli/path_transcript.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"

namespace loomlight {
namespace {

Fabric dyedCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.camera.distance_mm = 5;
  fabric.render.resolution = 2;
  fabric.light.kind = LightKind::sky;
  fabric.fibres[0].absorption_per_mm = Rgb(20, 5, 1);
  return fabric;
}

/// The three numbers behind a word at the beginning of a line.
Rgb numbersAfter(const std::string& text, const std::string& word) {
  Rgb numbers(-1);
  const size_t at = text.find("\n" + word + " ");
  EXPECT_NE(at, std::string::npos) << word;
  if (at != std::string::npos) {
    EXPECT_EQ(std::sscanf(text.c_str() + at + 1 + word.size(), "%f %f %f", &numbers.r, &numbers.g, &numbers.b), 3);
  }
  return numbers;
}

class Transcript : public testing::TestWithParam<test::MediumKind> {};

// What is printed of a sample is what its picture holds of it, to the last bit of the film.
TEST_P(Transcript, AddsUpToWhatTheFilmGot) {
  Fabric fabric = dyedCloth();
  GetParam().askFor(fabric);
  const auto scene = test::sceneOf(fabric);
  const auto medium = GetParam().make(*scene);
  constexpr int kSide = 8;
  const CameraRays camera(fabric.camera, kSide, kSide);
  int lit = 0;
  for (int y = 1; y < kSide; y += 2)
    for (int x = 1; x < kSide; x += 2)
      for (const uint32_t sample : {0u, 5u}) {
        Film film(kSide, kSide), told(kSide, kSide);
        renderUpTo(1, *scene, *medium, camera, film, Task{}, {.window = PixelRect{x, y, 1, 1}, .firstSample = sample});
        PathTranscript transcript(*scene, {"cotton"});
        TraceCounts counts;
        tracePath(*scene, *medium, camera, x, y, sample, counts, &transcript);
        PathSample read;
        read.direct = numbersAfter(transcript.text(), "direct");
        read.indirect = numbersAfter(transcript.text(), "indirect");
        told.add(x, y, sample, read);
        ASSERT_EQ(told.mean(x, y), film.mean(x, y)) << transcript.text();
        ASSERT_EQ(numbersAfter(transcript.text(), "sum"), read.direct + read.indirect);
        lit += film.mean(x, y) != Rgb(0);
      }
  EXPECT_GT(lit, 10);
}

INSTANTIATE_TEST_SUITE_P(EveryMedium, Transcript,
                         testing::Values(test::kPlain, test::kReport, test::kLoomlight, test::kFibres),
                         [](const auto& info) { return info.param.name; });

TEST(PathTranscript, SaysWhatWasMetAndWhyThePathEnded) {
  Fabric fabric = dyedCloth();
  fabric.render.maxDepth = 1;
  const auto scene = test::sceneOf(fabric);
  const auto medium = test::kLoomlight.make(*scene);
  PathTranscript transcript(*scene, {"madder"});
  TraceCounts counts;
  tracePath(*scene, *medium, CameraRays(fabric.camera, 8, 8), 4, 4, 0, counts, &transcript);
  EXPECT_THAT(transcript.text(), testing::HasSubstr("event 1: "));
  EXPECT_THAT(transcript.text(), testing::HasSubstr("yarn 0 'madder'"));
  EXPECT_THAT(transcript.text(), testing::HasSubstr("end: it has as many events as it may"));
  EXPECT_THAT(transcript.text(), testing::Not(testing::HasSubstr("event 2")));
}

}  // namespace
}  // namespace loomlight
