#include "render/bvdf/known_bvdfs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/finish.h"
#include "core/fabric/model/yarn_count.h"

// How it works. A bake takes seconds, and the picture wants tables at once. So the tables of the fabric that was most
// like this one stand in: for each yarn the yarn of any kept or cached fabric, of the same kind of tables, whose
// surroundings differ least. As the rays of the bake come in, the tables go over from the borrowed ones to their own,
// as if the borrowed ones were a tenth of the bake's rays.
namespace loomlight {
namespace {

/// A recipe begins with what must be equal for its tables to serve at all, up to how many rays they are made of; and
/// ends with the fabric, reduced to what its visibility depends on.
std::string_view headOf(std::string_view recipe) {
  return recipe.substr(0, recipe.find("\npasses "));
}
std::optional<Fabric> fabricOf(const std::string& recipe) {
  const size_t start = recipe.find('{');
  if (start == std::string::npos) return std::nullopt;
  try {
    return fabricFromJson(std::string_view(recipe).substr(start), "recipe");
  } catch (const InputError&) {
    return std::nullopt;  // of a version that knew other fabrics
  }
}

/// Turns per mm, positive in Z.
double signedTwist(double twist_per_m, TwistDirection direction) {
  return (direction == TwistDirection::z ? 1e-3 : -1e-3) * twist_per_m;
}

/// How unlike the surroundings of the fibres of two yarns are: 0 of equal ones. A table holds ratios to the law of the
/// yarn's own fibres, so it varies slowly; lengths count by their ratio, and twists by the angle at the surface.
double unlikeness(const Fabric& fabricA, size_t a, const Fabric& fabricB, size_t b) {
  const Yarn &x = fabricA.yarns[a], &y = fabricB.yarns[b];
  const auto ratio = [](double p, double q) { return std::abs(std::log(p / q)); };
  const double xRadius = meanFibre(x, fabricA.fibres).radius_um, yRadius = meanFibre(y, fabricB.fibres).radius_um;
  const double fibres = x.fibresPerPly && y.fibresPerPly ? ratio(*x.fibresPerPly, *y.fibresPerPly)
                                                         : 0.5 * ratio(x.count_tex, y.count_tex);
  return fibres + ratio(xRadius, yRadius) + 2 * ratio(x.packing, y.packing) + ratio(x.flattening, y.flattening) +
         std::abs(signedTwist(x.plyTwist_per_m, x.plyTwistDirection) -
                  signedTwist(y.plyTwist_per_m, y.plyTwistDirection)) +
         std::abs(signedTwist(x.yarnTwist_per_m, x.yarnTwistDirection) -
                  signedTwist(y.yarnTwist_per_m, y.yarnTwistDirection)) +
         std::abs(signedTwist(x.cableTwist_per_m, x.cableTwistDirection) -
                  signedTwist(y.cableTwist_per_m, y.cableTwistDirection)) +
         0.5 * ratio(singlesIn(x), singlesIn(y)) + std::abs(x.migration - y.migration) +
         0.2 * std::abs(x.hairiness_per_mm - y.hairiness_per_mm) + (x.layout == y.layout ? 0 : 1) +
         ratio(fabricA.render.resolution, fabricB.render.resolution) +
         0.5 * ratio(fabricA.ends_per_cm, fabricB.ends_per_cm) +
         0.5 * ratio(fabricA.picks_per_cm, fabricB.picks_per_cm) + std::abs(fabricA.press - fabricB.press) +
         0.1 * std::abs(fabricA.crowding - fabricB.crowding) + 0.5 * ratio(fabricA.crimpBalance, fabricB.crimpBalance) +
         (fabricA.singed == fabricB.singed ? 0 : 0.2) + (fabricA.brushed == fabricB.brushed ? 0 : 1) +
         std::abs(feltingOf(x, fabricA) - feltingOf(y, fabricB));
}

}  // namespace

void KnownBvdfs::keep(const std::string& recipe, std::shared_ptr<const BvdfSet> set) {
  const auto isSame = [&](const Entry& entry) { return entry.recipe == recipe; };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), isSame), entries_.end());
  entries_.push_front({recipe, std::move(set)});
  if (entries_.size() > kMost) entries_.pop_back();
}

std::shared_ptr<const BvdfSet> KnownBvdfs::nearest(const std::string& recipe) const {
  constexpr size_t kFiles = 32;  // a few milliseconds
  const auto wanted = fabricOf(recipe);
  if (!wanted) return nullptr;
  struct Candidate {
    std::string recipe;
    std::shared_ptr<const BvdfSet> set;  ///< null: in the cache
    size_t yarn = 0;
    double unlikeness = std::numeric_limits<double>::max();
  };
  std::vector<Candidate> best(wanted->yarns.size());
  const auto consider = [&](const std::string& other, const std::shared_ptr<const BvdfSet>& set) {
    if (headOf(other) != headOf(recipe)) return;
    const auto fabric = fabricOf(other);
    for (size_t own = 0; fabric && own < best.size(); ++own)
      for (size_t yarn = 0; yarn < fabric->yarns.size(); ++yarn)
        if (const double found = unlikeness(*wanted, own, *fabric, yarn); found < best[own].unlikeness)
          best[own] = {other, set, yarn, found};
  };
  for (const Entry& entry : entries_) consider(entry.recipe, entry.set);
  for (const std::string& other : cache_.recipes(kFiles)) consider(other, nullptr);

  auto nearest = std::make_shared<BvdfSet>();
  for (const Candidate& candidate : best) {
    auto set = candidate.set;
    if (!set)
      if (auto found = cache_.find(candidate.recipe)) set = std::make_shared<const BvdfSet>(std::move(*found));
    if (!set) return nullptr;
    nearest->tables.push_back(set->tables[std::min(candidate.yarn, set->tables.size() - 1)]);  // or one for all
  }
  return nearest;
}

std::shared_ptr<const BvdfSet> drawnTowards(const BvdfSet& own, const BvdfSet& prior, double progress) {
  constexpr double kPriorShare = 0.1;  // of the rays of the whole bake
  const auto weight = static_cast<float>(kPriorShare * (1 - progress) / (kPriorShare + progress));
  auto drawn = std::make_shared<BvdfSet>();
  drawn->rays = own.rays;
  drawn->tableOfYarn = own.tableOfYarn;
  for (size_t i = 0; i < own.tables.size(); ++i) {
    const Bvdf &mine = own.tables[i], &others = prior.tables[std::min(i, prior.tables.size() - 1)];
    std::vector<float> ratios(mine.ratios().begin(), mine.ratios().end());
    for (size_t bin = 0; weight > 0 && bin < ratios.size(); ++bin)
      ratios[bin] += weight * (others.ratios()[bin] - ratios[bin]);
    drawn->tables.emplace_back(mine.resolution(), mine.hotSpot(), std::move(ratios));
  }
  return drawn;
}

}  // namespace loomlight
