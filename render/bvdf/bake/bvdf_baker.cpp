#include "render/bvdf/bake/bvdf_baker.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/finish.h"
#include "render/bvdf/bake/bvdf_patch.h"
#include "render/bvdf/bvdf_counts.h"
#include "render/bvdf/local_cell.h"
#include "render/media/fibre_exit.h"

// How it works. Eye rays, stratified over the hemisphere, go to random places of a small patch of explicit fibres, from
// its face and its back in turn. From the fibre that each meets, shadow rays go in directions that are stratified over
// the sphere, as far as the ends of the local cell: each adds to the bin of its two directions whether it met a fibre,
// and what the model of the hot spot expects there. The tables are the ratios of both. A block of rays is a function of
// its number alone, and blocks are added in order, so that a table has the same bytes for any number of threads.

namespace loomlight {
namespace {

constexpr int kBakerVersion = 3;  // of the fibres' geometry, the rays and the tables: raise it when any of them changes
constexpr int kBlocks = 32;       // a pass
constexpr int kEyeThetas = 8, kEyePhis = 16;       // strata of a block
constexpr int kLightThetas = 16, kLightPhis = 32;  // strata over the sphere; each eye ray takes a part of them
constexpr size_t kMaxBins = size_t{1} << 25;       // of all tables: 256 MB of counts

/// The first fibre that an eye ray meets from a random place before (or behind) the patch, where it has neighbours.
std::optional<Collision> firstHit(const BvdfPatch& patch, MediumPath& path, glm::vec3 wo, Random& random) {
  constexpr int kTries = 16;  // sheer cloth is mostly holes
  const Scene& scene = patch.scene();
  const glm::vec3 lower = scene.cloth->shell->lower_mm(), size = scene.cloth->shell->upper_mm() - lower;
  TraceCounts counts;
  for (int i = 0; i < kTries; ++i) {
    const float u = random.uniform(), v = random.uniform();
    const glm::vec3 start = lower + size * glm::vec3(u, v, wo.z > 0 ? 1.0f : 0.0f);
    // A little outside of the slab, so that no ray starts on a fibre.
    path.begin({start + 0.01f * size.z * wo, -1});
    const auto hit = path.collide(-wo, random, counts);
    if (hit && patch.isInside(hit->end, hit->pick)) return hit;
  }
  return std::nullopt;
}

HotSpot hotSpotOf(const Scene& scene, int yarn) {
  const glm::vec3 leaf = scene.cloth->volume->grid().size_mm;
  const float halfCell = std::cbrt(leaf.x * leaf.y * leaf.z);
  // A system that does not use the yarn has no radius for it.
  const float radius = std::max(scene.cloth->yarns[0][yarn].fibreRadius_mm, scene.cloth->yarns[1][yarn].fibreRadius_mm);
  const double packing = withFinish(scene.fabric->yarns[yarn], *scene.fabric).packing;
  return HotSpot::of(radius > 0 ? radius : halfCell, static_cast<float>(packing), halfCell);
}

}  // namespace

/// What became of one shadow ray.
struct BvdfBaker::Shadow {
  uint32_t bin;
  float expected;
  uint8_t table;
  bool met;
};

BvdfBaker::BvdfBaker(std::unique_ptr<const BvdfPatch> patch, BvdfResolution resolution, std::vector<int> classes)
    : patch_(std::move(patch)), resolution_(resolution), tableOfYarn_(std::move(classes)) {
  const size_t yarns = patch_->scene().fabric->yarns.size();
  const bool shared = yarns * resolution.bins() > kMaxBins;
  for (size_t i = 0; i < yarns; ++i) tableOfClass_.push_back(shared ? 0 : static_cast<int>(i));
  if (shared) std::fill(tableOfYarn_.begin(), tableOfYarn_.end(), 0);
  for (size_t i = 0; i < (shared ? 1 : yarns); ++i) {
    hotSpots_.push_back(hotSpotOf(patch_->scene(), static_cast<int>(i)));
    counts_.emplace_back(resolution);
  }
}

BvdfBaker::~BvdfBaker() = default;

std::unique_ptr<BvdfBaker> BvdfBaker::begin(const Fabric& fabric, BvdfResolution resolution, const Task& task) {
  auto patch = BvdfPatch::build(fabric, task);
  if (!patch) return nullptr;
  return std::unique_ptr<BvdfBaker>(new BvdfBaker(std::move(patch), resolution, geometryClasses(fabric)));
}

std::vector<BvdfBaker::Shadow> BvdfBaker::traceBlock(uint64_t block) const {
  const Scene& scene = patch_->scene();
  MediumPath path = patch_->fibres().path();
  const float side = block % 2 == 0 ? 1.0f : -1.0f;  // face and back in turn
  Random random(hashCombine(hashCombine(0, block), kBakerVersion));
  TraceCounts counts;
  std::vector<Shadow> shadows;
  shadows.reserve(size_t{kEyeThetas} * kEyePhis * kShadowRays);
  for (int eye = 0; eye < kEyeThetas * kEyePhis; ++eye) {
    const int row = eye / kEyePhis, column = eye % kEyePhis;
    const float u = random.uniform(), v = random.uniform();
    const float theta = (static_cast<float>(row) + u) / kEyeThetas * (0.5f * kPiF);
    const float phi = (static_cast<float>(column) + v) / kEyePhis * (2 * kPiF);
    glm::vec3 wo = polarDirection(theta, phi);
    wo.z = side * std::max(wo.z, 1e-3f);
    wo = glm::normalize(wo);
    const auto hit = firstHit(*patch_, path, wo, random);
    if (!hit) continue;

    const int table = tableOfClass_[hit->yarn];
    const glm::mat3 frame = eventFrame({0, 0, 1}, hit->tangent);
    const glm::vec3 woLocal = wo * frame;
    const glm::vec3 surface = hit->place.world - hit->axis;
    const LocalCell cell = LocalCell::around(scene.cloth->shell->toCloth(0, hit->place.world), *scene.cloth->volume);
    const glm::vec3 toCloth = scene.cloth->shell->toCloth(0, glm::vec3(0));
    const float through_radii = traverse_radii(*scene.cloth, *hit);
    const auto turn = random.below(kLightPhis);
    for (int i = 0; i < kShadowRays; ++i) {
      // Every stratum of theta as often as any other, and every one of phi: 7 is prime to their number.
      const auto ring = static_cast<uint32_t>(i % kLightThetas);
      const uint32_t column = (turn + 7 * static_cast<uint32_t>(i)) % kLightPhis;
      const float a = random.uniform(), b = random.uniform();
      const glm::vec3 wiLocal = polarDirection((static_cast<float>(ring) + a) / kLightThetas * kPiF,
                                               (static_cast<float>(column) + b) / kLightPhis * (2 * kPiF));
      const glm::vec3 wi = frame * wiLocal;
      // Reflected light leaves where it came in, light through the fibre beyond it.
      path.leave(*hit, wi, glm::dot(wi, surface) > 0 ? 0 : through_radii);
      const float exit = cell.exit(toCloth + path.place().world, wi);
      const bool met = exit > 0 && path.transmittance(wi, exit, random, counts) == 0;
      const BvdfBin bin = BvdfBin::at(bvdfAngles(wiLocal, woLocal), resolution_);
      shadows.push_back({static_cast<uint32_t>(bin.index(resolution_)), hotSpots_[table].occlusion(wiLocal, woLocal),
                         static_cast<uint8_t>(table), met});
    }
  }
  return shadows;
}

bool BvdfBaker::advance(int passes, const Task& task) {
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<std::vector<Shadow>> blocks(kBlocks);
    std::atomic<int> done{0};
    parallelFor(blocks.size(), task.threads, [&](size_t i) {
      if (task.stopped()) return;
      blocks[i] = traceBlock(static_cast<uint64_t>(passes_) * kBlocks + i);
      task.report((pass + static_cast<double>(++done) / kBlocks) / passes);
    });
    if (task.stopped()) return false;
    for (const auto& block : blocks)
      for (const Shadow& shadow : block) counts_[shadow.table].add(shadow.bin, shadow.met, shadow.expected);
    ++passes_;
  }
  return true;
}

uint64_t BvdfBaker::rays() const {
  uint64_t sum = 0;
  for (const BvdfCounts& counts : counts_) sum += counts.rays();
  return sum;
}

std::shared_ptr<const BvdfSet> BvdfBaker::tables() const {
  auto set = std::make_shared<BvdfSet>();
  for (size_t i = 0; i < counts_.size(); ++i) set->tables.push_back(counts_[i].table(hotSpots_[i]));
  set->rays = rays();
  set->tableOfYarn = tableOfYarn_;
  return set;
}

namespace {

int passesFor(uint64_t rays, size_t yarns) {
  constexpr uint64_t kRaysPerPass = uint64_t{kBlocks} * kEyeThetas * kEyePhis * BvdfBaker::kShadowRays;
  constexpr uint64_t kMaxPasses = 1'000'000;
  return static_cast<int>(std::clamp<uint64_t>((rays * yarns + kRaysPerPass - 1) / kRaysPerPass, 1, kMaxPasses));
}

std::string recipeOf(const Fabric& reduced, const BvdfOptions& options) {
  const BvdfResolution& r = options.resolution;
  return fmt::format("version {}\nbins {} {} {} {}\npasses {}\n{}", kBakerVersion, r.thetaO, r.phiO, r.thetaI, r.phiI,
                     passesFor(options.rays, reduced.yarns.size()), fabricToJson(reduced));
}

}  // namespace

std::string bvdfRecipe(const Fabric& fabric, const BvdfOptions& options) {
  return recipeOf(BvdfPatch::reduced(fabric), options);
}

std::shared_ptr<const BvdfSet> bakeBvdf(const Fabric& fabric, const BvdfOptions& options, const BvdfCache& cache,
                                        const Task& task, const std::function<void(const BvdfBaker&)>& afterPass) {
  const std::string recipe = bvdfRecipe(fabric, options);
  const std::vector<int> classes = geometryClasses(fabric);
  if (auto found = cache.find(recipe)) {
    found->tableOfYarn = classes;
    if (found->tables.size() == 1) std::fill(found->tableOfYarn.begin(), found->tableOfYarn.end(), 0);
    return std::make_shared<const BvdfSet>(std::move(*found));
  }
  const auto baker = BvdfBaker::begin(fabric, options.resolution, task);
  if (!baker) return nullptr;
  const size_t yarns = static_cast<size_t>(*std::max_element(classes.begin(), classes.end())) + 1;
  const int passes = passesFor(options.rays, yarns);
  while (baker->passes() < passes) {
    const int done = baker->passes();
    const Task pass{task.stop, [&](double fraction) { task.report((done + fraction) / passes); }, task.threads};
    if (!baker->advance(1, pass)) return nullptr;
    if (afterPass && baker->passes() < passes) afterPass(*baker);
  }
  auto set = baker->tables();
  cache.keep(recipe, *set);
  return set;
}

std::shared_ptr<const BvdfSet> expectedBvdf(const Scene& scene, BvdfResolution resolution) {
  auto set = std::make_shared<BvdfSet>();
  for (size_t yarn = 0; yarn < scene.fabric->yarns.size(); ++yarn) {
    set->tables.emplace_back(resolution, hotSpotOf(scene, static_cast<int>(yarn)),
                             std::vector<float>(resolution.bins(), 1.0f));
    set->tableOfYarn.push_back(static_cast<int>(yarn));
  }
  return set;
}

}  // namespace loomlight
