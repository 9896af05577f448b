#include "app/live/visibility_worker.h"

#include <algorithm>
#include <utility>

#include "core/fabric/model/changes.h"
#include "core/geometry/yarn/yarn_geometry.h"
#include "render/bvdf/bvdf_picture.h"

// How it works. A recipe is the text of all that tables depend on; edits that leave it as it is, such as a colour, are
// served by the tables that are there or by the bake under way. A bake of another recipe begins with borrowed tables
// (KnownBvdfs), and brings its own several times a second, each time drawn less towards the borrowed ones.
namespace loomlight {
namespace {

/// The same tables for another fabric of the same recipe, whose yarns may be numbered otherwise.
std::shared_ptr<const BvdfSet> numberedFor(const Fabric& fabric, const std::shared_ptr<const BvdfSet>& set) {
  auto numbered = std::make_shared<BvdfSet>(*set);
  numbered->tableOfYarn = geometryClasses(fabric);
  if (set->tables.size() == 1) std::fill(numbered->tableOfYarn.begin(), numbered->tableOfYarn.end(), 0);
  return numbered;
}

bool alike(const BvdfSet& a, const BvdfSet& b) {
  return a.tableOfYarn == b.tableOfYarn && a.tables == b.tables;
}

}  // namespace

bool worthTaking(const BakedVisibility& newer, const BakedVisibility& older) {
  if (newer.tables == older.tables) return false;
  // The yarns of one bake may be numbered anew, where one was doubled to be dyed.
  if (newer.bake != older.bake || newer.tables->tableOfYarn != older.tables->tableOfYarn) return true;
  if (newer.finished || older.finished) return newer.finished && !older.finished;
  return newer.rays > 0 && newer.rays >= 4 * older.rays;
}

VisibilityWorker::VisibilityWorker(std::function<void()> wake, BvdfOptions options, BvdfCache cache)
    : options_(options),
      cache_(std::move(cache)),
      known_(cache_),
      worker_(
          std::move(wake), [this](const Wish& wish, auto& job) { return fulfil(wish, job); },
          [this](const Wish&, const std::string& problem) {
            recipe_.clear();
            return Result{newest_, {false, false, 0, problem}};
          }) {}

void VisibilityWorker::request(std::shared_ptr<const Fabric> fabric, int yarn) {
  if (!fabric) worker_.cancel();
  worker_.ask({std::move(fabric), yarn});
}

std::shared_ptr<const BakedVisibility> VisibilityWorker::newest() const {
  const auto result = worker_.newest();
  return result ? result->baked : nullptr;
}

VisibilityWorker::Status VisibilityWorker::status() const {
  const auto result = worker_.newest();
  return result ? result->status : Status{};
}

VisibilityWorker::Result VisibilityWorker::fulfil(const Wish& wish, Baking::Job& job) {
  wish_ = wish;
  if (wish_.fabric) {
    if (!interrupted_ && isBakedFor(*wish_.fabric)) {
      keep(numberedFor(*wish_.fabric, newest_->tables), true);
    } else {
      bake(job);
    }
  }
  return {newest_, {}};
}

/// Whether recipe_ is this fabric's too. Where its fibres lie as they did nothing need be written out to know it.
bool VisibilityWorker::isBakedFor(const Fabric& fabric) const {
  return !recipe_.empty() && (!changes(*baked_, fabric).voxels() || bvdfRecipe(fabric, options_) == recipe_);
}

/// Whether the bake under way is right for what has been asked for since: another yarn or another colour is no reason
/// to begin anew. Else it is stopped.
bool VisibilityWorker::servesNewer(Baking::Job& job) {
  auto newer = job.takeNewer();
  if (!newer) return false;
  const bool serves = newer->fabric && isBakedFor(*newer->fabric);
  if (serves)
    wish_ = std::move(*newer);
  else
    job.giveWayTo(std::move(*newer));
  return serves;
}

/// For wish_.
void VisibilityWorker::bake(Baking::Job& job) {
  constexpr double kBetweenPictures_s = 0.25;
  ++bake_;
  interrupted_ = true;
  const std::shared_ptr<const Fabric> fabric = wish_.fabric;
  recipe_ = bvdfRecipe(*fabric, options_);
  baked_ = fabric;
  const std::shared_ptr<const BvdfSet> prior = cache_.has(recipe_) ? nullptr : known_.nearest(recipe_);
  Status status{true, prior != nullptr, 0, ""};
  if (prior) keep(numberedFor(*fabric, prior), false);
  job.bring({newest_, status});

  Task task;
  task.stop = job.stop();
  task.threads = 1;
  task.progress = [&](double fraction) {
    const bool another = static_cast<int>(100 * fraction) != static_cast<int>(100 * status.progress);
    status.progress = fraction;
    if (another) job.bring({newest_, status});
  };
  Stopwatch sincePicture;
  double waited_s = kBetweenPictures_s;  // the first at once
  auto set = bakeBvdf(*fabric, options_, cache_, task, [&](const BvdfBaker& baker) {
    if (servesNewer(job)) waited_s = kBetweenPictures_s;
    waited_s += sincePicture.lap();
    if (job.isStopped() || waited_s < kBetweenPictures_s) return;
    waited_s = 0;
    const auto own = baker.tables();
    keep(numberedFor(*wish_.fabric, prior ? drawnTowards(*own, *prior, status.progress) : own), false);
    job.bring({newest_, status});
  });
  interrupted_ = !set;
  if (!set) return;
  known_.keep(recipe_, set);
  keep(numberedFor(*wish_.fabric, set), true);
}

/// As the newest.
void VisibilityWorker::keep(const std::shared_ptr<const BvdfSet>& tables, bool finished) {
  auto baked = std::make_shared<BakedVisibility>();
  baked->bake = bake_;
  baked->rays = tables->rays;
  baked->finished = finished;
  baked->yarn = std::clamp(wish_.yarn, 0, static_cast<int>(wish_.fabric->yarns.size()) - 1);
  baked->picture = bvdfSquares(tables->of(baked->yarn), kPictureColumns);
  // Of edits in quick succession each borrows what the one before did: the picture need not begin anew.
  baked->tables = newest_ && alike(*newest_->tables, *tables) ? newest_->tables : tables;
  newest_ = std::move(baked);
}

}  // namespace loomlight
