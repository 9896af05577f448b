#include "core/fabric/model/glossary.h"
#include "core/fabric/weave/draft_derivation.h"
#include "ui/draft/draft_panel.h"
#include "ui/widgets/fields.h"
#include "ui/words/draft_words.h"
#include "ui/words/panel_words.h"
#include "ui/words/trade_words.h"

namespace loomlight {
namespace {

constexpr int kMostShafts = 4096;  // of a draft, as of its treadles

/// Treadles, liftplan or neither. A weave without a draft of its own is only shown otherwise.
std::optional<Fabric> loomRow(Ui& ui, const Fabric& fabric, DraftView& view) {
  using Loom = DraftView::Loom;
  const Loom now = !fabric.draft ? view.loom : fabric.draft->liftplan.empty() ? Loom::treadles : Loom::liftplan;
  int chosen = static_cast<int>(now);
  if (!choiceField(ui, {"loom.kind", words::loomPage::loom}, words::loomPage::looms, chosen)) return std::nullopt;
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

/// A row of what there is none of. It stays, and says why: the rows below keep their places, also under a mouse that is
/// changing what the loom can weave.
void noneRow(Ui& ui, const char* id, const Word& word, const char* why, const char* instead = words::panels::none) {
  readout(ui, {id, word.label, why}, instead);
}

/// `draft`: null for a jacquard.
std::optional<Fabric> draftRows(Ui& ui, const Fabric& fabric, const Draft* draft) {
  if (!draft) {
    noneRow(ui, "loom.shafts", words::shafts, words::loomPage::ofJacquard);
    noneRow(ui, "loom.treadles", words::treadles, words::loomPage::ofJacquard);
    noneRow(ui, "loom.shed", words::loomPage::shed, words::loomPage::ofJacquard);
    return std::nullopt;
  }
  std::optional<Fabric> edited;
  int shafts = draft->shafts, treadles = draft->treadles, shed = draft->risingShed ? 0 : 1;
  if (wholeNumberField(ui, {"loom.shafts", words::shafts}, "", 1, kMostShafts, shafts))
    edited = withDraft(fabric, withShaftCount(*draft, shafts));
  if (!draft->liftplan.empty()) {
    noneRow(ui, "loom.treadles", words::treadles, words::loomPage::treadlesOfLiftplan);
    noneRow(ui, "loom.shed", words::loomPage::shed, words::loomPage::shedOfLiftplan, words::loomPage::sheds[0]);
    return edited;
  }
  if (wholeNumberField(ui, {"loom.treadles", words::treadles}, "", 1, kMostShafts, treadles))
    edited = withDraft(fabric, withTreadleCount(*draft, treadles));
  if (segmentField(ui, {"loom.shed", words::loomPage::shed}, words::loomPage::sheds, shed))
    edited = withDraft(fabric, withShed(*draft, shed == 0));
  return edited;
}

std::optional<Fabric> repeatRows(Ui& ui, const Fabric& fabric, DraftView& view) {
  int ends = fabric.weave.ends(), picks = fabric.weave.picks();
  bool changed = wholeNumberField(ui, {"draft.ends", words::loomPage::endsOfRepeat}, "", 1, Weave::kMaxSide, ends);
  changed |= wholeNumberField(ui, {"draft.picks", words::loomPage::picksOfRepeat}, "", 1, Weave::kMaxSide, picks);
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
  heading(ui, words::loomPage::forAllDrafts);
  wholeNumberField(ui, {"loom.most_shafts", words::loomShafts}, "", 1, 256, preferences.loom.shafts);
  wholeNumberField(ui, {"loom.most_treadles", words::loomTreadles}, "", 1, 256, preferences.loom.treadles);
  int corner = static_cast<int>(preferences.origin);
  if (choiceField(ui, {"draft.corner", words::loomPage::firstThread}, words::loomPage::corners, corner)) {
    preferences.origin = static_cast<DraftPreferences::Origin>(corner);
    view.origin = ImVec2(0, 0);
  }
  switchField(ui, {"draft.rulers", words::loomPage::rulers}, preferences.rulers);
  segmentField(ui, {"draft.unit", words::trade::lengthsIn}, words::trade::lengthUnits, preferences.inches);
}

}  // namespace

std::optional<Fabric> loomPage(Ui& ui, const Fabric& fabric, DraftPreferences& preferences, DraftView& view) {
  std::optional<Fabric> edited = loomRow(ui, fabric, view);
  if (auto drafted = draftRows(ui, fabric, draftBeside(fabric, preferences, view))) edited = std::move(drafted);
  if (auto resized = repeatRows(ui, fabric, view)) edited = std::move(resized);
  preferenceRows(ui, preferences, view);
  return edited;
}

}  // namespace loomlight
