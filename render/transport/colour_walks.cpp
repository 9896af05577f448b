#include "render/transport/colour_walks.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "core/geometry/cloth_geometry.h"
#include "render/optics/fibre_frame.h"

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

/// One walk from above. True when it met the material first; `lengths` then has what it went through, or nothing when
/// it did not come back to the sky.
bool walk(const Scene& scene, MediumPath& path, const glm::vec3& origin, int material, Random& random,
          std::vector<float>& lengths) {
  TraceCounts counts;
  path.begin({origin, -1});
  glm::vec3 direction(0, 0, -1);
  std::fill(lengths.begin(), lengths.end(), 0.0f);
  for (int events = 0;; ++events) {
    const auto collision = path.collide(direction, random, counts);
    if (!collision) {
      if (events == 0) return false;
      if (direction.z <= 0) lengths.clear();
      return true;
    }
    const int met = collision->material;
    if (events == 0 && met != material) return false;
    if (events == scene.fabric->render.maxDepth) {
      lengths.clear();
      return true;
    }
    const FibreFrame frame(collision->tangent);
    const FibreBcsdf::Sample scattered = scene.cloth->materials[static_cast<size_t>(met)].bcsdf->sampleWithoutPdf(
        frame.toLocal(-direction), collision->offset, random);
    lengths[static_cast<size_t>(met)] += scattered.length * collision->optics.fibreRadius_mm;
    direction = frame.toWorld(scattered.wi);
    path.leave(*collision, direction, scattered.order);
  }
}

}  // namespace

Rgb ColourWalks::colour(const std::vector<Rgb>& absorption_per_mm) const {
  if (count == 0) return Rgb(0.0f);
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < lengths_mm.size(); i += materials) {
    Rgb exponent(0.0f);
    for (size_t k = 0; k < materials; ++k) exponent += absorption_per_mm[k] * lengths_mm[i + k];
    sum += glm::dvec3(glm::exp(-exponent));
  }
  return Rgb(sum / static_cast<double>(count));
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

std::optional<ColourWalks> walkColours(const Scene& scene, const Medium& medium, int material, size_t count,
                                       const Task& task) {
  constexpr size_t kBlock = 256;
  constexpr size_t kTriesPerWalk = 64;  // a fibre that so few eyes see is not on the face
  const glm::dvec2 window = window_mm(*scene.fabric);
  const double above = 2 * scene.cloth->volume->geometry().halfThickness_mm();
  std::vector<ColourWalks> blocks((count + kBlock - 1) / kBlock);
  std::atomic<size_t> done{0};
  parallelFor(blocks.size(), task.threads, [&](size_t b) {
    ColourWalks& block = blocks[b];
    Random random(hashCombine(scene.fabric->render.seed, b));
    std::vector<float> lengths;
    const auto path = medium.path();
    for (size_t tries = 0; tries < kBlock * kTriesPerWalk && block.count < kBlock; ++tries) {
      if (task.stopped()) return;
      const glm::dvec3 place((random.uniformDouble() - 0.5) * window.x, (random.uniformDouble() - 0.5) * window.y,
                             above);
      lengths.resize(scene.cloth->materials.size());
      if (!walk(scene, *path, glm::vec3(place), material, random, lengths)) continue;
      ++block.count;
      block.lengths_mm.insert(block.lengths_mm.end(), lengths.begin(), lengths.end());
    }
    task.report(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (task.stopped()) return std::nullopt;
  ColourWalks walks;
  walks.materials = scene.cloth->materials.size();
  for (const ColourWalks& block : blocks) {
    walks.count += block.count;
    walks.lengths_mm.insert(walks.lengths_mm.end(), block.lengths_mm.begin(), block.lengths_mm.end());
  }
  return walks;
}

}  // namespace loomlight
