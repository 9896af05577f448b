#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/editor/controllers/status_model.h"
#include "app/editor/session.h"
#include "core/base/memory.h"
#include "ui/menu_bar.h"
#include "ui/widgets/choices.h"
#include "ui/words/message_words.h"
#include "ui/words/status_words.h"

namespace loomlight {

void Session::drawPanels(Ui& ui) {
  MenuModel menu;
  menu.title = document_.fabric()->name;
  menu.edited = document_.document().isDirty();
  menu.canUndo = document_.document().canUndo();
  menu.canRedo = document_.document().canRedo();
  menu.darkTheme = settings_.darkTheme;
  menu.panelsShown = settings_.dock.panelsShown;
  menu.insetOn = viewport_.view().inset.on;
  menu.denoised = viewport_.view().denoised;
  menu.boothSideBySide = viewport_.view().booth;
  menu.plainTone = viewport_.view().isPlain(document_.fabric()->light);
  menu.judgesColour = viewport_.view().isForJudging(document_.fabric()->light);
  menu.proofs = profiles_.colours().proofs;
  menu.warnsOfGamut = profiles_.colours().warnsOfGamut;
  menu.knowsPrinter = profiles_.knowsPrinter();
  menu.weave = {draft_.view().selection.has_value(), draft_.view().back, draft_.view().marksFloats};
  menu.flat = viewport_.flatMenu();
  menu.recent = settings_.recent;
  const float menuHeight = ImGui::GetFontSize() + ui.px(16);
  const MenuChoice choice = menuBar(ui, menu);

  const bool strip = snapshots_.stripIsShown();
  const DockAreas areas =
      dockAreas(settings_.dock, ImGui::GetIO().DisplaySize, menuHeight, ui.scale, strip ? kSnapshotStripHeight : 0);
  splitters(ui, settings_.dock, areas);
  beginPanel("viewport", areas.viewport, false);
  drawViewport(ui);
  endPanel();
  if (strip) {
    beginPanel("strip", areas.strip, false);
    drawStrip(ui);
    endPanel();
  }
  if (settings_.dock.panelsShown) {
    beginPanel("draft", areas.draft, true);
    drawDraft(ui);
    endPanel();
    beginPanel("inspector", areas.inspector, true);
    drawInspector(ui);
    endPanel();
  }
  beginPanel("status", areas.status, false);
  statusBar(ui, statusToSay());
  endPanel();
  const ImVec2 picture(static_cast<float>(viewport_.view().width), static_cast<float>(viewport_.view().height));
  firstHints(ui, areas.viewport.min, picture, help_.hints);
  tellProbe(ui);
  if (choice.command) run(*choice.command);
  if (choice.draft) run(*choice.draft);
  if (choice.flat.cloth) viewport_.layFlat(*document_.fabric(), *choice.flat.cloth);
  if (choice.flat.asDraped) viewport_.leaveFlat();
  if (choice.recent.appeared) lookFor(settings_.recent);
  if (choice.recent.file) openRecent(*choice.recent.file);
  if (choice.recent.clear) settings_.recent.clear();
}

void Session::drawDraft(Ui& ui) {
  const EditPlace place = draft_.place();
  const std::shared_ptr<const FabricStats> stats = viewport_.service().stats();
  const Fabric& fabric = *document_.fabric();
  ShownYarns yarns =
      shownYarns(fabric, yarnColours_.of(fabric), yarnColours_.forNames(fabric), inspector_.view().units.count);
  viewport_.view().yarnNames = yarns.names;
  draft_.view().yarnNames = std::move(yarns.names);
  auto edited = draft_.draw(ui, fabric, yarns.colours, inspector_.view().yarn, stats ? &stats->longFloats : nullptr,
                            settings_.draft, viewport_.underPointer());
  help_.hints.drew |= edited.has_value();
  if (edited) document_.edit(std::move(*edited), place);
  bool browse = false;
  if (const auto choice = presets_.drawList(ui, browse)) applyPreset(*choice);
  if (browse) run(Command::presets);
}

void Session::drawViewport(Ui& ui) {
  ViewportController::Edit edit =
      viewport_.draw(ui, document_.fabric(), draft_.view().hovered, profiles_.proof(), settings_.limits.fibreMemory_GB);
  help_.hints.turned |= edit.orbited;
  if (edit.fabric) document_.edit(std::move(*edit.fabric));
  if (edit.camera) look(*edit.camera);
  if (edit.yarn) inspector_.view().yarn = *edit.yarn;
  if (edit.preferences) run(Command::preferences);
}

void Session::drawStrip(Ui& ui) {
  auto restored = snapshots_.drawStrip(ui, sightNow(), viewport_.service());
  if (!restored) return;
  draft_.view().back = restored->view.back;
  viewport_.lookAs(restored->view.flat, restored->fabric);
  document_.judgeUnder(std::nullopt);  // the lamp of the cloth is taken for what it is
  document_.edit(std::move(restored->fabric));
  document_.judgeUnder(restored->view.judgedUnder);
  draft_.fit();
}

void Session::drawInspector(Ui& ui) {
  const EditPlace place = inspector_.place();
  const bool judged = document_.document().judgedUnder().has_value();
  const auto ownLamp = judged ? std::optional(document_.cloth()->light.illuminant) : std::nullopt;
  InspectorResult result =
      inspector_.draw(ui, document_.fabric(), yarnColours_, viewport_.service(), ownLamp, settings_.draft.inches);
  help_.hints.set |= result.fabric.has_value();
  if (result.fabric) document_.edit(std::move(*result.fabric), place);
  if (result.camera) {
    viewport_.leaveFlat();  // the panel's numbers are those of the cloth on its drape
    document_.lookFrom(*result.camera);
  }
  if (result.command) run(*result.command);
}

/// Dialogs that render to a file. Whatever is browsed, asked or under way stands in for them, and they come back.
void Session::drawRenderings(Ui& ui) {
  if (files_.isBrowsing() || questions_.isOpen() || files_.service().busy()) return;
  if (snapshots_.dialogIsOpen()) {
    const SnapshotController::Edit edit = snapshots_.drawDialog(ui, sightNow(), viewport_.service());
    if (edit.settings) document_.renderAs(*edit.settings);
    if (edit.chooseFile) browse(FileTask::snapshot);
  }
  if (tile_.draw(ui, *document_.cloth(), viewport_.service())) browse(FileTask::exportTile);
  if (handover_.draw(ui, *document_.cloth(), viewport_.service())) browse(FileTask::handover);
}

/// Those that put something into the fabric.
void Session::drawFabricDialogs(Ui& ui) {
  if (presets_.isOpen()) {
    const Fabric& now = *document_.cloth();
    const int yarn = std::min(inspector_.view().yarn, static_cast<int>(now.yarns.size()) - 1);
    auto used = presets_.drawBrowser(ui, now, yarn, shownFibre(now, inspector_.view()));
    if (used) document_.edit(std::move(used->fabric));
    if (used && used->isWhole) draft_.fit();
    if (!presets_.isOpen()) viewport_.service().pause(ViewService::Rival::presets, false);
  }
  if (inspector_.colourwaysAreOpen()) {
    if (auto edited = inspector_.drawColourways(ui, document_.fabric(), yarnColours_))
      document_.edit(std::move(*edited));
    if (!inspector_.colourwaysAreOpen()) viewport_.service().pause(ViewService::Rival::colourways, false);
    if (inspector_.takeColourwaysPrint()) browse(FileTask::colourwaySheet);
  }
  const EditPlace place = draft_.place();
  DraftController::Edit edit = draft_.drawDialogs(ui, document_.fabric(), yarnColours_, settings_.draft);
  if (edit.fabric) document_.edit(std::move(*edit.fabric), place);
  if (!edit.problem.empty()) questions_.say(words::messages::unwovenTitle, edit.problem);
}

void Session::drawDialogs(Ui& ui) {
  openPending();
  if (const auto chosen = files_.drawBrowser(ui)) fileChosen(*chosen);
  if (!files_.isBrowsing() && !questions_.isOpen() && !files_.service().busy()) errand_ = {};  // no file was named
  if (auto result = files_.drawBusy(ui)) fileDone(std::move(*result));
  if (!files_.service().busy())
    if (const auto answer = questions_.draw(ui)) answered(*answer);
  drawPreferences(ui);
  help_.keys.draw(ui);
  snapshots_.drawComparison(ui);
  drawRenderings(ui);
  if (inspector_.colourDifferenceIsOpen()) {
    inspector_.drawColourDifference(ui, document_.fabric(), yarnColours_);
    if (!inspector_.colourDifferenceIsOpen()) viewport_.service().pause(ViewService::Rival::colourDifference, false);
  }
  drawFabricDialogs(ui);
}

void Session::drawPreferences(Ui& ui) {
  if (files_.isBrowsing()) return;
  const PreferencesDialog::Facts facts{kSampleLimits[1], 1e-9 * static_cast<double>(physicalMemory_bytes()),
                                       ui.pixels_per_mm, profiles_.names()};
  const bool chooses = preferences_.draw(
      ui, facts,
      {settings_.darkTheme, settings_.interfaceSize, inspector_.view().units, settings_.draft, profiles_.colours(),
       settings_.rulerFactor, settings_.limits.samples, settings_.limits.fibreMemory_GB});
  if (chooses) browse(FileTask::profile);
}

bool Session::dialogIsOpen() const {
  return files_.service().busy() || files_.isBrowsing() || questions_.isOpen() || snapshots_.dialogIsOpen() ||
         snapshots_.comparisonIsOpen() || preferences_.isOpen() || help_.keys.isOpen() || draft_.dialogIsOpen() ||
         tile_.isOpen() || handover_.isOpen() || inspector_.colourwaysAreOpen() ||
         inspector_.colourDifferenceIsOpen() || presets_.isOpen();
}

/// What is unsafe comes before what is worth knowing of the cloth.
StatusModel Session::statusToSay() const {
  const ViewService& seen = viewport_.service();
  StatusModel model = statusModel(seen.stats().get(), seen.status(), seen.visibilityStatus(), seen.frame().get());
  const Light& light = document_.fabric()->light;
  if (light.illuminant != StandardIlluminant::d65)
    model.lamp = fmt::format(words::status::lamp, lampWord(light.illuminant));
  const auto insist = [&model](const std::string& about, const std::string& problem) {
    if (problem.empty()) return;
    model.warning = about + problem;
    model.moreWarnings = 0;
    model.isUrgent = true;
  };
  insist(words::status::figuresUnknown, seen.insightProblem());
  insist(words::status::viewNotKept, snapshots_.problem());
  insist(words::status::workNotSafe, document_.autosave().problem());
  insist("", document_.refusal());
  return model;
}

void Session::tellProbe(Ui& ui) {
  if (!ui.probe.watching()) return;
  const Document& document = document_.document();
  ui.probe.fact("frame", std::to_string(ImGui::GetFrameCount()));
  ui.probe.fact("text_input", ImGui::GetIO().WantTextInput ? "yes" : "no");
  ui.probe.fact("name", document.fabric()->name);
  ui.probe.fact("file", document.file());
  ui.probe.fact("dirty", document.isDirty() ? "yes" : "no");
  ui.probe.fact("revision", std::to_string(document.revision()));
  viewport_.tellProbe(ui.probe, inspector_.view().yarn);
  ui.probe.fact("refusal", document_.refusal());
  ui.probe.fact("autosave_problem", document_.autosave().problem());
  ui.probe.fact("yarn_colours", yarnColours_.knows(*document_.fabric()) ? "known" : "coming");
  ui.probe.fact("yarn", std::to_string(inspector_.view().yarn));
  ui.probe.fact("dialog", dialogIsOpen() ? "open" : "none");
}

}  // namespace loomlight
