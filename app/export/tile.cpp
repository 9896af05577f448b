#include "app/export/tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/export/whole_picture.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/fabric/model/height_seen.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "render/display/denoise.h"
#include "render/transport/yarn_names.h"

// How it works. A tile is a whole number of repeats: of the weave, of both colour orders and, where that is not too
// long, of the twist of the yarns, each by the least common multiple. It is rendered as the middle of a larger piece,
// from straight above and without perspective, in a furnace, so that what is seen is how the yarns reflect and no lamp
// lies in the map. What samples leave of noise is taken from the colours (render/display/denoise.h): a map is no
// measurement, and where it comes again and again, its noise would be a pattern. Normals are slopes of the height map,
// taken across the tile's edges.
namespace loomlight {
namespace {

constexpr int kMostYarns = 2000;
constexpr double kMargin_mm = 3;        ///< of cloth around a tile: light goes no further within it
constexpr double kBytesPerPixel = 300;  ///< film, maps and what is written of them, at most

/// The least common multiple of the periods of a system's yarns in a repeat.
int64_t twistPeriod(const ClothGeometry& geometry, System system) {
  const bool warp = system == System::warp;
  int64_t period = 1;
  const int yarns = warp ? geometry.repeatEnds() : geometry.repeatPicks();
  for (int i = 0; i < yarns && period <= kMostYarns; ++i) {
    const YarnCellKey key = warp ? geometry.key(system, 0, i) : geometry.key(system, i, 0);
    period = std::lcm(period, static_cast<int64_t>(geometry.yarn(system, key.yarn).period));
  }
  return period;
}

/// An odd number of tiles side by side, so that one is in the middle with a margin around it.
int tilesAcross(double tile_mm) {
  return 1 + 2 * static_cast<int>(std::ceil(kMargin_mm / tile_mm));
}

/// Holes take the colour of the yarn that is nearest, across the tile's edges too: programs that filter between pixels
/// would draw dark seams along yarns else.
void fillHoles(const std::vector<float>& opacity, int width, int height, std::vector<Rgb>& colour) {
  std::vector<int> front;
  std::vector<bool> known(opacity.size());
  for (size_t i = 0; i < opacity.size(); ++i) {
    known[i] = opacity[i] > 0;
    if (known[i]) front.push_back(static_cast<int>(i));
  }
  for (size_t next = 0; next < front.size(); ++next) {
    const int x = front[next] % width, y = front[next] / width;
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      const int neighbour = (y + dy + height) % height * width + (x + dx + width) % width;
      if (known[static_cast<size_t>(neighbour)]) continue;
      known[static_cast<size_t>(neighbour)] = true;
      colour[static_cast<size_t>(neighbour)] = colour[static_cast<size_t>(front[next])];
      front.push_back(neighbour);
    }
  }
}

/// Premultiplied colours with less noise: pixels of one yarn exchange light within a crossing, so that the mean stays,
/// and what lies beyond the tile's edges has no say.
std::vector<glm::vec4> quietColours(const Film& film, int threads) {
  std::vector<glm::vec4> colours;
  film.toDisplayBuffer(colours, threads);
  std::vector<Film::Hit> hits;
  std::vector<float> variances;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      hits.push_back(film.hit(x, y));
      variances.push_back(film.variance(x, y));
    }
  // The filter tells yarns apart by their numbers: here each has one of its own, of 31 bits, at every crossing.
  for (Film::Hit& hit : hits)
    if (hit.yarn >= 0) hit.yarn = static_cast<int>(hashCombine(hashCombine(hit.end, hit.pick), hit.yarn) >> 33);
  denoise(colours, {hits, variances}, film.width(), film.height(), threads);
  return colours;
}

}  // namespace

TileExtent tileExtent(const Fabric& uneven, bool joinTwist) {
  const Fabric fabric = evenlySpun(uneven);
  const ClothGeometry geometry = ClothGeometry::outline(fabric);
  const auto lcm = [](int64_t a, int64_t b) { return std::lcm(a, b); };
  const int64_t ends =
      lcm(lcm(fabric.weave.ends(), static_cast<int64_t>(fabric.warpSequence.size())), geometry.repeatEnds());
  const int64_t picks =
      lcm(lcm(fabric.weave.picks(), static_cast<int64_t>(fabric.weftSequence.size())), geometry.repeatPicks());
  if (ends > Weave::kMaxSide || picks > Weave::kMaxSide)
    throw InputError(
        fmt::format("{}: expected weave, colours and spacing to repeat within {} threads, got {} ends and {} picks",
                    fabric.name, Weave::kMaxSide, ends, picks));
  if (!joinTwist) return {static_cast<int>(ends), static_cast<int>(picks), false};
  const int64_t twistEnds = lcm(ends, twistPeriod(geometry, System::weft));
  const int64_t twistPicks = lcm(picks, twistPeriod(geometry, System::warp));
  const bool joins =
      twistEnds <= std::max<int64_t>(ends, kMostYarns) && twistPicks <= std::max<int64_t>(picks, kMostYarns);
  return {static_cast<int>(joins ? twistEnds : ends), static_cast<int>(joins ? twistPicks : picks), joins};
}

double pixelsPerYarn(const Fabric& fabric, const TileExtent& extent, int longestSide) {
  const double width_mm = extent.ends * fabric.warpPitch_mm(), height_mm = extent.picks * fabric.weftPitch_mm();
  return longestSide / std::max(width_mm, height_mm) * std::min(fabric.warpPitch_mm(), fabric.weftPitch_mm());
}

int usualTileSide(const Fabric& fabric, const TileExtent& extent) {
  constexpr double kPerYarn = 16;
  constexpr int kStep = 64, kLeast = 1024, kMost = 16384;
  const double wanted = kPerYarn / pixelsPerYarn(fabric, extent, 1);
  return std::clamp(kStep * static_cast<int>(std::ceil(std::min<double>(wanted, kMost) / kStep)), kLeast, kMost);
}

void expectMemoryFor(const Fabric& fabric, const TileExtent& extent, int longestSide, double bytesPerPixel,
                     double limit_bytes) {
  const auto bytesOf = [&](int side) {
    const RenderSettings picture = tileScene(fabric, extent, side).render;
    return bytesPerPixel * picture.width * picture.height;
  };
  const double needed_bytes = bytesOf(longestSide);
  if (needed_bytes <= limit_bytes) return;
  int fitting = static_cast<int>(longestSide * std::sqrt(limit_bytes / needed_bytes));
  while (fitting > 1 && bytesOf(fitting) > limit_bytes) --fitting;  // sides are rounded to whole pixels
  constexpr double kGB = 1e9;
  throw InputError(fmt::format(
      "{}: expected a tile whose longer side has at most {} pixels, got {}: these take about {:.3g} GB of memory, and "
      "the limit is {:.3g} GB",
      fabric.name, fitting, longestSide, needed_bytes / kGB, limit_bytes / kGB));
}

ClothMeasures measuresOf(const Fabric& fabric, const TileExtent& extent, const Task& task) {
  return ClothGeometry(fabric, extent.ends, extent.picks, nullptr, false, task).measure();
}

Fabric tileScene(const Fabric& fabric, const TileExtent& extent, int longestSide, ClothSide side) {
  Fabric scene = evenlySpun(fabric);
  const double width_mm = extent.ends * fabric.warpPitch_mm(), height_mm = extent.picks * fabric.weftPitch_mm();
  const double pixels_per_mm = longestSide / std::max(width_mm, height_mm);
  scene.render.width = std::max(1, static_cast<int>(std::lround(width_mm * pixels_per_mm)));
  scene.render.height = std::max(1, static_cast<int>(std::lround(height_mm * pixels_per_mm)));
  // Pixels are square, so the tile is stretched by a fraction of one to be a whole number of them.
  const double stretched_mm = height_mm * scene.render.width / scene.render.height;
  scene.ends_per_cm = 10 * extent.ends / stretched_mm;
  scene.drape = Drape{};
  scene.drape.width_mm = stretched_mm * tilesAcross(stretched_mm);
  scene.drape.height_mm = height_mm * tilesAcross(height_mm);
  scene.light = Light{};
  scene.light.kind = LightKind::furnace;
  scene.camera = Camera{};
  scene.camera.elevation_deg = side == ClothSide::front ? 90 : -90;
  scene.camera.azimuth_deg = side == ClothSide::front ? -90 : 90;  // whose picture has y upwards
  scene.camera.fov_deg = 0;
  scene.camera.distance_mm = height_mm / heightSeenPerDistance(scene.camera);
  return scene;
}

TileMaps tileMaps(const Film& film, const Fabric& scene, int threads) {
  TileMaps maps;
  maps.width = film.width();
  maps.height = film.height();
  const std::vector<glm::vec4> colours = quietColours(film, threads);
  const auto distance = static_cast<float>(scene.camera.distance_mm);
  float lowest = 0;
  for (int y = 0; y < maps.height; ++y)
    for (int x = 0; x < maps.width; ++x) {
      const float alpha = film.alpha(x, y);
      // Pictures have no background: the mean is what the yarns send back, over the whole pixel.
      const glm::vec4& colour = colours[maps.baseColour.size()];
      maps.baseColour.push_back(alpha > 0 && colour.a > 0 ? Rgb(colour) / colour.a : Rgb(0));
      maps.opacity.push_back(alpha);
      maps.height_mm.push_back(alpha > 0 ? distance - film.meanDepth_mm(x, y) : 0.0f);
      maps.yarn.push_back(alpha > 0 ? film.hit(x, y).yarn : -1);
      if (alpha > 0) lowest = std::min(lowest, maps.height_mm.back());
    }
  for (size_t i = 0; i < maps.opacity.size(); ++i)
    if (maps.opacity[i] <= 0) maps.height_mm[i] = lowest;
  fillHoles(maps.opacity, maps.width, maps.height, maps.baseColour);

  const auto at = [&](int x, int y) {  // the tile goes on beyond its edges
    const int w = maps.width, h = maps.height;
    return maps.height_mm[static_cast<size_t>((y + h) % h) * static_cast<size_t>(w) + static_cast<size_t>((x + w) % w)];
  };
  const auto pixel_mm = static_cast<float>(heightSeen_mm(scene.camera) / maps.height);
  for (int y = 0; y < maps.height; ++y)
    for (int x = 0; x < maps.width; ++x) {
      // Sobel's differences: along one axis, smoothed across it.
      const auto across = [&](int dx) { return at(x + dx, y - 1) + 2 * at(x + dx, y) + at(x + dx, y + 1); };
      const auto down = [&](int dy) { return at(x - 1, y + dy) + 2 * at(x, y + dy) + at(x + 1, y + dy); };
      const float slopeX = (across(1) - across(-1)) / (8 * pixel_mm), slopeY = (down(-1) - down(1)) / (8 * pixel_mm);
      maps.normal.push_back(glm::normalize(glm::vec3(-slopeX, -slopeY, 1)));
    }
  return maps;
}

std::optional<TileReport> makeTile(const Fabric& fabric, const std::string& stem, const TileOrder& order,
                                   double limit_bytes, const Task& task) {
  expectWritable(stem + ".json");
  const TileExtent extent = tileExtent(fabric, order.joinTwist);
  const int side = order.longestSide > 0 ? order.longestSide : usualTileSide(fabric, extent);
  const auto tile = std::make_shared<const Fabric>(tileScene(fabric, extent, side));
  validate(*tile, fabric.name + ": the tile");
  expectMemoryFor(fabric, extent, side, kBytesPerPixel, limit_bytes);
  Task aside = task;
  aside.progress = nullptr;  // it takes a moment
  const ClothMeasures measures = measuresOf(fabric, extent, aside);
  const auto picture = renderWhole(tile, {limit_bytes, FibreExtent::oneRepeat}, task, extent.tiling());
  if (!picture) return std::nullopt;
  const auto names = yarnNames(fabric, aside);
  if (!names) return std::nullopt;
  return writeTile(stem, tileMaps(picture->film, *tile, task.threads), fabric, extent, measures, *names);
}

}  // namespace loomlight
