#include "app/editor/services/cloth_colour_service.h"

#include "render/colour/colour_space.h"

namespace loomlight {

static_assert(kPiece == kAnyMaterial);

ClothColourModel ClothColourService::model(const Fabric& fabric, int what, const ClothColourView& view) const {
  using State = ClothColourModel::State;
  ClothColourModel model;
  const std::shared_ptr<const ColourAnswer> answer = worker_.newest();
  if (!worker_.error().empty()) model.state = State::failed;
  // What is known of the cloth before the last edit is shown until it is known of this one.
  if (!answer || answer->wish.fibre != what || answer->wish.fabric->fibres.size() != fabric.fibres.size()) return model;
  model.state = answer->seen ? State::known : State::hidden;
  model.colour = answer->colour;
  const auto wanted = view.wanted.find(what);
  if (wanted == view.wanted.end()) return model;
  model.difference =
      ciede2000(labFromLinear(glm::dvec3(wanted->second.colour)), labFromLinear(glm::dvec3(model.colour)));
  if (answer->solved) {
    model.tooLight = answer->solved->tooLight;
    model.tooDark = answer->solved->tooDark;
  }
  if (answer->matched) {
    model.tooLight = answer->matched->tooLight > 0;
    model.tooDark = answer->matched->tooDark > 0;
  }
  return model;
}

std::optional<Fabric> ClothColourService::follow(const std::shared_ptr<const Fabric>& fabric, int what,
                                                 const ClothColourView& view) {
  if (fabric != askedFabric_ || what != asked_ || view.wish != askedWish_) {
    askedFabric_ = fabric;
    asked_ = what;
    askedWish_ = view.wish;
    const auto wanted = view.wanted.find(what);
    ColourWish wish{.fabric = fabric, .fibre = what, .wanted = {}, .measured = {}, .number = view.wish};
    if (wanted != view.wanted.end()) {
      wish.measured = wanted->second.measured;
      if (!wish.measured) wish.wanted = wanted->second.colour;
    }
    worker_.request(std::move(wish));
  }
  const std::shared_ptr<const ColourAnswer> answer = worker_.newest();
  if (!answer || answer->wish.number <= doneWish_ || answer->wish.fibre != what ||
      (!answer->solved && !answer->matched) || answer->wish.fabric->fibres.size() != fabric->fibres.size())
    return std::nullopt;
  doneWish_ = answer->wish.number;
  Fabric dyed = *fabric;
  for (const int fibre : dyedWith(what, dyed.fibres.size()))
    dyed.fibres[static_cast<size_t>(fibre)].absorption_per_mm = answer->matched
                                                                    ? Absorption(answer->matched->absorption_per_mm)
                                                                    : Absorption(answer->solved->absorption_per_mm);
  return dyed;
}

}  // namespace loomlight
