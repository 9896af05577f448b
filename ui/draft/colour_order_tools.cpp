#include "ui/draft/colour_order_tools.h"

#include <algorithm>

#include "core/fabric/model/glossary.h"
#include "core/fabric/model/validate.h"
#include "ui/draft/stripe_table.h"
#include "ui/widgets/fields.h"

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
  wholeNumberField(ui, {"order.threads", "Threads", "How many threads the order has until it repeats"}, "", 2, 4096,
                   stripes.threads);
  if (wholeNumberField(ui, {"order.narrowest", "Narrowest stripe", "Threads that a stripe has at least"}, "", 1, 512,
                       stripes.narrowest))
    stripes.widest = std::max(stripes.widest, stripes.narrowest);
  if (wholeNumberField(ui, {"order.widest", "Widest stripe", "Threads that a stripe has at most"}, "", 1, 512,
                       stripes.widest))
    stripes.narrowest = std::min(stripes.narrowest, stripes.widest);
}

}  // namespace

std::optional<Fabric> colourOrderTools(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours,
                                       ColourOrderView& view) {
  static constexpr const char* kSystems[] = {"Warp", "Weft"};
  int system = view.weft ? 1 : 0;
  segmentField(ui, {"order.system", "Tools for", "Whose colour order the tools below work on."}, kSystems, system);
  view.weft = system == 1;
  const std::vector<int>& own = view.weft ? fabric.weftSequence : fabric.warpSequence;
  const std::vector<int>& other = view.weft ? fabric.warpSequence : fabric.weftSequence;
  std::optional<std::vector<int>> made;
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ui.px(8));
  if (button(ui, "order.mirror", "Mirror", half, own.size() > 2 && 2 * own.size() - 2 <= kMaxSequence,
             "There and back again, turning on the outermost threads"))
    made = mirrored(own);
  ImGui::SameLine();
  if (button(ui, "order.reverse", "Reverse", half, own.size() > 1, "From the other side")) made = reversed(own);
  if (button(ui, "order.widen", words::doubleThreads.label, half, 2 * own.size() <= kMaxSequence,
             words::doubleThreads.help))
    made = widened(own, 2);
  ImGui::SameLine();
  if (button(ui, "order.copy", (view.weft ? words::copyWarp : words::copyWeft).label, half, own != other,
             words::copyWeft.help))
    made = other;

  const int repeat = view.weft ? fabric.weave.picks() : fabric.weave.ends();
  const std::vector<int> even = balanced(own, repeat);
  if (button(ui, "order.balance", words::balance.label, 0, even != own && even.size() <= kMaxSequence,
             words::balance.help))
    made = even;
  if (foldingHeading(ui, "order.stripes", words::stripes.label, words::stripes.help, view.stripesOpen))
    if (auto set = stripeTable(ui, own, yarnColours, view.weft ? fabric.weftPitch_mm() : fabric.warpPitch_mm()))
      made = std::move(set);

  heading(ui, words::randomStripes.label);
  if (button(ui, "order.random", "New stripes", -1, fabric.yarns.size() > 1, words::randomStripes.help)) {
    made = randomStripes(weightsOf(own, fabric.yarns.size()), view.stripes);
    ++view.stripes.seed;
  }
  stripeFields(ui, view.stripes);
  if (!made) return std::nullopt;
  Fabric edited = fabric;
  (view.weft ? edited.weftSequence : edited.warpSequence) = std::move(*made);
  return edited;
}

}  // namespace loomlight
