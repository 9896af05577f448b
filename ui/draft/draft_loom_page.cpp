#include "core/fabric/model/glossary.h"
#include "core/fabric/weave/draft_derivation.h"
#include "ui/draft/draft_panel.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

constexpr int kMostShafts = 4096;  // of a draft, as of its treadles

/// Treadles, liftplan or neither. A weave without a draft of its own is only shown otherwise.
std::optional<Fabric> loomRow(Ui& ui, const Fabric& fabric, DraftView& view) {
  static constexpr const char* kNames[] = {"Treadles", "Liftplan", "Jacquard"};
  using Loom = DraftView::Loom;
  const Loom now = !fabric.draft ? view.loom : fabric.draft->liftplan.empty() ? Loom::treadles : Loom::liftplan;
  int chosen = static_cast<int>(now);
  if (!choiceField(ui,
                   {"loom.kind", "Loom",
                    "Treadles: threading, tie-up and treadling. Liftplan: the shafts of each pick, for a dobby. "
                    "Jacquard: every end by itself, drawn freely."},
                   kNames, chosen))
    return std::nullopt;
  view.loom = static_cast<Loom>(chosen);
  view.remark.clear();
  if (!fabric.draft) return std::nullopt;
  Fabric edited = fabric;
  if (view.loom == Loom::jacquard)
    edited.draft.reset();
  else
    edited.draft = view.loom == Loom::liftplan ? withLiftplan(*fabric.draft) : withTreadles(*fabric.draft);
  return edited;
}

std::optional<Fabric> draftRows(Ui& ui, const Fabric& fabric, const Draft& draft) {
  int shafts = draft.shafts, treadles = draft.treadles, shed = draft.risingShed ? 0 : 1;
  static constexpr const char* kSheds[] = {"Rising", "Sinking"};
  if (wholeNumberField(ui, {"loom.shafts", words::shafts.label, words::shafts.help}, "", 1, kMostShafts, shafts))
    return withDraft(fabric, withShaftCount(draft, shafts));
  if (!draft.liftplan.empty()) return std::nullopt;
  if (wholeNumberField(ui, {"loom.treadles", words::treadles.label, words::treadles.help}, "", 1, kMostShafts,
                       treadles))
    return withDraft(fabric, withTreadleCount(draft, treadles));
  if (segmentField(
          ui,
          {"loom.shed", "Shed",
           "Rising: tied shafts go up. Sinking: they are pulled down. The tie-up is made anew, the cloth stays."},
          kSheds, shed))
    return withDraft(fabric, withShed(draft, shed == 0));
  return std::nullopt;
}

std::optional<Fabric> repeatRows(Ui& ui, const Fabric& fabric, DraftView& view) {
  int ends = fabric.weave.ends(), picks = fabric.weave.picks();
  bool changed = wholeNumberField(
      ui,
      {"draft.ends", "Repeat, ends", "Warp threads until the weave repeats. A larger repeat goes on as the old one."},
      "", 1, Weave::kMaxSide, ends);
  changed |= wholeNumberField(
      ui,
      {"draft.picks", "Repeat, picks", "Weft threads until the weave repeats. A larger repeat goes on as the old one."},
      "", 1, Weave::kMaxSide, picks);
  if (!changed) return std::nullopt;
  Fabric edited = fabric;
  edited.weave = fabric.weave.resized(ends, picks);
  if (fabric.draft) edited.draft = resized(*fabric.draft, ends, picks);
  view.cell = 0;
  view.selection.reset();
  return edited;
}

/// What the designer's loom has, and how drafts are read; nothing of the fabric.
void preferenceRows(Ui& ui, DraftPreferences& preferences, DraftView& view) {
  heading(ui, "For all drafts");
  wholeNumberField(ui, {"loom.most_shafts", words::loomShafts.label, words::loomShafts.help}, "", 1, 256,
                   preferences.loom.shafts);
  wholeNumberField(ui, {"loom.most_treadles", words::loomTreadles.label, words::loomTreadles.help}, "", 1, 256,
                   preferences.loom.treadles);
  static constexpr const char* kCorners[] = {"Bottom left", "Bottom right", "Top left", "Top right"};
  int corner = static_cast<int>(preferences.origin);
  if (choiceField(ui, {"draft.corner", "First thread", "The corner of the drawdown where end 1 and pick 1 are."},
                  kCorners, corner)) {
    preferences.origin = static_cast<DraftPreferences::Origin>(corner);
    view.origin = ImVec2(0, 0);
  }
  switchField(ui, {"draft.rulers", "Rulers", "Lengths along the drawdown, at the fabric's sett."}, preferences.rulers);
  static constexpr const char* kUnits[] = {"cm", "inch"};
  int unit = preferences.inches ? 1 : 0;
  if (segmentField(ui, {"draft.unit", "Lengths in", "Of rulers, setts and repeats."}, kUnits, unit))
    preferences.inches = unit == 1;
}

}  // namespace

std::optional<Fabric> loomPage(Ui& ui, const Fabric& fabric, DraftPreferences& preferences, DraftView& view) {
  std::optional<Fabric> edited = loomRow(ui, fabric, view);
  if (const Draft* draft = draftBeside(fabric, preferences, view))
    if (auto drafted = draftRows(ui, fabric, *draft)) edited = std::move(drafted);
  if (auto resized = repeatRows(ui, fabric, view)) edited = std::move(resized);
  preferenceRows(ui, preferences, view);
  return edited;
}

}  // namespace loomlight
