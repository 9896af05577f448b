#include "render/transport/half_dome.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/fabric/model/height_seen.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/transport/path_tracer.h"

// How it works. Each direction of the half-dome has an orthographic camera that sees the same square of cloth, of
// whole repeats where they are few. Pixels are of one size in all of these pictures, so the more a camera slants,
// the fewer rows of them it has. Paths are those of a picture, spread evenly over the pixels, and the mean over all
// is the radiance in that direction. The patch of cloth is so wide that neither the steepest camera nor light that
// travels sideways in it comes to an edge.

namespace loomlight {
namespace {

constexpr double kRadians = kPi / 180;
constexpr int kPixels = 64;  // across a window seen from straight above
constexpr int kFewestCrossings = 8, kMostCrossings = 48;

/// Side of the square of cloth that the cameras see: enough crossings for a mean, and whole repeats where they are few.
double window_mm(const ClothGeometry& geometry) {
  const auto side = [](int repeat, double pitch_mm) {
    return pitch_mm * std::clamp((kFewestCrossings + repeat - 1) / repeat * repeat, kFewestCrossings, kMostCrossings);
  };
  return std::max(side(geometry.repeatEnds(), geometry.warpPitch_mm()),
                  side(geometry.repeatPicks(), geometry.weftPitch_mm()));
}

/// A camera's picture: the middle `columns` x `rows` pixels of what CameraRays would show.
struct View {
  Camera camera;
  int width = 1, height = 1;
  int columns = 1, rows = 1;

  CameraRays rays() const { return CameraRays(camera, width, height); }
};

View viewFrom(const HalfDomeGrid& grid, size_t camera, double window, double halfThickness_mm) {
  const auto azimuths = static_cast<size_t>(grid.azimuths);
  const double azimuth_deg = grid.azimuth_deg(static_cast<int>(camera % azimuths));
  const double inclination_deg = grid.inclination_deg(static_cast<int>(camera / azimuths));
  const double cosine = std::cos(inclination_deg * kRadians), sine = std::sin(inclination_deg * kRadians);
  const double pixel = window / kPixels;
  View view;
  view.camera.fov_deg = 0;
  view.columns = kPixels;
  view.rows = std::max(1, static_cast<int>(std::lround(kPixels * cosine)));
  // So far off that all of the picture's plane lies above the cloth. What an orthographic camera shows grows with its
  // distance, so the picture grows too, and only its middle is looked at.
  // A pixel is seen by what lies half a pixel beyond it, too (TriangleFilter).
  const double clear = (1.01 * halfThickness_mm + 0.5 * (view.rows + 1) * pixel * sine) / cosine + pixel;
  const double seenPerDistance = heightSeenPerDistance(view.camera);
  view.height = std::max(view.rows, static_cast<int>(std::ceil(clear * seenPerDistance / pixel)));
  view.height += (view.height - view.rows) & 1;
  view.width = view.columns;
  view.camera.azimuth_deg = azimuth_deg;
  view.camera.elevation_deg = (grid.underneath ? -1 : 1) * (90 - inclination_deg);
  view.camera.distance_mm = view.height * pixel / seenPerDistance;
  return view;
}

/// Mean of at least `samples` paths. Samples are spread evenly over the pixels; no two cameras share a number of the
/// same pixel.
Rgb look(const Scene& scene, const Medium& medium, const View& view, size_t camera, int samples, const Task& task,
         TraceCounts& counts) {
  const CameraRays rays = view.rays();
  const int pixels = view.columns * view.rows;
  const int rounds = (samples + pixels - 1) / pixels;
  // Fewer samples than pixels go to every nth pixel. An odd number, as the columns are a power of two: so each of them
  // gets its part, and none of the phases of a yarn is left out.
  const int stride = std::max(1, pixels / samples - (pixels / samples + 1) % 2);
  const int x0 = (view.width - view.columns) / 2, y0 = (view.height - view.rows) / 2;
  std::vector<PixelSample> wanted;
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < pixels; i += stride) {
      const auto index = static_cast<uint32_t>(camera * static_cast<size_t>(rounds) + static_cast<size_t>(round));
      wanted.push_back({x0 + i % view.columns, y0 + i / view.columns, index});
    }
  PathTracer tracer(scene, medium, rays, PathIntegrator::kBatch);
  glm::dvec3 sum(0.0);
  for (size_t begin = 0; begin < wanted.size(); begin += PathIntegrator::kBatch) {
    const auto batch = std::span(wanted).subspan(begin, std::min(PathIntegrator::kBatch, wanted.size() - begin));
    if (!tracer.trace(batch, counts, &task)) return Rgb(0.0f);
    for (size_t i = 0; i < batch.size(); ++i) sum += glm::dvec3(tracer.sample(i).direct + tracer.sample(i).indirect);
  }
  return Rgb(sum / static_cast<double>(wanted.size()));
}

}  // namespace

Fabric halfDomePatch(Fabric fabric, const HalfDomeGrid& grid) {
  fabric = evenlySpun(std::move(fabric));
  const ClothGeometry geometry = ClothGeometry::outline(fabric);
  const double half = geometry.halfThickness_mm();
  const double steepest = std::tan(grid.inclination_deg(grid.inclinations - 1) * kRadians);
  // Half the diagonal of the window, whose rows are rounded; the way of a ray down to the mid-plane; and what light
  // travels sideways inside of the cloth.
  const double window = window_mm(geometry);
  const double reach = 0.75 * window * 1.5 + half * steepest + 8 * half;
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = std::clamp(2 * reach, 1.0, 1e4);
  return fabric;
}

std::optional<HalfDomeMeasure> measureHalfDome(const Scene& scene, const Medium& medium, const HalfDomeGrid& grid,
                                               int samples, const Task& task) {
  const ClothGeometry& geometry = scene.cloth->volume->geometry();
  const double window = window_mm(geometry), half = geometry.halfThickness_mm();
  HalfDomeMeasure measure{grid, std::vector<Rgb>(grid.size()), {}};
  std::vector<TraceCounts> counts(grid.size());
  std::atomic<size_t> done{0};
  parallelFor(grid.size(), task.threads, [&](size_t i) {
    const View view = viewFrom(grid, i, window, half);
    measure.radiance[i] = look(scene, medium, view, i, samples, task, counts[i]);
    task.report(static_cast<double>(++done) / static_cast<double>(grid.size()));
  });
  if (task.stopped()) return std::nullopt;
  for (const TraceCounts& c : counts) measure.counts += c;
  return measure;
}

double paperRadiance(const Light& light) {
  const bool directional = light.kind == LightKind::directional;
  return light.intensity * (directional ? std::abs(std::sin(light.elevation_deg * kRadians)) : 1.0);
}

}  // namespace loomlight
