#include "app/editor/session.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <utility>

#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/user_folders.h"
#include "app/export/file_name.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/booth_lamps.h"
#include "core/fabric/weave/structure_edit.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/keys.h"
#include "ui/words/file_words.h"
#include "ui/words/message_words.h"

namespace loomlight {
namespace {

DocumentController::Hold heldNow() {
  bool pressed = false;
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) pressed |= ImGui::IsMouseClicked(button);
  return {ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive(), pressed, ImGui::GetActiveID()};
}

}  // namespace

Session::Session(Document document, Settings settings, DisplayDriver& driver, const std::function<void()>& wake,
                 int threads)
    : settings_(std::move(settings)),
      document_(std::move(document), wake),
      viewport_(driver, wake, threads),
      draft_(driver, wake),
      inspector_(driver, wake),
      yarnColours_(wake),
      snapshots_(viewFolder(), driver, wake),
      presets_(presetFolder(), driver, wake),
      tile_(wake),
      handover_(wake),
      profiles_(settings_.colours, wake),
      files_(driver, wake) {
  help_.hints.wanted = !settings_.hintsSeen;
  const ViewSettings& view = settings_.view;
  viewport_.view().denoised = view.denoised;
  viewport_.view().filmic = view.filmic;
  viewport_.view().exposure_stops = view.exposure_stops;
  viewport_.view().booth = view.booth;
  draft_.view().inColour = view.draftInColour;
  draft_.view().back = view.draftBack;
  draft_.view().marksFloats = view.marksFloats;
  inspector_.view().units = settings_.units;
  inspector_.view().clothColour.books = settings_.books;
  inspector_.view().clothColour.tolerance_cmc = settings_.tolerance_cmc;
  snapshots_.setOptions(settings_.snapshot);
  if (!document_.document().file().empty()) remember(document_.document().file());
}

Settings Session::settingsToKeep() const {
  Settings settings = settings_;
  const ViewportView& viewport = viewport_.view();
  const DraftView& draft = draft_.view();
  settings.hintsSeen = !help_.hints.wanted;
  settings.view = {viewport.denoised, viewport.filmic,   viewport.exposure_stops, draft.inColour,
                   draft.back,        draft.marksFloats, viewport.booth};
  settings.snapshot = snapshots_.options();
  settings.units = inspector_.view().units;
  settings.books = inspector_.view().clothColour.books;
  settings.tolerance_cmc = inspector_.view().clothColour.tolerance_cmc;
  settings.colours = profiles_.colours();
  return settings;
}

std::string Session::title() const {
  const std::string& name = document_.fabric()->name;
  return document_.document().isDirty() ? fmt::format(words::messages::windowTitleEdited, name)
                                        : fmt::format(words::messages::windowTitle, name);
}

void Session::frame(Ui& ui) {
  Stopwatch watch;
  viewport_.displayIs(ui.pixels_per_mm);
  if (viewport_.take()) snapshots_.followView(sightNow(), viewport_.service());
  work_s_ = watch.lap();
  document_.beginFrame(heldNow());
  walkNumbers(ui);
  if (!dialogIsOpen()) readKeys();
  drawPanels(ui);
  drawDialogs(ui);
  watch.lap();
  follow(ui);
  work_s_ += watch.lap();
}

/// Takes what workers have brought, and tells them what is wanted now.
void Session::follow(Ui& ui) {
  snapshots_.follow(ui, sightNow(), viewport_.service());
  tile_.follow(ui, viewport_.service());
  handover_.follow(ui, viewport_.service());
  if (const auto message = presets_.follow(!dialogIsOpen())) questions_.say(message->title, message->text);
  if (const auto problem = profiles_.follow()) sayUnopened(*problem);
  const bool panels = settings_.dock.panelsShown;
  const bool isOpening = viewport_.service().isOpening();
  inspector_.followPictures(isOpening);
  if (auto dyed = inspector_.follow(document_.fabric(), document_.gesture(), panels))
    document_.edit(std::move(dyed->fabric), inspector_.place(), dyed->gesture);
  if (!isOpening) yarnColours_.follow(document_.fabric());
  const InspectorView& inspector = inspector_.view();
  viewport_.follow(document_.fabric(), inspector.yarn, inspector.visibilityShown && panels, settings_.limits,
                   {draft_.view().back, settings_.draft.longFloat_mm});
  document_.keepCopy();
}

void Session::run(Command command) {
  switch (command) {
    case Command::newFabric:
      return leaveFor({Errand::Kind::beginAnew});
    case Command::open:
      return browse(FileTask::open);
    case Command::save:
      if (document_.document().file().empty()) return browse(FileTask::saveAs);
      return files_.service().save(document_.document().file(), document_.cloth(), document_.document().state());
    case Command::saveAs:
      return browse(FileTask::saveAs);
    case Command::savePreset:
      return presets_.keep(*document_.cloth());
    case Command::snapshot:
      return snapshots_.show(document_.fabric()->render, freeFile(fileCalledAsCloth(".png")).string());
    case Command::presets:
      viewport_.service().pause(ViewService::Rival::presets, true);
      return presets_.showBrowser();
    case Command::colourways:
      viewport_.service().pause(ViewService::Rival::colourways, true);
      return inspector_.showColourways();
    case Command::colourDifference:
      viewport_.service().pause(ViewService::Rival::colourDifference, true);
      return inspector_.showColourDifference();
    case Command::keepView:
      return snapshots_.keepView(sightNow(), viewport_.service());
    case Command::chooseMesh:
      return browse(FileTask::mesh);
    case Command::chooseEnvironment:
      return browse(FileTask::environment);
    case Command::quit:
      return askToQuit();
    case Command::undo:
      return goTo(document_.undo());
    case Command::redo:
      return goTo(document_.redo());
    case Command::fitView:
      viewport_.view().fitWanted = true;
      break;
    case Command::actualSize:
      return look(viewport_.atActualSize(*document_.fabric(), settings_.rulerFactor));
    case Command::sheet:
      return browse(FileTask::sheet);
    case Command::handover:
      return handover_.show(freeFile(fileCalledAsCloth(words::files::handoverEnding)).string(), document_.cloth());
    case Command::brushBefore:
      return inspector_.stepYarn(-1, document_.fabric()->yarns.size());
    case Command::brushNext:
      return inspector_.stepYarn(1, document_.fabric()->yarns.size());
    case Command::swapBrushes:
      return inspector_.swapYarns(document_.fabric()->yarns.size());
    case Command::fitDraft:
      return draft_.fit();
    case Command::truthLens:
      return viewport_.view().inset.toggle();
    case Command::boothLamp:
      return document_.judgeUnder(nextLamp(document_.cloth()->light.illuminant, document_.document().judgedUnder()));
    case Command::boothSideBySide:
      return viewport_.showBooth(!viewport_.view().booth);
    case Command::plainTone:
      viewport_.view().filmic = !viewport_.view().filmic;
      break;
    case Command::denoise:
      viewport_.view().denoised = !viewport_.view().denoised;
      break;
    case Command::softProof:
      if (!profiles_.knowsPrinter()) return browse(FileTask::profile);
      profiles_.colours().proofs = !profiles_.colours().proofs;
      break;
    case Command::gamutWarning:
      profiles_.colours().warnsOfGamut = !profiles_.colours().warnsOfGamut;
      break;
    case Command::preferences:
      return preferences_.show();
    case Command::togglePanels:
      settings_.dock.panelsShown = !settings_.dock.panelsShown;
      break;
    case Command::fullScreen:
      window_.isFull = !window_.isFull;
      break;
    case Command::darkTheme:
      settings_.darkTheme = true;
      break;
    case Command::lightTheme:
      settings_.darkTheme = false;
      break;
    case Command::showKeys:
      return help_.keys.show();
    case Command::showAbout:
      return questions_.say(fmt::format(words::messages::aboutTitle, LOOMLIGHT_VERSION), words::messages::about);
  }
}

void Session::run(DraftCommand command) {
  switch (command) {
    case DraftCommand::structures:
      return draft_.showStructures();
    case DraftCommand::fromPicture:
      return browse(FileTask::picture);
    case DraftCommand::exportWif:
      return browse(FileTask::exportWif);
    case DraftCommand::exportBitmap:
      return browse(FileTask::exportBitmap);
    case DraftCommand::exportDraft:
      return browse(FileTask::exportDraft);
    case DraftCommand::exportTile:
      return tile_.show(freeFile(fileCalledAsCloth(words::files::tileEnding)).string(), document_.cloth());
    default:
      const EditPlace place = draft_.place();
      if (auto edited = draft_.run(command, *document_.fabric(), settings_.draft))
        document_.edit(std::move(*edited), place);
  }
}

void Session::readKeys() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return;
  // Keys are for a list that is open: Escape shuts it alone, and nothing is edited behind it.
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  const bool escape = keyPressed(ImGuiKey_Escape);
  if (const auto command = draftKey(draft_.view())) return run(*command);
  if (io.KeyCtrl) {
    if (letterPressed('N')) run(Command::newFabric);
    if (letterPressed('O')) run(Command::open);
    if (letterPressed('S')) run(io.KeyShift ? Command::saveAs : Command::save);
    if (letterPressed('Z')) run(io.KeyShift ? Command::redo : Command::undo);
    if (letterPressed('Y')) run(Command::redo);
    if (letterPressed('P')) run(Command::snapshot);
    if (letterPressed('B')) run(Command::presets);
    if (letterPressed('E')) run(DraftCommand::exportTile);
    if (letterPressed('Q')) run(Command::quit);
    if (letterPressed('0')) run(Command::fitView);
    if (letterPressed('1')) run(Command::actualSize);
    return;
  }
  if (letterPressed('F')) run(io.KeyShift ? Command::fitDraft : Command::fitView);
  if (letterPressed('K')) run(Command::keepView);
  if (letterPressed('L')) run(Command::truthLens);
  if (letterPressed('J')) run(io.KeyShift ? Command::boothSideBySide : Command::boothLamp);
  if (letterPressed('N')) run(Command::denoise);
  if (letterPressed('X')) run(Command::swapBrushes);
  if (letterPressed('Y')) run(io.KeyShift ? Command::gamutWarning : Command::softProof);
  if (io.InputQueueCharacters.contains('[')) run(Command::brushBefore);
  if (io.InputQueueCharacters.contains(']')) run(Command::brushNext);
  if (escape && viewport_.view().inset.on)
    viewport_.view().inset.close();
  else if (escape)
    viewport_.leaveFlat();
  if (letterPressed('P')) run(Command::togglePanels);
  if (functionKeyPressed(1) || io.InputQueueCharacters.contains('?')) run(Command::showKeys);
  if (functionKeyPressed(11)) run(Command::fullScreen);
}

void Session::startOver(Document document) {
  document_.startOver(std::move(document));
  viewport_.leaveFlat();
  viewport_.service().open();
  draft_.startOver();
  inspector_.startOver();
  yarnColours_.forget();
}

/// Flat cloth is looked at by a camera of its own.
void Session::look(const Camera& camera) {
  if (!viewport_.lookAtFlat(camera)) document_.lookFrom(camera);
}

void Session::applyPreset(const PresetChoice& choice) {
  if (choice.isSample) return dress(sampleFabric(choice.index));
  files_.service().open(FileService::Work::usePreset, presets_.fileOf(choice), document_.cloth(),
                        document_.document().state());
}

void Session::dress(const Fabric& cloth) {
  document_.edit(dressed(*document_.fabric(), cloth), draft_.place());
  draft_.fit();
}

/// To where an edit was made.
void Session::goTo(const EditPlace& place) {
  if (place.panel == EditPlace::Panel::none) return;
  settings_.dock.panelsShown = true;
  if (place.panel == EditPlace::Panel::draft)
    draft_.goTo(place);
  else
    inspector_.goTo(place);
}

}  // namespace loomlight
