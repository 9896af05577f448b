#include <fmt/core.h>

#include "core/base/error.h"
#include "core/fabric/model/validate.h"
#include "ui/draft/draft_panel.h"
#include "ui/draft/thread_order.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

/// A text such as "4A 2B"; while it is being typed it may say nothing sensible yet.
std::optional<std::vector<int>> orderRow(Ui& ui, const RowText& text, const Fabric& fabric,
                                         const std::vector<int>& sequence, DraftView::OrderText& typing) {
  // A jacquard's sequence could be sixteen thousand letters long: it is shown, but only the bars edit it.
  constexpr size_t kLongest = 512;
  std::string shown = typing.open ? typing.text : threadOrderText(sequence);
  if (shown.size() > kLongest) shown = fmt::format("{} threads", sequence.size());
  const bool changed = textField(ui, text, shown);
  const bool active = ImGui::IsItemActive();
  if (changed) typing.text = shown;
  if (active && !typing.problem.empty())
    problemBelow(ui, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), typing.problem);
  typing.open = active && (typing.open || changed);
  if (!changed) return std::nullopt;
  try {
    typing.problem.clear();
    return threadOrderFromText(shown, static_cast<int>(fabric.yarns.size()), kMaxSequence);
  } catch (const InputError& error) {
    typing.problem = error.what();
    return std::nullopt;
  }
}

}  // namespace

std::optional<Fabric> orderPage(Ui& ui, const Fabric& fabric, DraftView& view) {
  std::optional<Fabric> edited;
  const RowText warp{"draft.warp_order", "Warp order",
                     "Which yarns the ends use, repeating: 4A 2B is four of the first yarn, then two of the second; "
                     "3(4A 2B) is that three times."};
  if (auto sequence = orderRow(ui, warp, fabric, fabric.warpSequence, view.warpOrder)) {
    edited = fabric;
    edited->warpSequence = std::move(*sequence);
  }
  const RowText weft{"draft.weft_order", "Weft order",
                     "Which yarns the picks use, repeating: 4A 2B is four of the first yarn, then two of the second; "
                     "3(4A 2B) is that three times."};
  if (auto sequence = orderRow(ui, weft, fabric, fabric.weftSequence, view.weftOrder)) {
    edited = fabric;
    edited->weftSequence = std::move(*sequence);
  }
  if (auto ordered = colourOrderTools(ui, fabric, view.colourOrder)) edited = std::move(ordered);
  return edited;
}

}  // namespace loomlight
