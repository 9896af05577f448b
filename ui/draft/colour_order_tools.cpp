#include "ui/draft/colour_order_tools.h"

#include <algorithm>

#include "core/fabric/model/glossary.h"
#include "core/fabric/model/validate.h"
#include "ui/widgets/fields.h"
#include "ui/words/panel_words.h"
#include "ui/words/stripe_words.h"

namespace loomlight {
namespace {

/// How many threads of each yarn there are: random stripes keep these proportions.
std::vector<double> weightsOf(const std::vector<int>& sequence, size_t yarns) {
  std::vector<double> weights(yarns, 0);
  for (const int yarn : sequence) weights[static_cast<size_t>(yarn)] += 1;
  // One yarn alone makes no stripes: all take part then.
  if (std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; }) < 2)
    std::fill(weights.begin(), weights.end(), 1);
  return weights;
}

void stripeFields(Ui& ui, StripeChance& stripes) {
  wholeNumberField(ui, {"order.threads", words::stripe::length}, "", 2, 4096, stripes.length);
  if (wholeNumberField(ui, {"order.narrowest", words::stripe::narrowest}, "", 1, 512, stripes.narrowest))
    stripes.widest = std::max(stripes.widest, stripes.narrowest);
  if (wholeNumberField(ui, {"order.widest", words::stripe::widest}, "", 1, 512, stripes.widest))
    stripes.narrowest = std::min(stripes.narrowest, stripes.widest);
}

/// Buttons, three in a line, that make another order of one. `other`: the other system's.
std::optional<std::vector<int>> orderButtons(Ui& ui, const std::vector<int>& own, const std::vector<int>& other,
                                             int weaveRepeat, bool weft) {
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  const bool twiceFits = 2 * own.size() <= kMaxSequence;
  std::vector<int> even = balanced(own, weaveRepeat);
  const Word& copy = weft ? words::copyWarp : words::copyWeft;
  std::optional<std::vector<int>> made;
  const auto tool = [&](const char* id, const Word& word, bool enabled, const auto& make) {
    if (button(ui, id, word.label, third, enabled, word.help)) made = make();
  };
  tool("order.mirror", words::mirrorOrder, own.size() > 2 && 2 * own.size() - 2 <= kMaxSequence,
       [&] { return mirrored(own); });
  ImGui::SameLine();
  tool("order.reverse", words::reverseOrder, own.size() > 1, [&] { return reversed(own); });
  ImGui::SameLine();
  tool("order.repeat", words::repeatOrder, twiceFits, [&] { return repeated(own, 2); });
  tool("order.widen", words::doubleThreads, twiceFits, [&] { return widened(own, 2); });
  ImGui::SameLine();
  tool("order.copy", copy, own != other, [&] { return other; });
  ImGui::SameLine();
  tool("order.balance", words::balance, even != own && even.size() <= kMaxSequence, [&] { return even; });
  return made;
}

}  // namespace

std::optional<Fabric> colourOrderTools(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours,
                                       const std::vector<std::string>& yarnNames, ColourOrderView& view) {
  segmentField(ui, {"order.system", words::stripe::of}, words::panels::systems, view.weft);
  const std::vector<int>& own = view.weft ? fabric.weftSequence : fabric.warpSequence;
  const std::vector<int>& other = view.weft ? fabric.warpSequence : fabric.weftSequence;
  const StripedSystem striped{yarnColours, yarnNames, view.weft ? fabric.weftPitch_mm() : fabric.warpPitch_mm(),
                              view.weft ? words::stripe::pick : words::stripe::end,
                              view.weft ? words::stripe::picks : words::stripe::ends};
  StripeRows& rows = view.weft ? view.weftStripes : view.warpStripes;
  rows.follow(own);
  std::optional<std::vector<int>> made = stripeBar(ui, striped, rows);
  if (auto order = orderButtons(ui, own, other, view.weft ? fabric.weave.picks() : fabric.weave.ends(), view.weft))
    made = std::move(order);
  if (foldingHeading(ui, "order.stripes", words::stripes.label, words::stripes.help, view.stripesOpen))
    if (auto set = stripeTable(ui, striped, rows)) made = std::move(set);

  if (foldingHeading(ui, "order.chance", words::randomStripes.label, words::randomStripes.help, view.randomOpen)) {
    if (button(ui, "order.random", words::stripe::newStripes, -1, fabric.yarns.size() > 1, words::randomStripes.help)) {
      made = randomStripes(weightsOf(own, fabric.yarns.size()), view.stripes);
      ++view.stripes.seed;
    }
    stripeFields(ui, view.stripes);
  }
  if (!made) return std::nullopt;
  Fabric edited = fabric;
  (view.weft ? edited.weftSequence : edited.warpSequence) = std::move(*made);
  return edited;
}

}  // namespace loomlight
