#include "app/bench/studies/convergence_study.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "render/display/denoise.h"
#include "render/display/despeckle.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

constexpr uint64_t kReferenceSeed = 0x5EED;

Scene withSeed(const Scene& scene, uint64_t seed) {
  Scene seeded = scene;
  Fabric fabric = *scene.fabric;
  fabric.render.seed = seed;
  seeded.fabric = std::make_shared<const Fabric>(std::move(fabric));
  return seeded;
}

std::vector<Rgb> pixelsOf(const Film& film) {
  std::vector<Rgb> pixels;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) pixels.push_back(film.mean(x, y));
  return pixels;
}

/// As the window shows a coarse picture: denoised, softened, and bilinear between the centres of the pixels.
std::vector<Rgb> resampled(const Film& film, int divider, int width, int height) {
  std::vector<glm::vec4> coarse;
  film.toDisplayBuffer(coarse);
  std::vector<Film::Hit> hits;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) hits.push_back(film.hit(x, y));
  denoise(coarse, {hits, {}}, film.width(), film.height(), 1);
  soften(coarse, film.width(), film.height());
  const auto split = [&](int fine, int count, int& first, int& second) {
    const float place = (static_cast<float>(fine) + 0.5f) / static_cast<float>(divider) - 0.5f;
    const float whole = std::floor(place);
    first = std::clamp(static_cast<int>(whole), 0, count - 1);
    second = std::clamp(static_cast<int>(whole) + 1, 0, count - 1);
    return place - whole;
  };
  const auto at = [&](int x, int y) { return Rgb(coarse[static_cast<size_t>(y) * film.width() + x]); };
  std::vector<Rgb> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int left = 0, right = 0, top = 0, bottom = 0;
      const float u = split(x, film.width(), left, right), v = split(y, film.height(), top, bottom);
      pixels.push_back(
          glm::mix(glm::mix(at(left, top), at(right, top), u), glm::mix(at(left, bottom), at(right, bottom), u), v));
    }
  return pixels;
}

}  // namespace

const std::vector<SamplingVariant>& samplingVariants() {
  static const std::vector<SamplingVariant> variants = {
      {"all on", [](Scene&) {}},
      {"not stratified", [](Scene& scene) { scene.sampling.stratified = false; }},
      {"no roulette", [](Scene& scene) { scene.sampling.roulette = false; }},
      {"milder roulette",
       [](Scene& scene) {
         for (Rgb& absorption : scene.roulette_per_mm) absorption *= 0.5f;
       }},
      {"lamps at every event", [](Scene& scene) { scene.sampling.lampsByChance = false; }},
      {"lamps not looked for", [](Scene& scene) { scene.sampling.lamps = false; }},
  };
  return variants;
}

ConvergenceStudy::ConvergenceStudy(const Scene& scene, const Medium& medium, uint32_t referenceSamples, int rounds,
                                   const Task& task)
    : scene_(scene), medium_(medium), rounds_(rounds), task_(task) {
  const RenderSettings& size = scene.fabric->render;
  Film film(size.width, size.height);
  const CameraRays camera(scene.fabric->camera, size.width, size.height);
  renderUpTo(referenceSamples, withSeed(scene, kReferenceSeed), medium, camera, film, task);
  reference_ = pixelsOf(film);
}

/// relMSE as Comparison defines it.
double ConvergenceStudy::error(const std::vector<Rgb>& picture) const {
  double mean = 0, sum = 0;
  const auto values = static_cast<double>(3 * reference_.size());
  for (const Rgb& r : reference_) mean += (r.r + r.g + r.b) / values;
  const double epsilon = 1e-2 * mean * mean;
  for (size_t i = 0; i < reference_.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double r = reference_[i][c], difference = picture[i][c] - r;
      sum += difference * difference / (r * r + epsilon) / values;
    }
  return sum;
}

Scene ConvergenceStudy::round(int number) const {
  return withSeed(scene_, static_cast<uint64_t>(number) + 1);
}

std::vector<ConvergenceStudy::Point> ConvergenceStudy::measure(const SamplingVariant& variant, uint32_t samples) const {
  const RenderSettings& size = scene_.fabric->render;
  const CameraRays camera(scene_.fabric->camera, size.width, size.height);
  std::vector<Point> points;
  for (uint32_t n = 1; n <= samples; n *= 4) points.push_back({n, 0, 0});
  for (int i = 0; i < rounds_; ++i) {
    Scene scene = round(i);
    variant.change(scene);
    Film film(size.width, size.height);
    double seconds = 0;
    for (Point& point : points) {
      CpuStopwatch watch;
      if (!renderUpTo(point.samples, scene, medium_, camera, film, task_).complete) return {};
      seconds += watch.lap();
      point.seconds += seconds / rounds_;
      point.error += error(pixelsOf(film)) / rounds_;
    }
  }
  return points;
}

std::optional<ConvergenceStudy::Point> ConvergenceStudy::coarse(int divider) const {
  const RenderSettings& size = scene_.fabric->render;
  Point point;
  for (int i = 0; i < rounds_; ++i) {
    const Scene scene = round(i);
    Film film((size.width + divider - 1) / divider, (size.height + divider - 1) / divider);
    const CameraRays camera(scene.fabric->camera, film.width(), film.height());
    CpuStopwatch watch;
    if (!renderUpTo(1, scene, medium_, camera, film, task_).complete) return std::nullopt;
    point.seconds += watch.lap() / rounds_;
    point.error += error(resampled(film, divider, size.width, size.height)) / rounds_;
  }
  return point;
}

}  // namespace loomlight
