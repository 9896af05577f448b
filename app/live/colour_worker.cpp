#include "app/live/colour_worker.h"

#include <utility>

#include "core/fabric/model/changes.h"
#include "render/transport/cloth_walks.h"

namespace loomlight {
namespace {

/// Whether walks through the cloth of one fabric tell the colours of the other's: on a flat patch, under the same sky.
bool walkedAlike(const Fabric& a, const Fabric& b) {
  return changes(a, b).stages.within(Stage::drape | Stage::colour | Stage::brightness | Stage::light | Stage::camera |
                                     Stage::label);
}

std::shared_ptr<const ColourAnswer> answerTo(const ColourWish& wish, const PathLengthTally& walks) {
  auto answer = std::make_shared<ColourAnswer>();
  answer->wish = wish;
  answer->seen = walks.lit() > 0;
  if (!answer->seen) return answer;
  const Colouring colouring = colouringInDaylight(*wish.fabric);
  answer->colour = walks.colour(colouring);
  const std::vector<int> dyed = dyedWith(wish.fibre, wish.fabric->fibres.size());
  if (wish.wanted) answer->solved = solveColour(walks, absorptionsOf(*wish.fabric), dyed, *wish.wanted);
  if (wish.measured) answer->matched = solveReflectance(walks, colouring, dyed, *wish.measured);
  return answer;
}

}  // namespace

ColourWorker::ColourWorker(std::function<void()> wake)
    : worker_(
          std::move(wake), [this](const ColourWish& wish, auto& turn) { return answer(wish, turn); },
          [this](const ColourWish&, const std::string& problem) { return Result{last_, problem}; }) {}

std::shared_ptr<const ColourAnswer> ColourWorker::newest() const {
  const auto result = worker_.newest();
  return result ? result->answer : nullptr;
}

std::string ColourWorker::error() const {
  const auto result = worker_.newest();
  return result ? result->error : "";
}

/// Walks for the wish, which may be replaced under way by one that the same walks serve. False when stopped.
bool ColourWorker::makeWalks(ColourWish& wish, Answering::Turn& turn) {
  if (walked_ && walkedAlike(*walked_, *wish.fabric) && walkedFibre_ == wish.fibre) return true;
  const auto fabric = wish.fabric;
  Task task;
  task.stop = turn.stop();
  task.threads = 1;
  task.progress = [&](double) {
    auto newer = turn.takeNewer();
    if (!newer) return;
    if (newer->fibre == wish.fibre && walkedAlike(*newer->fabric, *fabric))
      wish = std::move(*newer);
    else
      turn.giveWayTo(std::move(*newer));
  };
  auto walks = walkThrough(*fabric, wish.fibre, kDyeWalks, task);
  if (!walks) return false;
  walked_ = fabric;
  walkedFibre_ = wish.fibre;
  walks_ = std::move(*walks);
  return true;
}

std::optional<ColourWorker::Result> ColourWorker::answer(ColourWish wish, Answering::Turn& turn) {
  if (!makeWalks(wish, turn)) return std::nullopt;
  last_ = answerTo(wish, walks_);
  return Result{last_, ""};
}

}  // namespace loomlight
