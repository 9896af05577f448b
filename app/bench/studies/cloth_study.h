#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/film/film.h"
#include "render/media/loomlight_medium.h"
#include "render/metrics/comparison.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// One way to trace a cloth, as the comparisons set it beside others.
struct Variant {
  std::string name;
  Method method = Method::volume;
  Estimator estimator = Estimator::loomlight;
  int resolution = 8;
  LoomlightMedium::Ingredients ingredients{};  ///< of Estimator::loomlight
  bool closeUps = false;                       ///< whether such a volume shows fibres to an eye near by, as pictures do
};

/// The fabric with the settings of a variant.
Fabric variantOf(Fabric fabric, const Variant& variant);
/// What light is traced through, for a scene of that variant. Null when stopped; throws InputError as makeMedium does.
std::unique_ptr<const Medium> mediumOf(const Scene& scene, const Variant& variant, const ReportBench& bench,
                                       const Task& task, MediumCost& cost);
/// The scene in another light and with another pattern of noise; it shares the cloth. Null when stopped.
std::shared_ptr<const Scene> relit(const Scene& scene, const Light& light, uint64_t seed, const Task& task);

/// A cloth made ready to be traced in one way, and what that took.
struct PreparedCloth {
  Variant variant;
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<const Medium> medium;
  double elements = 0;        ///< fibre segments, or voxels stored
  double bytes = 0;           ///< of geometry and accelerator, or of the volume and its BVDFs
  double construction_s = 0;  ///< processor time of all threads: strands, and accelerator or voxels
  double segmentsMade = 0;    ///< fibre segments that went into it
};

/// nullopt when stopped; throws InputError as makeScene and makeMedium do.
std::optional<PreparedCloth> prepare(const Fabric& fabric, const Variant& variant, const ReportBench& bench,
                                     const Task& task);

/// One picture rendered twice, with two patterns of noise, so that what is bias can be told from what is noise.
struct TwoPictures {
  std::array<Film, 2> films;
  double render_s = 0;  ///< processor time of both
  TraceCounts counts;
};

/// Pictures of every cloth in this light, of `samples` per pixel each. The cloths take turns, a few samples each, so
/// that whatever else the machine does, it does to all of them alike. nullopt when stopped.
std::optional<std::vector<TwoPictures>> renderInTurns(const std::vector<PreparedCloth>& cloths, const Light& light,
                                                      int samples, const Task& task);

/// The mean of both pictures, encoded for the display.
Pixels8 shown(const TwoPictures& pictures);

/// Squared relative difference of pixels, free of noise (noiseFreeBiasEstimate). `part`: of width and height, around
/// the middle, that is compared.
Estimate squaredDifference(const TwoPictures& pictures, const TwoPictures& reference, double part = 1);

/// How far one is from another that shows what is to be seen.
struct StudyErrors {
  glm::dvec3 mean_percent{0};  ///< difference of the mean colour
  double rms_percent = 0;      ///< of pixels, free of noise; below zero where noise has the last word
  double flip = 0;             ///< mean, with what noise there is
};
StudyErrors errorsOf(const TwoPictures& pictures, const TwoPictures& reference, int threads, double part = 1);

}  // namespace loomlight
