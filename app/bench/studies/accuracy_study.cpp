#include "app/bench/studies/accuracy_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/studies/cloth_study.h"
#include "app/bench/studies/half_dome_study.h"
#include "app/bench/studies/report_page.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

using Ingredients = LoomlightMedium::Ingredients;

/// Every ingredient of ours that can be left out by itself: a line each.
struct Ablation {
  const char* name;
  bool Ingredients::* ingredient;
};
constexpr Ablation kAblations[] = {{"finite radius", &Ingredients::finiteRadius},
                                   {"packing", &Ingredients::packing},
                                   {"hot spot", &Ingredients::hotSpot}};

/// A way to trace the volume, and whether the targets speak of it.
struct Way {
  Variant variant;
  bool isTarget = false;
};

std::vector<Way> volumes(bool quick) {
  std::vector<Way> ways;
  for (const int resolution : quick ? std::vector{8} : std::vector{8, 16})
    for (const auto& [name, estimator] :
         {std::pair{"none", Estimator::none}, {"report", Estimator::report}, {"loomlight", Estimator::loomlight}})
      ways.push_back({{fmt::format("{}, resolution {}", name, resolution), Method::volume, estimator, resolution},
                      estimator == Estimator::loomlight});
  for (const Ablation& ablation : kAblations) {
    Variant without{fmt::format("{}, no {}", kOurs8, ablation.name), Method::volume, Estimator::loomlight, 8};
    without.ingredients.*ablation.ingredient = false;
    ways.push_back({without, false});
  }
  return ways;
}

/// How long a light is looked at: until the mean colour of its two pictures is known that well, or for that many paths.
struct Effort {
  double error;  ///< relative standard error
  double paths;
};

struct Plan {
  std::array<Effort, kAccuracyLights.size()> lights;
  int pixels;  ///< of the picture, on a side
  HalfDomeGrid halfDome;
  int halfDomeSamples;  ///< for each camera; 0: no half-dome

  /// For what is looked at beside the point: a third of the paths.
  Plan cursory() const {
    Plan less = *this;
    for (Effort& effort : less.lights) effort = {effort.error * std::sqrt(3), effort.paths / 3};
    less.halfDomeSamples /= 3;
    return less;
  }
};
const Plan kFull{{{{0.003, 8e5}, {0.012, 5e5}, {0.003, 4e5}, {0.012, 6e5}}}, 48, {8, 4}, 4096};
const Plan kQuick{{{{0.006, 3.5e4}, {0.03, 5e3}, {0.03, 5e3}, {0.03, 5e3}}}, 24, {8, 4}, 0};

Light lightOf(const AccuracyLight& choice) {
  Light light;
  light.kind = choice.kind;
  light.azimuth_deg = choice.azimuth_deg;
  light.elevation_deg = choice.elevation_deg;
  return light;
}

/// All that is measured of one way to trace a cloth.
struct Renderings {
  std::vector<TwoPictures> pictures;  ///< of each light
  std::optional<TwoMeasures> halfDome;
};

struct MeanColour {
  glm::dvec3 value{0}, standardError{0};

  /// Over the channels, relative.
  double relativeError() const {
    const glm::dvec3 e = standardError / glm::max(value, glm::dvec3(1e-9));
    return std::sqrt(glm::dot(e, e) / 3);
  }
};

/// Of both pictures; the error follows from how they differ, pixel by pixel.
MeanColour meanColour(const TwoPictures& pictures) {
  const Film &a = pictures.films[0], &b = pictures.films[1];
  glm::dvec3 sum(0), squares(0);
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const glm::dvec3 one(a.mean(x, y)), two(b.mean(x, y));
      sum += 0.5 * (one + two);
      squares += 0.25 * (one - two) * (one - two);
    }
  const double count = static_cast<double>(a.width()) * a.height();
  return {sum / count, glm::sqrt(squares) / count};
}

std::optional<TwoPictures> look(const Scene& scene, const Medium& medium, const AccuracyLight& light,
                                const Effort& effort, const Task& task) {
  constexpr uint32_t kFirst = 4;  // samples per pixel before the error is asked for
  const RenderSettings& settings = scene.fabric->render;
  const CameraRays camera(scene.fabric->camera, settings.width, settings.height);
  const double perSample = 2.0 * settings.width * settings.height;
  const auto most = static_cast<uint32_t>(std::max<double>(kFirst, effort.paths / perSample));
  TwoPictures pictures{{Film(settings.width, settings.height), Film(settings.width, settings.height)}, 0, {}};
  std::shared_ptr<const Scene> scenes[2];
  for (uint64_t k = 0; k < 2; ++k)
    if (!(scenes[k] = relit(scene, lightOf(light), settings.seed + k, task))) return std::nullopt;
  for (uint32_t samples = kFirst;;) {
    for (size_t k = 0; k < 2; ++k)
      if (!renderUpTo(samples, *scenes[k], medium, camera, pictures.films[k], task).complete) return std::nullopt;
    const double wanting = meanColour(pictures).relativeError() / effort.error;
    if (samples >= most || wanting <= 1) return pictures;
    // Towards what the error asks for, but not far at once: it is itself an estimate.
    samples = std::min(most, static_cast<uint32_t>(samples * std::clamp(wanting * wanting, 1.25, 4.0)));
  }
}

std::optional<Renderings> see(const Scene& scene, const Medium& medium, const Plan& plan, const Task& task) {
  Renderings seen;
  for (size_t i = 0; i < kAccuracyLights.size(); ++i) {
    auto pictures = look(scene, medium, kAccuracyLights[i], plan.lights[i], task);
    if (!pictures) return std::nullopt;
    seen.pictures.push_back(std::move(*pictures));
  }
  if (plan.halfDomeSamples == 0) return seen;
  seen.halfDome =
      measureTwice(scene, medium, lightOf(kAccuracyLights[kAccuracyDome]), plan.halfDome, plan.halfDomeSamples, task);
  if (!seen.halfDome) return std::nullopt;
  return seen;
}

/// The root of a squared difference, with its sign, in percent.
Estimate rootPercent(const Estimate& squared) {
  const double root = std::sqrt(std::abs(squared.value));
  return {100 * std::copysign(root, squared.value), root > 0 ? 50 * squared.standardError / root : 0};
}

Accuracy accuracyOf(const std::string& method, const Renderings& seen, const Renderings& truth) {
  Accuracy accuracy{method, {}, {}, {}};
  for (size_t i = 0; i < kAccuracyLights.size(); ++i) {
    const MeanColour found = meanColour(seen.pictures[i]), expected = meanColour(truth.pictures[i]);
    for (int c = 0; c < 3; ++c)
      accuracy.colour[i][static_cast<size_t>(c)] = {
          100 * (found.value[c] - expected.value[c]) / expected.value[c],
          100 * std::hypot(found.standardError[c], expected.standardError[c]) / expected.value[c]};
  }
  accuracy.pixels = rootPercent(squaredDifference(seen.pictures[kAccuracyDome], truth.pictures[kAccuracyDome]));
  if (seen.halfDome && truth.halfDome)
    accuracy.halfDome = rootPercent(squaredDifference(*seen.halfDome, *truth.halfDome));
  return accuracy;
}

/// Flat, seen from so far above that light at the eye comes straight down; pixels of d / 4.6.
Fabric posed(Fabric fabric, const Plan& plan) {
  constexpr double kFarAway = 100, kPixelsPerDiameter = 4.6, kMargin = 3.5;
  const ClothGeometry geometry(fabric, 1, 1);
  const double side_mm = plan.pixels * geometry.minYarnDiameter_mm() / kPixelsPerDiameter;
  if (plan.halfDomeSamples > 0) {
    fabric = halfDomePatch(fabric, plan.halfDome);
  } else {
    // What light travels sideways inside of the cloth.
    fabric.drape = Drape{};
    fabric.drape.width_mm = fabric.drape.height_mm = side_mm + 2 * kMargin * 2 * geometry.halfThickness_mm();
  }
  fabric.camera.target_mm = glm::dvec3(0);
  fabric.camera.elevation_deg = 90;
  fabric.camera.distance_mm = kFarAway * side_mm;
  fabric.camera.fov_deg = 2 * std::atan(0.5 / kFarAway) * 180 / kPi;
  fabric.render.width = fabric.render.height = plan.pixels;
  return fabric;
}

struct Fibres {
  Renderings seen;
  double segments = 0;
};

std::optional<Fibres> seeFibres(const Fabric& fabric, const ReportBench& bench, const Plan& plan, const Task& task) {
  const Variant variant{"fibres", Method::fibres, Estimator::loomlight, 1};
  const auto scene = makeScene(std::make_shared<const Fabric>(variantOf(fabric, variant)), task);
  if (!scene) return std::nullopt;
  MediumCost cost;
  const auto medium = mediumOf(*scene, variant, bench, task, cost);
  if (!medium) return std::nullopt;
  auto seen = see(*scene, *medium, plan, task);
  if (!seen) return std::nullopt;
  return Fibres{std::move(*seen), static_cast<double>(cost.segments)};
}

Pixels8 pictureOf(const std::vector<const Renderings*>& columns) {
  std::vector<Pixels8> rows;
  for (size_t i = 0; i < kAccuracyLights.size(); ++i) {
    std::vector<Pixels8> row;
    for (const Renderings* seen : columns) row.push_back(magnified(shown(seen->pictures[i]), 3));
    rows.push_back(sideBySide(row));
  }
  return stacked(rows);
}

}  // namespace

std::optional<AccuracyStudy> studyAccuracy(const BenchCloth& cloth, const ReportBench& bench, const Task& task) {
  const Plan& plan = bench.quick ? kQuick : kFull;
  const auto say = [&](const std::string& what) { fmt::print(stderr, "loomlight: {}: {}\n", cloth.name, what); };
  const Fabric fabric = posed(cloth.fabric, plan);
  AccuracyStudy study;
  say("fibres");
  const auto truth = seeFibres(fabric, bench, plan, task);
  if (!truth) return std::nullopt;
  study.segments = truth->segments;
  say(kOtherFibres);
  const Plan beside = bench.quick ? plan : plan.cursory();
  const auto other = seeFibres(rearranged(fabric), bench, beside, task);
  if (!other) return std::nullopt;
  study.methods.push_back(accuracyOf(kOtherFibres, other->seen, truth->seen));
  std::vector<const Renderings*> columns{&truth->seen, &other->seen};
  std::optional<Renderings> ours;
  std::shared_ptr<const Scene> scene;  // the last: those of one resolution share their volume
  for (const auto& [variant, isTarget] : volumes(bench.quick)) {
    say(variant.name);
    scene = makeScene(std::make_shared<const Fabric>(variantOf(fabric, variant)), task, scene.get());
    if (!scene) return std::nullopt;
    MediumCost cost;
    const auto medium = mediumOf(*scene, variant, bench, task, cost);
    if (!medium) return std::nullopt;
    auto seen = see(*scene, *medium, isTarget ? plan : beside, task);
    if (!seen) return std::nullopt;
    study.methods.push_back(accuracyOf(variant.name, *seen, truth->seen));
    if (variant.name == kOurs8) ours = std::move(*seen);
  }
  if (ours) columns.push_back(&*ours);
  study.picture = pictureOf(columns);
  return study;
}

}  // namespace loomlight
