#include "app/editor/services/cloth_colour_service.h"

#include "core/fabric/yarn/dyeing.h"
#include "render/colour/colour_difference.h"
#include "render/colour/colour_space.h"

namespace loomlight {
namespace {

using Judged = ClothColourModel::Judged;

/// A colour that was picked has no spectrum: it can be judged in the light that it was picked for alone.
void judgeInDaylight(ClothColourModel& model, const Rgb& wanted) {
  const Lab standard = labFromLinear(glm::dvec3(wanted)), sample = labFromLinear(glm::dvec3(model.colour));
  model.present = {StandardIlluminant::d65, cmcDifference(standard, sample), ciede2000(standard, sample), 0};
}

void judge(ClothColourModel& model, const std::vector<LampJudgement>& judgements) {
  for (size_t i = 0; i < judgements.size(); ++i) {
    const Judgement& judgement = judgements[i].judgement;
    const Judged judged{judgements[i].lamp, judgement.cmc, judgement.ciede2000, judgement.metamerism};
    if (i == 0) {
      model.present = judged;
      model.difference = judged.ciede2000;
    } else if (!model.worst || judged.cmc > model.worst->cmc) {
      model.worst = judged;
    }
  }
}

}  // namespace

ClothColourModel ClothColourService::model(const std::shared_ptr<const Fabric>& fabric, const ClothPart& part,
                                           const ClothColourView& view) const {
  using State = ClothColourModel::State;
  ClothColourModel model;
  const std::shared_ptr<const ColourAnswer> answer = worker_.newest();
  if (!worker_.error().empty()) model.state = State::failed;
  // What is known of the cloth before the last edit is shown until it is known of this one.
  if (!answer || answer == forgotten_ || answer->wish.part != part) return model;
  model.state = answer->seen ? State::known : State::hidden;
  model.colour = answer->colour;
  model.error = answer->error;
  // A dye that was found and is not handed out yet is about to make another cloth.
  const bool dyes = (answer->solved || answer->matched) && answer->wish.number > doneWish_;
  model.isCurrent = answer->wish.fabric == fabric && !dyes;
  const auto wanted = view.wanted.find(part);
  if (wanted == view.wanted.end()) return model;
  model.difference =
      ciede2000(labFromLinear(glm::dvec3(wanted->second.colour)), labFromLinear(glm::dvec3(model.colour)));
  if (answer->solved && answer->wish.wanted == wanted->second.colour) {
    model.tooLight = answer->solved->tooLight;
    model.tooDark = answer->solved->tooDark;
  }
  if (answer->matched && answer->wish.measured == wanted->second.measured) {
    model.tooLight = answer->matched->tooLight > 0;
    model.tooDark = answer->matched->tooDark > 0;
    judge(model, answer->judgements);
  }
  if (!wanted->second.measured && answer->seen) judgeInDaylight(model, wanted->second.colour);
  return model;
}

std::optional<Fabric> ClothColourService::follow(const std::shared_ptr<const Fabric>& fabric, const ClothPart& part,
                                                 const ClothColourView& view) {
  const auto wanted = view.wanted.find(part);
  const bool isWanted = wanted != view.wanted.end();
  if (fabric != askedFabric_ || part != asked_ || view.wish != askedWish_) {
    askedFabric_ = fabric;
    asked_ = part;
    askedWish_ = view.wish;
    ColourWish wish{.fabric = fabric, .part = part, .wanted = {}, .measured = {}, .number = view.wish};
    if (isWanted) {
      wish.measured = wanted->second.measured;
      if (!wish.measured) wish.wanted = wanted->second.colour;
    }
    worker_.request(std::move(wish));
  }
  const std::shared_ptr<const ColourAnswer> answer = worker_.newest();
  if (!isWanted || !answer || answer->wish.number <= doneWish_ || answer->wish.part != part ||
      (!answer->solved && !answer->matched))
    return std::nullopt;
  doneWish_ = answer->wish.number;
  return dyedAlike(
      readyToDye(*fabric, part), part,
      answer->matched ? Absorption(answer->matched->absorption_per_mm) : Absorption(answer->solved->absorption_per_mm));
}

}  // namespace loomlight
