#include "render/transport/path_length_tally.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>

#include "core/base/parallel.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "core/geometry/cloth_geometry.h"
#include "render/transport/path_integrator.h"

// How it works. Rays go straight down at random places of a patch that lies under a white sky. Of those that meet the
// material first, the path is followed until it leaves the cloth, and the lengths that it has gone inside the fibres of
// each material are written down. The colour of the cloth for any absorptions is then the mean of exp(-absorption .
// lengths) over the paths, without tracing them again.

namespace loomlight {
namespace {

constexpr int kFewestCrossings = 8, kMostCrossings = 128;
constexpr double kMarginThicknesses = 6;  // around the window: hardly any light comes from farther

/// The part of the cloth that is looked at: a repeat of weave and colours, centred.
glm::dvec2 window_mm(const Fabric& fabric) {
  const auto side = [](size_t weave, size_t colours, double pitch_mm) {
    const int repeat = static_cast<int>(std::min<size_t>(std::max(weave, colours), kMostCrossings));
    return pitch_mm * ((kFewestCrossings + repeat - 1) / repeat * repeat);
  };
  return {side(static_cast<size_t>(fabric.weave.ends()), fabric.warpSequence.size(), fabric.warpPitch_mm()),
          side(static_cast<size_t>(fabric.weave.picks()), fabric.weftSequence.size(), fabric.weftPitch_mm())};
}

/// What one path has gone through, if it met the material first and came back to the sky.
class LengthTally final : public PathSink {
 public:
  explicit LengthTally(int material) : material_(material) {}

  void clear() {
    met_ = false;
    lengths_mm_.clear();
  }
  bool met() const { return met_; }  ///< the material, first
  const std::vector<float>& lengths_mm() const { return lengths_mm_; }

  bool meets(const Collision& at, uint32_t event) override {
    if (event == 1) met_ = material_ == kAnyMaterial || at.material == material_;
    return met_;
  }
  void gathers(const PathLight&, std::span<const float> lengths_mm, uint32_t) override {
    lengths_mm_.assign(lengths_mm.begin(), lengths_mm.end());
  }

 private:
  int material_;
  bool met_ = false;
  std::vector<float> lengths_mm_;
};

}  // namespace

Rgb PathLengthTally::colour(const std::vector<Rgb>& absorption_per_mm) const {
  if (count == 0) return Rgb(0.0f);
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < lengths_mm.size(); i += materials) {
    Rgb exponent(0.0f);
    for (size_t k = 0; k < materials; ++k) exponent += absorption_per_mm[k] * lengths_mm[i + k];
    sum += glm::dvec3(glm::exp(-exponent));
  }
  return Rgb(sum / static_cast<double>(count));
}

Rgb PathLengthTally::colour(const Colouring& colouring) const {
  if (count == 0) return Rgb(0.0f);
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < lengths_mm.size(); i += materials)
    sum += glm::dvec3(colourOf({Rgb(1)}, std::span(lengths_mm).subspan(i, materials), colouring));
  return Rgb(sum / static_cast<double>(count));
}

Reflectance PathLengthTally::reflectance(const Colouring& colouring) const {
  std::array<double, kBands> sums{}, squares{};
  for (size_t i = 0; i < lengths_mm.size(); i += materials) {
    const Spectrum left = leftInBands(std::span(lengths_mm).subspan(i, materials), colouring);
    for (size_t j = 0; j < kBands; ++j) {
      sums[j] += left[j];
      squares[j] += double{left[j]} * left[j];
    }
  }
  Reflectance measured;
  const auto n = static_cast<double>(count);
  if (count == 0) return measured;
  for (size_t j = 0; j < kBands; ++j) {
    const double mean = sums[j] / n;
    measured.mean[j] = static_cast<float>(mean);
    if (count < 2) continue;
    measured.standardError[j] = static_cast<float>(std::sqrt(std::max(0.0, squares[j] / n - mean * mean) / (n - 1)));
  }
  return measured;
}

std::vector<Rgb> absorptionsOf(const Fabric& fabric) {
  std::vector<Rgb> absorptions;
  for (const Fibre& fibre : fabric.fibres) absorptions.push_back(absorptionOfPrimaries(fibre));
  return absorptions;
}

Fabric colourPatch(Fabric fabric) {
  const double margin = 2 * kMarginThicknesses * ClothGeometry(fabric, 1, 1).halfThickness_mm();
  const glm::dvec2 window = window_mm(fabric);
  fabric.drape = Drape{};
  fabric.drape.width_mm = std::clamp(window.x + 2 * margin, 1.0, 1e4);
  fabric.drape.height_mm = std::clamp(window.y + 2 * margin, 1.0, 1e4);
  fabric.light = Light{};
  fabric.light.kind = LightKind::dome;
  fabric.render.method = Method::volume;
  return fabric;
}

std::optional<PathLengthTally> tallyPathLengths(const Scene& scene, const Medium& medium, int material, size_t count,
                                                const Task& task) {
  constexpr size_t kBlock = PathIntegrator::kBatch;
  constexpr size_t kTriesPerWalk = 64;  // a fibre that so few eyes see is not on the face
  const glm::dvec2 window = window_mm(*scene.fabric);
  const double above = 2 * scene.cloth->volume->geometry().halfThickness_mm();
  std::vector<PathLengthTally> blocks((count + kBlock - 1) / kBlock);
  const uint32_t deepest = PathRules::of(scene).maxEvents + 1;  // no lamp is looked for from the last one
  std::atomic<size_t> done{0};
  parallelFor(blocks.size(), task.threads, [&](size_t b) {
    PathLengthTally& block = blocks[b];
    PathIntegrator integrator(scene, medium, PathRules::plain(deepest), kBlock);
    std::vector<LengthTally> tallies(kBlock, LengthTally(material));
    std::vector<PathStart> starts;
    TraceCounts counts;
    for (size_t tries = 0; tries < kBlock * kTriesPerWalk && block.count < kBlock && !task.stopped();) {
      starts.clear();
      for (size_t i = block.count; i < kBlock; ++i) {
        Random random(hashCombine(hashCombine(scene.fabric->render.seed, b), tries++));
        const double u = random.uniformDouble(), v = random.uniformDouble();
        const glm::dvec3 place((u - 0.5) * window.x, (v - 0.5) * window.y, above);
        tallies[starts.size()].clear();
        starts.push_back({{glm::vec3(place), {0, 0, -1}}, random, &tallies[starts.size()]});
      }
      if (!integrator.follow(starts, counts, &task)) return;
      for (size_t i = 0; i < starts.size(); ++i) {
        if (!tallies[i].met()) continue;
        ++block.count;
        const auto& lengths = tallies[i].lengths_mm();
        block.lengths_mm.insert(block.lengths_mm.end(), lengths.begin(), lengths.end());
      }
    }
    task.report(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (task.stopped()) return std::nullopt;
  PathLengthTally tally;
  tally.materials = scene.cloth->materials.size();
  for (const PathLengthTally& block : blocks) {
    tally.count += block.count;
    tally.lengths_mm.insert(tally.lengths_mm.end(), block.lengths_mm.begin(), block.lengths_mm.end());
  }
  return tally;
}

}  // namespace loomlight
