#include "core/fabric/model/glossary.h"
#include "ui/draft/draft_panel.h"
#include "ui/draft/order_field.h"

namespace loomlight {

std::optional<Fabric> orderPage(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view) {
  const RowText warp{"draft.warp_order", words::warpOrder.label, words::yarnOrder.help};
  const RowText weft{"draft.weft_order", words::weftOrder.label, words::yarnOrder.help};
  std::optional<Fabric> edited =
      orderField(ui, warp, fabric, &Fabric::warpSequence, fabric.warpPitch_mm(), view.warpOrder);
  if (auto wefted = orderField(ui, weft, fabric, &Fabric::weftSequence, fabric.weftPitch_mm(), view.weftOrder))
    edited = std::move(wefted);
  if (auto ordered = colourOrderTools(ui, fabric, yarnColours, view.yarnNames, view.colourOrder))
    edited = std::move(ordered);
  return edited;
}

}  // namespace loomlight
