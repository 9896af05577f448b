#include "render/share/moved_view.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "render/display/resample.h"
#include "render/share/block_gains.h"
#include "render/share/shared_picture.h"

// How it works (after the render cache of Walter et al. 1999). Each pixel of the earlier picture is a point in space,
// as it knows how far away its fibre is. These points, seen by the new camera, make a map of distances, half as fine as
// the picture; gaps between them are closed. Each new pixel has a distance from that map, so it is a point in space
// too, and looks up what the earlier picture shows there, unless something else stood before it.

namespace loomlight {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr int kCell = 2;  // pixels of the picture for one of the map, each way

bool isWithin(const Frame& picture, const CameraRays::Projection& at) {
  return at.x >= 0 && at.y >= 0 && at.x < static_cast<float>(picture.width) &&
         at.y < static_cast<float>(picture.height);
}

/// How far the nearest cloth is from the camera, for cells of some pixels.
struct DistanceMap {
  DistanceMap(int w, int h) : width(w), height(h), all_mm(pixelCount(w, h), kNothing) {}

  /// Whether it has such a cell, with some cloth in it.
  bool has(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height && all_mm[pixelIndex(x, y, width)] < kNothing;
  }

  float& at(int x, int y) { return all_mm[pixelIndex(x, y, width)]; }
  float at(int x, int y) const { return all_mm[pixelIndex(x, y, width)]; }

  int width, height;
  std::vector<float> all_mm;
};

/// Points fall into cells in any order, and the nearest stays.
DistanceMap distancesOf(const Frame& earlier, const CameraRays& from, const CameraRays& to, int threads) {
  DistanceMap map(coarser(earlier.width, kCell), coarser(earlier.height, kCell));
  parallelFor(static_cast<size_t>(earlier.height), threads, [&](size_t row) {
    for (int x = 0; x < earlier.width; ++x) {
      const Film::Hit& hit = earlier.hits[pixelIndex(x, static_cast<int>(row), earlier.width)];
      if (hit.yarn < 0) continue;
      const Ray ray = from.ray(static_cast<float>(x) + 0.5f, static_cast<float>(row) + 0.5f);
      const auto seen = to.project(ray.origin + hit.depth_mm * ray.direction);
      if (!seen || !isWithin(earlier, *seen)) continue;
      std::atomic_ref<float> cell(map.at(static_cast<int>(seen->x) / kCell, static_cast<int>(seen->y) / kCell));
      float nearest = cell.load(std::memory_order_relaxed);
      while (seen->distance_mm < nearest &&
             !cell.compare_exchange_weak(nearest, seen->distance_mm, std::memory_order_relaxed)) {
      }
    }
  });
  return map;
}

/// The distance of a cell without cloth that has some on two opposite sides; infinite where it is no such gap.
float acrossGap(const DistanceMap& map, int x, int y) {
  float nearest = kNothing;
  for (const auto& [u, v] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, -1)})
    if (map.has(x + u, y + v) && map.has(x - u, y - v))
      nearest = std::min({nearest, map.at(x + u, y + v), map.at(x - u, y - v)});
  return nearest;
}

/// Fibres lie at random depths: means over cells side by side are steadier. Closes gaps of a cell.
DistanceMap smoothed(const DistanceMap& map, float thickness_mm, int threads) {
  DistanceMap smooth(map.width, map.height);
  parallelFor(static_cast<size_t>(map.height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < map.width; ++x) {
      const float reference = map.has(x, y) ? map.at(x, y) : acrossGap(map, x, y);
      float sum = 0;
      int count = 0;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u) {
          if (!map.has(u, v) || std::abs(map.at(u, v) - reference) > thickness_mm) continue;
          sum += map.at(u, v);
          ++count;
        }
      if (count > 0) smooth.at(x, y) = sum / static_cast<float>(count);
    }
  });
  return smooth;
}

/// How much distances differ from cell to cell where no edge lies between them, in millimetres.
float slant_mm(const DistanceMap& map, int x, int y) {
  const auto along = [&](int u, int v) {
    float least = kNothing;
    for (const int side : {-1, 1})
      if (map.has(x + side * u, y + side * v))
        least = std::min(least, std::abs(map.at(x + side * u, y + side * v) - map.at(x, y)));
    return least == kNothing ? 0 : least;
  };
  return along(1, 0) + along(0, 1);
}

/// The four pixels whose centres are around a place, `x` and `y` from the top left, the one at this place among them;
/// each as its index and by how much it counts for there.
struct Around {
  Around(int width, int height, float x, float y) {
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const float across = x - 0.5f - left, down = y - 0.5f - top;
    auto* pixel = pixels.data();
    for (const int v : {0, 1})
      for (const int u : {0, 1})
        *pixel++ = {pixelIndex(std::clamp(static_cast<int>(left) + u, 0, width - 1),
                               std::clamp(static_cast<int>(top) + v, 0, height - 1), width),
                    (u ? across : 1 - across) * (v ? down : 1 - down)};
  }

  std::array<std::pair<size_t, float>, 4> pixels;
};

/// Whether a pixel shows cloth that is about so far away.
bool isAt(float distance_mm, float reach_mm, const Film::Hit& hit) {
  return hit.yarn >= 0 && std::abs(hit.depth_mm - distance_mm) <= reach_mm;
}

/// The pixel of the earlier picture that shows what is about so far away at a place. That is `nearest`, where it shows
/// cloth there, or none at all. Where it shows cloth further away, which is seen through the openings of a nearer one,
/// it is the closest of those around that shows cloth there. There is none where something nearer stood in the way.
std::optional<size_t> pixelOf(const Frame& earlier, size_t nearest, const Around& around, float distance_mm,
                              float reach_mm) {
  const Film::Hit& hit = earlier.hits[nearest];
  if (hit.yarn < 0 || isAt(distance_mm, reach_mm, hit)) return nearest;
  if (hit.depth_mm < distance_mm) return std::nullopt;
  std::optional<size_t> closest;
  float most = 0;
  for (const auto& [i, weight] : around.pixels)
    if (weight > most && isAt(distance_mm, reach_mm, earlier.hits[i])) {
      closest = i;
      most = weight;
    }
  return closest;
}

/// The mean over those of the four that are `isSame`, of which there are some.
template <class IsSame>
glm::vec4 between(std::span<const glm::vec4> picture, const Around& around, const IsSame& isSame) {
  glm::vec4 sum(0);
  float weights = 0;
  for (const auto& [i, weight] : around.pixels) {
    if (!isSame(i)) continue;
    sum += weight * picture[i];
    weights += weight;
  }
  return sum / weights;
}

/// The square of how much the light of one path varies, as a share of that of the picture. What neighbours differ in is
/// noise and what a pixel's own texture adds, as light itself moves slowly over the picture. Film and picture are each
/// multiplied by how much cloth the other one shows (block_gains.h), so that the noise of the film is multiplied by the
/// picture's alpha, and its variance by the square of that; texture and light are weighted alike.
/// `film`: of one path a pixel.
float relativeNoise2(const SharedPicture& picture, const Film& film) {
  double apart = 0, texture = 0, light = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 1; x < picture.width; ++x) {
      const size_t right = pixelIndex(x, y, picture.width), left = right - 1;
      if (picture.alpha[left] == 0 || picture.alpha[right] == 0) continue;
      const auto difference = [&](int u, size_t i) {
        return picture.alpha[i] * film.mean(u, y) - film.alpha(u, y) * picture.light[i];
      };
      const Rgb both = difference(x, right) - difference(x - 1, left);
      apart += glm::dot(both, both);
      for (const size_t i : {left, right}) {
        const float alpha2 = picture.alpha[i] * picture.alpha[i];
        texture += alpha2 * picture.variances[i];
        light += alpha2 * glm::dot(picture.light[i], picture.light[i]);
      }
    }
  return light > 0 ? static_cast<float>(std::max(0.0, apart - texture) / light) : 0.0f;
}

}  // namespace

MovedView movedView(const Frame& earlier, const CameraRays& from, const CameraRays& to, float thickness_mm,
                    int threads) {
  assert(earlier.divider == 1 && earlier.hits.size() == earlier.plain().size());
  const int width = earlier.width, height = earlier.height;
  MovedView view{width, height, {}, {}, {}, earlier.samples};
  view.light.resize(earlier.rgba.size());
  view.hits.resize(earlier.rgba.size());
  view.kept.resize(earlier.rgba.size());
  const DistanceMap seen = distancesOf(earlier, from, to, threads);
  const DistanceMap map = smoothed(seen, thickness_mm, threads);
  parallelFor(static_cast<size_t>(height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const int u = x / kCell, v = y / kCell;
      if (!map.has(u, v)) continue;
      const Ray ray = to.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float distance_mm = map.at(u, v);
      const auto then = from.project(ray.origin + distance_mm * ray.direction);
      if (!then || !isWithin(earlier, *then)) continue;
      const float reach_mm = thickness_mm + slant_mm(map, u, v);
      const Around around(width, height, then->x, then->y);
      const size_t nearest = pixelIndex(static_cast<int>(then->x), static_cast<int>(then->y), width);
      const auto shown = pixelOf(earlier, nearest, around, then->distance_mm, reach_mm);
      if (!shown) continue;
      Film::Hit hit = earlier.hits[*shown];
      // Beyond an edge there may be cloth by now that was hidden then.
      if (hit.yarn < 0 && !seen.has(u, v)) continue;
      const auto isSame = [&](size_t i) {
        return hit.yarn < 0 ? earlier.hits[i].yarn < 0 : isAt(then->distance_mm, reach_mm, earlier.hits[i]);
      };
      const size_t i = pixelIndex(x, y, width);
      view.light[i] = between(earlier.plain(), around, isSame);
      if (hit.yarn >= 0) hit.depth_mm = distance_mm;
      view.hits[i] = hit;
      view.kept[i] = 1;
    }
  });
  return view;
}

void brightenTo(MovedView& view, const Film& coarse, int divider, int threads) {
  SharedPicture all(view.width, view.height);
  parallelFor(static_cast<size_t>(view.height), threads, [&](size_t row) {
    for (int x = 0; x < view.width; ++x) {
      const size_t i = pixelIndex(x, static_cast<int>(row), view.width);
      all.light[i] = Rgb(view.light[i]);
      all.alpha[i] = view.light[i].a;
    }
  });
  SharedPicture small = reduced(all, divider);
  const float noise2 = relativeNoise2(small, coarse);
  for (size_t i = 0; i < small.light.size(); ++i)
    small.variances[i] += noise2 * glm::dot(small.light[i], small.light[i]);
  const BlockGains gains(small, coarse, {}, threads);
  parallelFor(static_cast<size_t>(view.height), threads, [&](size_t row) {
    for (int x = 0; x < view.width; ++x) {
      glm::vec4& light = view.light[pixelIndex(x, static_cast<int>(row), view.width)];
      light = glm::vec4(Rgb(light) * gains.at((glm::vec2(x, row) + 0.5f) / static_cast<float>(divider)), light.a);
    }
  });
}

float missingIn(const MovedView& view, const Film& coarse, int divider) {
  size_t cloth = 0, missing = 0;
  for (int y = 0; y < coarse.height(); ++y)
    for (int x = 0; x < coarse.width(); ++x) {
      if (coarse.hit(x, y).yarn < 0) continue;
      ++cloth;
      const int u = std::min(x * divider + divider / 2, view.width - 1);
      const int v = std::min(y * divider + divider / 2, view.height - 1);
      missing += view.kept[pixelIndex(u, v, view.width)] == 0;
    }
  return cloth > 0 ? static_cast<float>(missing) / static_cast<float>(cloth) : 0.0f;
}

Frame filledFrom(const Frame& fresh, const MovedView& view, int threads) {
  Frame whole;
  whole.width = view.width;
  whole.height = view.height;
  whole.window = {0, 0, view.width, view.height};
  whole.rgba = view.light;
  whole.hits = view.hits;
  const float ratio = 1.0f / static_cast<float>(fresh.divider);
  parallelFor(static_cast<size_t>(view.height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    const Between down(y, ratio, 0, fresh.height);
    for (int x = 0; x < view.width; ++x) {
      const size_t i = pixelIndex(x, y, view.width);
      if (view.kept[i]) continue;
      whole.rgba[i] = resampled(fresh.plain(), fresh.width, Between(x, ratio, 0, fresh.width), down);
      if (!fresh.hits.empty())
        whole.hits[i] = fresh.hits[pixelIndex(std::min(x / fresh.divider, fresh.width - 1),
                                              std::min(y / fresh.divider, fresh.height - 1), fresh.width)];
    }
  });
  whole.helped = whole.rgba;
  return whole;
}

}  // namespace loomlight
