#include "render/share/moved_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr int kColumns = 96, kRows = 60;
constexpr float kThickness_mm = 0.5f;

Camera cameraAt(double azimuth_deg, double fov_deg = 20) {
  Camera camera;
  camera.azimuth_deg = azimuth_deg;
  camera.elevation_deg = 60;
  camera.distance_mm = 30;
  camera.fov_deg = fov_deg;
  return camera;
}
CameraRays raysAt(double azimuth_deg, double fov_deg = 20) {
  return CameraRays(cameraAt(azimuth_deg, fov_deg), kColumns, kRows);
}

/// Light that hangs on the place alone, and changes slowly enough to be seen between pixels.
glm::vec4 paintAt(const glm::vec3& place) {
  return {2 + std::sin(place.x), 2 + std::sin(place.y), 2 + place.z, 1};
}

/// Where a ray meets the plane z = 0, or a strip that lies higher above it.
struct Painted {
  float strip_mm = 0;    ///< how high it lies
  float half_mm = 1.5f;  ///< of its width

  glm::vec3 met(const Ray& ray) const {
    const auto at = [&](float z) { return ray.origin + (z - ray.origin.z) / ray.direction.z * ray.direction; };
    const glm::vec3 high = at(strip_mm);
    return std::abs(high.x) < half_mm ? high : at(0);
  }
  Frame seenBy(const CameraRays& camera) const {
    Frame frame;
    frame.width = kColumns;
    frame.height = kRows;
    frame.window = {0, 0, kColumns, kRows};
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kColumns; ++x) {
        const Ray ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const glm::vec3 place = met(ray);
        frame.rgba.push_back(paintAt(place));
        frame.hits.push_back({place.z > 0.01f ? 1 : 0, 0, 0, glm::distance(place, ray.origin)});
      }
    return frame;
  }
};

size_t keptOf(const MovedView& view) {
  return static_cast<size_t>(std::count(view.kept.begin(), view.kept.end(), 1));
}

// A pixel is a third of a millimetre and the paint changes by 1 a millimetre at most: what lies a pixel away is as
// bright within a third.
TEST(MovedView, ShowsEachPlaceAsItWas) {
  for (const double fov : {20.0, 0.0}) {
    SCOPED_TRACE(fov);
    const CameraRays from = raysAt(-90, fov), to = raysAt(-75, fov);
    const Frame earlier = Painted{}.seenBy(from), wanted = Painted{}.seenBy(to);
    const MovedView view = movedView(earlier, from, to, kThickness_mm, 2);
    EXPECT_GT(keptOf(view), wanted.rgba.size() * 8 / 10) << "corners come into the picture, and no more";
    for (size_t i = 0; i < wanted.rgba.size(); ++i) {
      if (!view.kept[i]) continue;
      EXPECT_LT(glm::distance(view.light[i], wanted.rgba[i]), 0.15f) << "pixel " << i;
      EXPECT_NEAR(view.hits[i].depth_mm, wanted.hits[i].depth_mm, 0.5f);
    }
  }
}

TEST(MovedView, IsThePictureItselfWhereNothingMoves) {
  const CameraRays camera = raysAt(-90);
  const Frame earlier = Painted{}.seenBy(camera);
  const MovedView view = movedView(earlier, camera, camera, kThickness_mm, 1);
  EXPECT_EQ(keptOf(view), earlier.rgba.size());
  for (size_t i = 0; i < earlier.rgba.size(); ++i)
    EXPECT_LT(glm::distance(view.light[i], earlier.rgba[i]), 1e-2f) << "pixel " << i;
}

/// Whether both the strip and the plane are seen within so many pixels of this one.
bool isAtAnEdge(const Frame& frame, int x, int y, int reach) {
  bool strip = false, plane = false;
  for (int v = std::max(0, y - reach); v <= std::min(kRows - 1, y + reach); ++v)
    for (int u = std::max(0, x - reach); u <= std::min(kColumns - 1, x + reach); ++u)
      (frame.hits[static_cast<size_t>(v * kColumns + u)].yarn == 1 ? strip : plane) = true;
  return strip && plane;
}

// The map of distances has a cell for two pixels each way, and a point falls into one that is at most a pixel from its
// own place: only within three pixels of an edge may the one be taken for the other. What was outside of the earlier
// picture hides nothing, so the border is left out.
TEST(MovedView, WhatWasHiddenIsNotMadeUp) {
  constexpr int kReach = 3;
  const Painted high{4};
  const CameraRays from = raysAt(-90);
  const Frame earlier = high.seenBy(from);
  for (const double azimuth_deg : {-50.0, -130.0}) {
    const CameraRays to = raysAt(azimuth_deg);
    const Frame wanted = high.seenBy(to);
    const MovedView view = movedView(earlier, from, to, kThickness_mm, 1);
    EXPECT_GT(keptOf(view), wanted.rgba.size() / 2);
    EXPECT_LT(keptOf(view), wanted.rgba.size());
    for (int y = kReach; y < kRows - kReach; ++y)
      for (int x = kReach; x < kColumns - kReach; ++x) {
        const auto i = static_cast<size_t>(y * kColumns + x);
        const bool isWrong = view.kept[i] && view.hits[i].yarn != wanted.hits[i].yarn;
        EXPECT_TRUE(!isWrong || isAtAnEdge(wanted, x, y, kReach)) << azimuth_deg << ": " << x << ", " << y;
      }
  }
}

// Two and a half pixels lie between the points that were seen.
TEST(MovedView, HasNoHolesNearer) {
  const Painted plane;
  const CameraRays from = raysAt(-90), to = raysAt(-90, 8);
  const MovedView view = movedView(plane.seenBy(from), from, to, kThickness_mm, 1);
  EXPECT_EQ(keptOf(view), view.kept.size());
}

// From so far away, and so low, a cell of the map is deeper than the cloth is thick.
TEST(MovedView, KeepsWhatIsSeenAtASlant) {
  Camera low = cameraAt(-90);
  low.elevation_deg = 15;
  low.distance_mm = 300;
  const CameraRays from(low, kColumns, kRows);
  low.azimuth_deg = -85;
  const CameraRays to(low, kColumns, kRows);
  const MovedView view = movedView(Painted{}.seenBy(from), from, to, kThickness_mm, 1);
  EXPECT_GT(keptOf(view), view.kept.size() * 8 / 10);
}

TEST(MovedView, TellsHowMuchOfTheClothIsMissing) {
  constexpr int kDivider = 12;
  const CameraRays from = raysAt(-90);
  const MovedView view = movedView(Painted{}.seenBy(from), from, from, kThickness_mm, 1);
  Film film(kColumns / kDivider, kRows / kDivider);
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) film.add(x, y, 0, PathSample{});
  EXPECT_EQ(missingIn(view, film, kDivider), 0) << "no cloth";
  PathSample cloth;
  cloth.yarn = 0;
  cloth.alpha = 1;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) film.add(x, y, 1, cloth);
  EXPECT_EQ(missingIn(view, film, kDivider), 0);
  MovedView half = view;
  std::fill_n(half.kept.begin(), half.kept.size() / 2, uint8_t{0});  // two rows and a half of the film's five
  EXPECT_NEAR(missingIn(half, film, kDivider), 0.5, 0.1);
}

TEST(MovedView, IsTheSameForAnyNumberOfThreads) {
  const CameraRays from = raysAt(-90), to = raysAt(-70);
  const Frame earlier = Painted{2}.seenBy(from);
  const MovedView one = movedView(earlier, from, to, kThickness_mm, 1);
  const MovedView three = movedView(earlier, from, to, kThickness_mm, 3);
  EXPECT_GT(keptOf(one), earlier.rgba.size() / 2);
  EXPECT_EQ(one.light, three.light);
  EXPECT_EQ(one.kept, three.kept);
}

TEST(MovedView, WhatIsMissingComesFromThePictureOfNow) {
  const CameraRays from = raysAt(-90), to = raysAt(-60);
  const MovedView view = movedView(Painted{}.seenBy(from), from, to, kThickness_mm, 1);
  Frame fresh = Painted{}.seenBy(to);
  for (glm::vec4& light : fresh.rgba) light = {7, 7, 7, 1};
  const Frame whole = filledFrom(fresh, view, 2);
  ASSERT_LT(keptOf(view), view.kept.size());
  for (size_t i = 0; i < view.kept.size(); ++i)
    EXPECT_EQ(whole.rgba[i], view.kept[i] ? view.light[i] : glm::vec4(7, 7, 7, 1));
}

// All of a new light that is twice as bright, found by a film without noise.
TEST(MovedView, IsBrightenedToTheFilm) {
  constexpr int kDivider = 12;
  const CameraRays from = raysAt(-90), to = raysAt(-88);
  MovedView view = movedView(Painted{}.seenBy(from), from, to, kThickness_mm, 1);
  const std::vector<glm::vec4> before = view.light;
  Film film(kColumns / kDivider, kRows / kDivider);
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const size_t middle = static_cast<size_t>(y * kDivider + kDivider / 2) * kColumns + x * kDivider + kDivider / 2;
      PathSample sample;
      sample.direct = 2.0f * Rgb(before[middle]);
      sample.alpha = 1;
      film.add(x, y, 0, sample);
    }
  brightenTo(view, film, kDivider, 1);
  double sum = 0, wanted = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    sum += view.light[i].g;
    wanted += 2 * before[i].g;
  }
  EXPECT_NEAR(sum / wanted, 1, 0.1);
}

// A film of one path a pixel, of cloth that is open: either it meets a fibre or it does not, and it brings light or
// none. Nothing is brighter than it was.
TEST(MovedView, IsNotBrightenedByNoiseOfOpenCloth) {
  constexpr int kDivider = 2;
  constexpr float kCloth = 0.3f;
  const CameraRays from = raysAt(-90);
  MovedView view = movedView(Painted{}.seenBy(from), from, from, kThickness_mm, 1);
  std::ranges::fill(view.light, glm::vec4(kCloth));
  Random random(3);
  Film film(kColumns / kDivider, kRows / kDivider);
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      PathSample sample;
      if (random.uniform() < kCloth) {
        sample.alpha = 1;
        sample.direct = Rgb(random.below(2) == 0 ? 0.0f : 2.0f);
      }
      film.add(x, y, 0, sample);
    }
  brightenTo(view, film, kDivider, 1);
  double square = 0;
  for (const glm::vec4& light : view.light)
    square += std::pow(light.g / kCloth - 1, 2) / static_cast<double>(view.light.size());
  EXPECT_LT(std::sqrt(square), 0.1);
}

// Seen through a cloth that is open, what lies behind it is not there from elsewhere. The pixels around show the cloth.
TEST(MovedView, ShowsTheClothWhereSinglePixelsSeeThroughIt) {
  const CameraRays from = raysAt(-90), to = raysAt(-88);
  const Frame whole = Painted{}.seenBy(from);
  Frame open = whole;
  Random random(4);
  for (size_t i = 0; i < open.hits.size(); ++i)
    if (random.below(10) == 0) {
      open.hits[i].depth_mm += 20 * kThickness_mm;
      open.rgba[i] = {0, 0, 0, 1};
    }
  const MovedView closed = movedView(whole, from, to, kThickness_mm, 1);
  const MovedView view = movedView(open, from, to, kThickness_mm, 1);
  // One place in ten thousand has four such pixels around it.
  EXPECT_GT(keptOf(view), 0.99 * static_cast<double>(keptOf(closed)));
  // Paint a pixel away is another by a third at most, in each of three channels; nothing of the black is seen.
  for (size_t i = 0; i < view.kept.size(); ++i)
    if (view.kept[i] && closed.kept[i]) {
      EXPECT_LT(glm::distance(view.light[i], closed.light[i]), 0.6f) << "pixel " << i;
    }
}

}  // namespace
}  // namespace loomlight
