#include "app/live/colour_worker.h"

#include <exception>

#include "app/live/background_thread.h"
#include "render/scene/scene.h"
#include "render/transport/dye_walks.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

std::shared_ptr<const ColourAnswer> answerTo(const ColourWish& wish, const ColourWalks& walks) {
  auto answer = std::make_shared<ColourAnswer>();
  answer->wish = wish;
  answer->seen = walks.lit() > 0;
  if (!answer->seen) return answer;
  answer->colour = walks.colour(absorptionsOf(*wish.fabric));
  if (wish.wanted) answer->solved = solveColour(walks, absorptionsOf(*wish.fabric), wish.fibre, *wish.wanted);
  return answer;
}

}  // namespace

ColourWorker::ColourWorker(std::function<void()> wake) : wake_(std::move(wake)) {
  thread_ = std::jthread([this](std::stop_token stop) {
    lowerPriorityOfThisThread();
    loop(stop);
  });
}

ColourWorker::~ColourWorker() = default;

void ColourWorker::request(ColourWish wish) {
  wishes_.post(std::move(wish));
}

std::shared_ptr<const ColourAnswer> ColourWorker::newest() const {
  std::lock_guard lock(mutex_);
  return newest_;
}

std::string ColourWorker::error() const {
  std::lock_guard lock(mutex_);
  return error_;
}

void ColourWorker::publish(std::shared_ptr<const ColourAnswer> answer, std::string error) {
  {
    std::lock_guard lock(mutex_);
    if (answer) newest_ = std::move(answer);
    error_ = std::move(error);
  }
  wake_();
}

/// Walks for the newest wish, which may change under way. False when the thread is to end.
bool ColourWorker::makeWalks(std::stop_token ending) {
  while (!ending.stop_requested()) {
    auto patch = std::make_shared<const Fabric>(undyedPatch(*wish_.fabric));
    if (construction_ && *construction_ == *patch && walkedFibre_ == wish_.fibre) return true;
    std::stop_source stop;
    const std::stop_callback withThread(ending, [&stop] { stop.request_stop(); });
    Task task;
    task.stop = stop.get_token();
    task.threads = 1;
    task.progress = [&](double) {
      auto newer = wishes_.take();
      if (!newer) return;
      const bool same = newer->fibre == wish_.fibre && undyedPatch(*newer->fabric) == *patch;
      wish_ = std::move(*newer);
      if (!same) stop.request_stop();
    };
    const int fibre = wish_.fibre;
    const auto scene = makeScene(patch, task);
    const auto medium = scene ? makeMedium(*scene, defaultMemoryLimit_bytes(), task) : nullptr;
    auto walks = medium ? walkColours(*scene, *medium, fibre, kDyeWalks, task) : std::nullopt;
    if (!walks) continue;
    construction_ = std::move(patch);
    walkedFibre_ = fibre;
    walks_ = std::move(*walks);
  }
  return false;
}

void ColourWorker::loop(std::stop_token stop) {
  while (auto wish = wishes_.wait(stop)) {
    wish_ = std::move(*wish);
    try {
      if (!makeWalks(stop)) return;
      publish(answerTo(wish_, walks_), "");
    } catch (const std::exception& e) {
      publish(nullptr, e.what());
    }
  }
}

}  // namespace loomlight
