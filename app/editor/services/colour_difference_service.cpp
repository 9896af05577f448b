#include "app/editor/services/colour_difference_service.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/fabric/model/booth_lamps.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "render/colour/colour_difference.h"
#include "render/scene/colouring.h"
#include "render/transport/dye_paths.h"
#include "ui/widgets/fields.h"
#include "ui/words/booth_words.h"

namespace loomlight {
namespace {

Colouring colouringIn(const Fabric& fabric, int colourway) {
  return colouringInDaylight(
      colourway == 0 ? fabric : inColourway(fabric, fabric.colourways[static_cast<size_t>(colourway - 1)]));
}

ColourDifferenceModel::Side sideOf(const Lab& lab, const Spectrum& reflectance, const LinearWeights& lamp) {
  return {lab.L, lab.a, lab.b, toDisplayColour(Rgb(weighted(lamp, reflectance)))};
}

std::vector<ColourDifferenceModel::UnderLamp> judgedInBooth(const Spectrum& standard, const Spectrum& sample) {
  const auto illuminant = [](StandardIlluminant lamp) { return illuminantOf(underLamp(Light{}, lamp)); };
  const TristimulusWeights daylight = tristimulusWeights(illuminant(kBoothLamps.front()), Observer::degrees10);
  std::vector<ColourDifferenceModel::UnderLamp> all;
  for (const StandardIlluminant lamp : kBoothLamps) {
    const Judgement of = judged(standard, sample, tristimulusWeights(illuminant(lamp), Observer::degrees10), daylight);
    const LinearWeights shown = linearWeights(illuminant(lamp), Observer::degrees10);
    all.push_back({lamp, sideOf(of.standard, standard, shown), sideOf(of.sample, sample, shown), of.ciede2000, of.cmc,
                   of.metamerism});
  }
  return all;
}

}  // namespace

ColourDifferenceService::ColourDifferenceService(std::function<void()> wake)
    : worker_(
          std::move(wake), [this](const Request& asked, auto& job) { return judge(asked, job); },
          [](const Request& asked, const std::string& problem) { return Answer{asked, {}, 0, {}, problem}; }) {}

void ColourDifferenceService::follow(const std::shared_ptr<const Fabric>& fabric, const ColourPair& pair) {
  Request wanted{fabric, pair};
  if (wanted == asked_) return;
  asked_ = wanted;
  worker_.ask(std::move(wanted));
}

void ColourDifferenceService::tell(ColourDifferenceModel& model) const {
  const auto answer = worker_.newest();
  if (!answer || answer->of != asked_) {
    model.remark = words::booth::measuring;
    return;
  }
  model.lamps = answer->lamps;
  model.error = answer->error;
  model.remark = answer->hidden ? fmt::format(words::booth::isHidden, model.yarns[static_cast<size_t>(*answer->hidden)])
                                : answer->problem;
}

/// Null when stopped.
const PathLengthTally* ColourDifferenceService::pathsTo(int yarn, const Fabric& fabric, Judging::Job& job) {
  if (const auto known = paths_.find(yarn); known != paths_.end()) return &known->second;
  Task task;
  task.stop = job.stop();
  task.threads = 1;
  task.progress = [&](double) {
    if (auto newer = job.takeNewer()) job.giveWayTo(std::move(*newer));
  };
  auto paths = tracePathsForDyes(fabric, partOfYarn(yarn), task, DyePaths::toJudge, kLiveDyeError);
  return paths ? &paths_.emplace(yarn, std::move(*paths)).first->second : nullptr;
}

std::optional<ColourDifferenceService::Answer> ColourDifferenceService::judge(const Request& asked, Judging::Job& job) {
  const Fabric& fabric = *asked.fabric;
  if (!traced_ || !tracedAlike(*traced_, fabric)) paths_.clear();
  traced_ = asked.fabric;
  Answer answer{asked, {}, 0, {}, ""};
  for (const ColouredYarn& of : {asked.pair.standard, asked.pair.sample})
    if (!isWoven(fabric, of.yarn)) {
      answer.hidden = of.yarn;
      return answer;
    }
  std::vector<Spectrum> reflectances;
  for (const ColouredYarn& of : {asked.pair.standard, asked.pair.sample}) {
    const PathLengthTally* const paths = pathsTo(of.yarn, fabric, job);
    if (!paths) return std::nullopt;
    if (paths->lit() == 0) {
      answer.hidden = of.yarn;
      return answer;
    }
    answer.error = std::max(answer.error, colourError(*paths));
    reflectances.push_back(paths->reflectance(colouringIn(fabric, of.colourway)).mean);
  }
  answer.lamps = judgedInBooth(reflectances[0], reflectances[1]);
  return answer;
}

}  // namespace loomlight
