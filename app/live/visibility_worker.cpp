#include "app/live/visibility_worker.h"

#include <algorithm>
#include <exception>

#include "app/live/background_thread.h"
#include "core/geometry/yarn_geometry.h"
#include "render/bvdf/bvdf_picture.h"

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
    : wake_(std::move(wake)), options_(options), cache_(std::move(cache)), known_(cache_) {
  thread_ = std::jthread([this](std::stop_token stop) {
    lowerPriorityOfThisThread();
    loop(stop);
  });
}

VisibilityWorker::~VisibilityWorker() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  stop_.request_stop();
}

void VisibilityWorker::request(std::shared_ptr<const Fabric> fabric, int yarn) {
  Wish wish{std::move(fabric), yarn, {}};
  {
    std::lock_guard lock(mutex_);
    if (!wish.fabric) {
      stop_.request_stop();
      stop_ = std::stop_source();
    }
    wish.stop = stop_.get_token();
  }
  wishes_.post(std::move(wish));
}

std::shared_ptr<const BakedVisibility> VisibilityWorker::newest() const {
  std::lock_guard lock(mutex_);
  return newest_;
}

VisibilityWorker::Status VisibilityWorker::status() const {
  std::lock_guard lock(mutex_);
  return status_;
}

void VisibilityWorker::setStatus(Status status) {
  {
    std::lock_guard lock(mutex_);
    status_ = std::move(status);
  }
  wake_();
}

void VisibilityWorker::loop(std::stop_token stop) {
  ending_ = stop;
  while (auto wish = next_ ? std::exchange(next_, std::nullopt) : wishes_.wait(stop)) {
    try {
      fulfil(std::move(*wish));
    } catch (const std::exception& e) {
      recipe_.clear();
      setStatus({false, false, 0, e.what()});
    }
  }
}

void VisibilityWorker::fulfil(Wish wish) {
  wish_ = std::move(wish);
  if (!wish_.fabric) {
    setStatus({});
    return;
  }
  std::string recipe = bvdfRecipe(*wish_.fabric, options_);
  if (recipe == recipe_ && !interrupted_) {
    publish(numberedFor(*wish_.fabric, newest_->tables), true);
    return;
  }
  bake(wish_.fabric, wish_.stop, std::move(recipe));
}

/// Whether the bake under way is right for a newer wish too: another yarn or another colour is no reason to begin anew.
bool VisibilityWorker::serves(Wish newer) {
  if (newer.fabric && bvdfRecipe(*newer.fabric, options_) == recipe_) {
    wish_ = std::move(newer);
    return true;
  }
  next_ = std::move(newer);
  return false;
}

void VisibilityWorker::bake(std::shared_ptr<const Fabric> fabric, std::stop_token wanted, std::string recipe) {
  constexpr double kBetweenPictures_s = 0.25;
  recipe_ = std::move(recipe);
  ++bake_;
  interrupted_ = true;
  const std::shared_ptr<const BvdfSet> prior = cache_.has(recipe_) ? nullptr : known_.nearest(recipe_);
  const bool borrowing = prior != nullptr;
  setStatus({true, borrowing, 0, ""});
  if (prior) publish(numberedFor(*fabric, prior), false);

  std::stop_source stop;
  const std::stop_callback withThread(ending_, [&stop] { stop.request_stop(); });
  const std::stop_callback withWish(std::move(wanted), [&stop] { stop.request_stop(); });
  Task task;
  task.stop = stop.get_token();
  task.threads = 1;
  int percent = 0;
  double progress = 0;
  task.progress = [&](double fraction) {
    progress = fraction;
    const int now = static_cast<int>(100 * fraction);
    if (std::exchange(percent, now) != now) setStatus({true, borrowing, fraction, ""});
  };
  Stopwatch sincePicture;
  double waited_s = kBetweenPictures_s;  // the first at once
  auto set = bakeBvdf(*fabric, options_, cache_, task, [&](const BvdfBaker& baker) {
    if (auto newer = wishes_.take()) {
      if (!serves(std::move(*newer))) {
        stop.request_stop();
        return;
      }
      waited_s = kBetweenPictures_s;
    }
    waited_s += sincePicture.lap();
    if (waited_s < kBetweenPictures_s) return;
    waited_s = 0;
    const auto own = baker.tables();
    publish(numberedFor(*wish_.fabric, prior ? drawnTowards(*own, *prior, progress) : own), false);
  });
  interrupted_ = !set;
  if (set) {
    known_.keep(recipe_, set);
    publish(numberedFor(*wish_.fabric, set), true);
  }
  setStatus({});
}

void VisibilityWorker::publish(std::shared_ptr<const BvdfSet> tables, bool finished) {
  auto baked = std::make_shared<BakedVisibility>();
  baked->bake = bake_;
  baked->rays = tables->rays;
  baked->finished = finished;
  baked->yarn = std::clamp(wish_.yarn, 0, static_cast<int>(wish_.fabric->yarns.size()) - 1);
  baked->picture = bvdfSquares(tables->of(baked->yarn), kPictureColumns);
  // Of edits in quick succession each borrows what the one before did: the picture need not begin anew.
  baked->tables = newest_ && alike(*newest_->tables, *tables) ? newest_->tables : std::move(tables);
  {
    std::lock_guard lock(mutex_);
    newest_ = std::move(baked);
  }
  wake_();
}

}  // namespace loomlight
