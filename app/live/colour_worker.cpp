#include "app/live/colour_worker.h"

#include <utility>

#include "core/base/error.h"
#include "core/fabric/model/booth_lamps.h"
#include "render/scene/colouring.h"
#include "render/transport/dye_paths.h"

namespace loomlight {
namespace {

std::shared_ptr<const Fabric> readyFor(const ColourWish& wish) {
  return std::make_shared<const Fabric>(readyToDye(*wish.fabric, wish.part));
}

TristimulusWeights weightsUnder(const Light& light) {
  return tristimulusWeights(illuminantOf(light), Observer::degrees10);
}

/// The cloth's own lamp, or daylight where it is a file that cannot be used: the picture says so.
TristimulusWeights lampOf(const Fabric& fabric) {
  try {
    return weightsUnder(fabric.light);
  } catch (const InputError&) {
    return weightsUnder(underLamp(fabric.light, StandardIlluminant::d65));
  }
}

/// Empty where the cloth's own lamp is a file that cannot be used.
std::vector<LampJudgement> judgementsOf(const Spectrum& standard, const Spectrum& cloth, const Fabric& fabric) {
  std::vector<StandardIlluminant> lamps{fabric.light.illuminant};
  for (const StandardIlluminant lamp : kBoothLamps)
    if (lamp != lamps.front()) lamps.push_back(lamp);
  const auto weightsOf = [&](StandardIlluminant lamp) { return weightsUnder(underLamp(fabric.light, lamp)); };
  std::vector<LampJudgement> judgements;
  try {
    const TristimulusWeights reference = weightsOf(kBoothLamps.front());
    for (const StandardIlluminant lamp : lamps)
      judgements.push_back({lamp, judged(standard, cloth, weightsOf(lamp), reference)});
  } catch (const InputError&) {
    return {};
  }
  return judgements;
}

std::shared_ptr<ColourAnswer> answerTo(const ColourWish& wish, const Fabric& ready, const PathLengthTally& paths) {
  auto answer = std::make_shared<ColourAnswer>();
  answer->wish = wish;
  answer->seen = paths.lit() > 0;
  if (!answer->seen) return answer;
  const Colouring colouring = colouringInDaylight(ready);
  answer->colour = paths.colour(colouring);
  const std::vector<int> dyed = fibresOf(ready, wish.part);
  if (wish.wanted) answer->solved = solveColour(paths, colouring, dyed, *wish.wanted);
  if (!wish.measured) return answer;
  answer->matched = solveReflectance(paths, colouring, dyed, *wish.measured, lampOf(ready));
  answer->judgements = judgementsOf(*wish.measured, paths.reflectance(colouring).mean, ready);
  return answer;
}

}  // namespace

ColourWorker::ColourWorker(std::function<void()> wake)
    : worker_(
          std::move(wake), [this](const ColourWish& wish, auto& job) { return answer(wish, job); },
          [this](const ColourWish&, const std::string& problem) { return Result{last_, problem}; }) {}

std::shared_ptr<const ColourAnswer> ColourWorker::newest() const {
  const auto result = worker_.newest();
  return result ? result->answer : nullptr;
}

std::string ColourWorker::error() const {
  const auto result = worker_.newest();
  return result ? result->error : "";
}

/// Makes paths for the wish, which may be replaced under way by one that the same paths serve. Its fabric, ready to
/// dye; null when stopped.
std::shared_ptr<const Fabric> ColourWorker::makePaths(ColourWish& wish, Answering::Job& job) {
  std::shared_ptr<const Fabric> ready = readyFor(wish);
  if (traced_ && tracedPart_ == wish.part && tracedAlike(*traced_, *ready)) return ready;
  const auto first = ready;
  Task task;
  task.stop = job.stop();
  task.threads = 1;
  task.progress = [&](double) {
    auto newer = job.takeNewer();
    if (!newer) return;
    auto newerReady = readyFor(*newer);
    if (newer->part == wish.part && tracedAlike(*newerReady, *first)) {
      wish = std::move(*newer);
      ready = std::move(newerReady);
    } else {
      job.giveWayTo(std::move(*newer));
    }
  };
  auto paths = tracePathsForDyes(*first, wish.part, task, DyePaths::toSolve, kLiveDyeError);
  if (!paths) return nullptr;
  traced_ = first;
  tracedPart_ = wish.part;
  paths_ = std::move(*paths);
  error_ = colourError(paths_);
  return ready;
}

std::optional<ColourWorker::Result> ColourWorker::answer(ColourWish wish, Answering::Job& job) {
  const auto ready = makePaths(wish, job);
  if (!ready) return std::nullopt;
  const auto answered = answerTo(wish, *ready, paths_);
  answered->error = error_;
  last_ = answered;
  return Result{last_, ""};
}

}  // namespace loomlight
