#include "render/transport/path_length_tally.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/fabric/model/changes.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/transport/path_integrator.h"

// How it works. Rays go straight down at random places of a patch that lies under a white sky. Of those that meet what
// is asked for first, the path is followed until it leaves the cloth, and the lengths that it has gone inside the
// fibres of each material are written down. The colour of the cloth for any absorptions is then the mean of
// exp(-absorption . lengths) over the paths, without tracing them again. Where several kinds of fibres are asked for,
// each has a tally of its own, and paths are begun until every one has enough or too many have been begun in vain.

namespace loomlight {
namespace {

constexpr size_t kFewest = 8, kMostOfWeave = 128;  // crossings a side; a jacquard's repeat takes long to build
constexpr size_t kMostOfColours = 4096, kMostOfBoth = size_t{1} << 16;  // a side, and of both together
constexpr double kMarginThicknesses = 6;  // around the window: hardly any light comes from farther

/// The part of the cloth that is looked at: a repeat of weave, colours and spacing, centred.
glm::dvec2 windowSides_mm(const Fabric& fabric) {
  const auto repeat = [](int weave, size_t sequence, const std::vector<double>& spacing) {
    const size_t colours = std::lcm(sequence, static_cast<size_t>(spacingRepeat(spacing)));
    return std::max(std::min(static_cast<size_t>(weave), kMostOfWeave), std::min(colours, kMostOfColours));
  };
  size_t ends = repeat(fabric.weave.ends(), fabric.warpSequence.size(), fabric.warpSpacing);
  size_t picks = repeat(fabric.weave.picks(), fabric.weftSequence.size(), fabric.weftSpacing);
  size_t& longer = ends > picks ? ends : picks;
  longer = std::min(longer, std::max(kMostOfWeave, kMostOfBoth / std::min(ends, picks)));
  const auto side = [](size_t threads, double pitch_mm) {
    const size_t whole = (kFewest + threads - 1) / threads * threads;
    return pitch_mm * static_cast<double>(whole);
  };
  return {side(ends, fabric.warpPitch_mm()), side(picks, fabric.weftPitch_mm())};
}

/// Which of several tallies a path that begins with this collision goes into; -1: none.
using KindOf = std::function<int(const Collision&)>;

/// What one path has gone through, if it met a kind first that is wanted, and came back to the sky.
class LengthTally final : public PathSink {
 public:
  /// `wanted`: kind by kind. Both outlive it.
  LengthTally(const KindOf& kindOf, const std::vector<char>& wanted) : kindOf_(kindOf), wanted_(wanted) {}

  void clear() {
    kind_ = -1;
    lengths_mm_.clear();
  }
  int kind() const { return kind_; }  ///< that was met first; -1: none that is wanted
  const std::vector<float>& lengths_mm() const { return lengths_mm_; }

  bool meets(const Collision& at, uint32_t event) override {
    if (event > 1) return true;
    const int kind = kindOf_(at);
    if (kind >= 0 && wanted_[static_cast<size_t>(kind)]) kind_ = kind;
    return kind_ >= 0;
  }
  void gathers(const PathLight&, std::span<const float> lengths_mm, uint32_t) override {
    lengths_mm_.assign(lengths_mm.begin(), lengths_mm.end());
  }

 private:
  const KindOf& kindOf_;
  const std::vector<char>& wanted_;
  int kind_ = -1;
  std::vector<float> lengths_mm_;
};

/// A block of paths, of each kind as many as `most`; false when stopped.
bool traceBlock(const Scene& scene, const Medium& medium, const KindOf& kindOf, uint64_t seed, size_t most,
                std::vector<PathLengthTally>& kinds, const Task& task) {
  constexpr size_t kTriesPerPath = 64;  // what so few eyes see is not on the face
  const glm::dvec2 window = windowSides_mm(*scene.fabric);
  const double above = 2 * scene.cloth->volume->geometry().halfThickness_mm();
  PathIntegrator integrator(scene, medium, PathSampling::plain(scene.sampling.maxEvents), most);
  std::vector<char> wanted(kinds.size());
  std::vector<LengthTally> tallies(most, LengthTally(kindOf, wanted));
  std::vector<PathStart> starts;
  TraceCounts counts;
  for (size_t tries = 0; tries < most * kTriesPerPath && !task.stopped();) {
    size_t missing = 0;
    for (size_t k = 0; k < kinds.size(); ++k) {
      missing += most - std::min(most, kinds[k].count);
      wanted[k] = kinds[k].count < most;
    }
    if (missing == 0) return true;
    starts.clear();
    for (size_t i = 0; i < std::min(most, missing); ++i) {
      Random random(hashCombine(seed, tries++));
      const double u = random.uniformDouble(), v = random.uniformDouble();
      const glm::dvec3 place((u - 0.5) * window.x, (v - 0.5) * window.y, above);
      tallies[i].clear();
      starts.push_back({{glm::vec3(place), {0, 0, -1}}, random, &tallies[i]});
    }
    if (!integrator.follow(starts, counts, &task)) return false;
    for (size_t i = 0; i < starts.size(); ++i) {
      if (tallies[i].kind() < 0) continue;
      PathLengthTally& kind = kinds[static_cast<size_t>(tallies[i].kind())];
      ++kind.count;
      const auto& lengths = tallies[i].lengths_mm();
      kind.lengths_mm.insert(kind.lengths_mm.end(), lengths.begin(), lengths.end());
    }
  }
  return !task.stopped();
}

/// Of each kind `count` paths. nullopt when stopped.
std::optional<std::vector<PathLengthTally>> tallyKinds(const Scene& scene, const Medium& medium, size_t kinds,
                                                       const KindOf& kindOf, size_t count, const Task& task,
                                                       uint64_t stream = 0) {
  constexpr size_t kBlock = PathIntegrator::kBatch;
  // Mixed, since seeds and streams that differ in a few low bits would give the same blocks in another order.
  const uint64_t seed = mixBits(scene.sampling.seed + mixBits(stream));
  std::vector<std::vector<PathLengthTally>> blocks((count + kBlock - 1) / kBlock, std::vector<PathLengthTally>(kinds));
  std::atomic<size_t> done{0};
  parallelFor(blocks.size(), task.threads, [&](size_t b) {
    if (traceBlock(scene, medium, kindOf, hashCombine(seed, b), kBlock, blocks[b], task))
      task.report(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (task.stopped()) return std::nullopt;
  std::vector<PathLengthTally> tallies(kinds);
  for (size_t k = 0; k < kinds; ++k) {
    tallies[k].materials = scene.cloth->materials.size();
    for (const std::vector<PathLengthTally>& block : blocks) {
      tallies[k].count += block[k].count;
      tallies[k].lengths_mm.insert(tallies[k].lengths_mm.end(), block[k].lengths_mm.begin(), block[k].lengths_mm.end());
    }
  }
  return tallies;
}

bool isOf(const Collision& met, const ClothPart& part) {
  switch (part.kind) {
    case ClothPart::Kind::piece:
      return true;
    case ClothPart::Kind::yarn:
      return met.yarn == part.index;
    case ClothPart::Kind::fibre:
      return met.material == part.index;
  }
  return false;
}

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

Fabric colourPatch(Fabric fabric) {
  fabric = evenlySpun(std::move(fabric));
  const double margin = 2 * kMarginThicknesses * ClothGeometry::outline(fabric).halfThickness_mm();
  const glm::dvec2 window = windowSides_mm(fabric);
  fabric.drape = Drape{};
  fabric.drape.width_mm = std::clamp(window.x + 2 * margin, 1.0, 1e4);
  fabric.drape.height_mm = std::clamp(window.y + 2 * margin, 1.0, 1e4);
  fabric.light = Light{};
  fabric.light.kind = LightKind::dome;
  fabric.render.method = Method::volume;
  // The report's tables dim light that comes straight from a lamp: a path would bring parts of it, and not lengths.
  if (fabric.render.needsVisibility()) fabric.render.estimator = Estimator::loomlight;
  return fabric;
}

bool tracedAlike(const Fabric& a, const Fabric& b) {
  return changes(a, b).stages.within(Stage::drape | Stage::colour | Stage::brightness | Stage::light |
                                     Stage::surroundings | Stage::camera | Stage::label);
}

std::optional<PathLengthTally> tallyPathLengths(const Scene& scene, const Medium& medium, const ClothPart& part,
                                                size_t count, const Task& task, uint64_t stream) {
  auto tallies =
      tallyKinds(scene, medium, 1, [&](const Collision& at) { return isOf(at, part) ? 0 : -1; }, count, task, stream);
  return tallies ? std::optional(std::move(tallies->front())) : std::nullopt;
}

std::optional<std::vector<PathLengthTally>> tallyYarns(const Scene& scene, const Medium& medium, size_t count,
                                                       const Task& task) {
  return tallyKinds(
      scene, medium, scene.fabric->yarns.size(), [](const Collision& at) { return at.yarn; }, count, task);
}

}  // namespace loomlight
