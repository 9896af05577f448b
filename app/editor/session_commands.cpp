#include <fmt/core.h>

#include <filesystem>

#include "app/editor/model/sample_fabric.h"
#include "app/editor/session.h"
#include "app/export/file_name.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/fabric/model/validate.h"
#include "ui/widgets/keys.h"

namespace loomlight {
namespace fs = std::filesystem;

void Session::edit(Fabric fabric) {
  try {
    validate(fabric, "this edit");
    refusal_.clear();
    document_.edit(std::move(fabric), gesture_, place_);
  } catch (const InputError& error) {
    refusal_ = error.what();
  }
}

void Session::run(Command command) {
  switch (command) {
    case Command::newFabric:
      leaveFor(Afterwards::beginAnew);
      break;
    case Command::open:
      browse(FileTask::open);
      break;
    case Command::save:
      if (document_.file().empty())
        browse(FileTask::saveAs);
      else
        save(document_.file());
      break;
    case Command::saveAs:
      browse(FileTask::saveAs);
      break;
    case Command::savePreset:
      presetDesk_.keep(PresetKind::fabrics, *document_.fabric(), 0, 0);
      break;
    case Command::snapshot: {
      snapshot_.forget();
      snapshotDialog_.show(document_.fabric()->render, freeFile(fileCalledAsCloth(".png")).string());
      break;
    }
    case Command::presets:
      views_.pause(true);  // its pictures are looked at now
      presetProblem_.clear();
      presetBrowser_.show();
      break;
    case Command::colourways:
      views_.pause(true);  // its pictures are looked at now
      colourways_.show();
      break;
    case Command::keepView:
      keepView();
      break;
    case Command::chooseMesh:
      browse(FileTask::mesh);
      break;
    case Command::chooseEnvironment:
      browse(FileTask::environment);
      break;
    case Command::quit:
      askToQuit();
      break;
    case Command::undo:
      goTo(document_.undo());
      break;
    case Command::redo:
      goTo(document_.redo());
      break;
    case Command::fitView:
      viewport_.fitWanted = true;
      break;
    case Command::fitDraft:
      draft_.cell = 0;
      break;
    case Command::truthLens:
      viewport_.lens.toggle();
      break;
    case Command::denoise:
      viewport_.denoised = !viewport_.denoised;
      break;
    case Command::preferences:
      preferences_.show();
      break;
    case Command::togglePanels:
      settings_.desk.panelsShown = !settings_.desk.panelsShown;
      break;
    case Command::fullScreen:
      fullScreen_ = !fullScreen_;
      break;
    case Command::darkTheme:
      settings_.darkTheme = true;
      break;
    case Command::lightTheme:
      settings_.darkTheme = false;
      break;
    case Command::showKeys:
      keys_.show();
      break;
    case Command::showAbout:
      say("Loomlight " LOOMLIGHT_VERSION,
          "Woven cloth, seen as it will look: path-traced from the optics of its fibres.\n\n"
          "Colours are shown in sRGB with the white of daylight (D65). Apache License 2.0.");
      break;
  }
}

void Session::readKeys() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return;
  const bool listIsOpen = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const bool escape = keyPressed(ImGuiKey_Escape);
  if (escape && listIsOpen) return;  // it shuts the list alone
  if (const auto command = draftKey(draft_)) return run(*command);
  if (io.KeyCtrl) {
    if (letterPressed('N')) run(Command::newFabric);
    if (letterPressed('O')) run(Command::open);
    if (letterPressed('S')) run(io.KeyShift ? Command::saveAs : Command::save);
    if (letterPressed('Z')) run(io.KeyShift ? Command::redo : Command::undo);
    if (letterPressed('Y')) run(Command::redo);
    if (letterPressed('P')) run(Command::snapshot);
    if (letterPressed('B')) run(Command::presets);
    if (letterPressed('Q')) run(Command::quit);
    return;
  }
  if (letterPressed('F')) run(io.KeyShift ? Command::fitDraft : Command::fitView);
  if (letterPressed('K')) run(Command::keepView);
  if (letterPressed('L')) run(Command::truthLens);
  if (letterPressed('N')) run(Command::denoise);
  if (escape && viewport_.lens.on) viewport_.lens.close();
  if (keyPressed(ImGuiKey_Tab)) run(Command::togglePanels);
  if (functionKeyPressed(1) || io.InputQueueCharacters.contains('?')) run(Command::showKeys);
  if (functionKeyPressed(11)) run(Command::fullScreen);
}

void Session::startOver(Document document) {
  document_ = std::move(document);
  pictures_.forget();
  pictureDialog_.close();
  wifDialog_.close();
  wifKept_.reset();
  keptRevision_ = 0;
  autosave_.forget();
  refusal_.clear();
  draft_.cell = 0;
  draft_.selection.reset();
  draft_.remark.clear();
  inspector_.yarn = 0;
  inspector_.clothColour.wanted.clear();
}

void Session::askToQuit() {
  leaveFor(Afterwards::quit);
}

void Session::leaveFor(Afterwards next) {
  if (question_ == Question::unsaved && message_.isOpen() && afterwards_ == next) return;
  afterwards_ = next;
  if (files_.isReading()) files_.cancel();  // a copy that was taken up stays where it is
  if (files_.busy()) return;                // fileDone() comes back here
  if (!document_.isDirty()) return goOn();
  ask(Question::unsaved, "Unsaved work",
      fmt::format("\xE2\x80\x9C{}\xE2\x80\x9D has changes that are not saved.", document_.fabric()->name),
      {"Cancel", "Don't save", "Save"}, 2);
}

void Session::goOn() {
  switch (std::exchange(afterwards_, Afterwards::nothing)) {
    case Afterwards::quit:
      over_ = true;
      break;
    case Afterwards::beginAnew:
      startOver(Document(sampleFabric()));
      break;
    case Afterwards::open:
      openFabric(pendingFile_);
      break;
    case Afterwards::takeUp:
      files_.open(FileDesk::Work::takeUp, leftBehind_, document_.fabric(), document_.state());
      break;
    case Afterwards::nothing:
      break;
  }
}

void Session::ask(Question question, std::string title, std::string text, std::vector<std::string> answers, int safe) {
  question_ = question;
  message_.show(std::move(title), std::move(text), std::move(answers), safe);
}

void Session::say(std::string title, std::string text) {
  ask(Question::said, std::move(title), std::move(text), {"OK"}, 0);
}

void Session::answered(int answer) {
  const Question question = std::exchange(question_, Question::none);
  if (question == Question::unsaved && answer == 0) afterwards_ = Afterwards::nothing;
  if (question == Question::unsaved && answer == 1) goOn();
  if (question == Question::unsaved && answer == 2) run(Command::save);
  if (question == Question::forgetRecent && answer == 1) forget(settings_.recent, pendingFile_);
  if (question != Question::recover || answer == 0) return;
  if (answer == 1) autosave_.throwAway(leftBehind_);
  if (answer == 2) leaveFor(Afterwards::takeUp);
}

void Session::drawDialogs(Ui& ui) {
  if (recoveryDue_ && !dialogIsOpen()) askForRecovery();
  openDropped();
  // The browser stands in for the snapshot dialog while it names its file.
  if (!browser_.isOpen() && snapshotDialog_.isOpen()) drawSnapshot(ui);
  if (browser_.isOpen())
    if (const auto file = browser_.draw(ui, previews_.of(browser_.chosen()))) fileChosen(*file);
  if (!browser_.isOpen() && !message_.isOpen() && !files_.busy())
    afterwards_ = Afterwards::nothing;  // no file was named
  drawBusy(ui);
  if (const auto answer = message_.draw(ui)) answered(*answer);
  preferences_.draw(
      ui, 1e-9 * static_cast<double>(physicalMemory_bytes()),
      {settings_.darkTheme, settings_.interfaceSize, settings_.units, settings_.draft, settings_.fibreMemory_GB});
  keys_.draw(ui);
  if (presetBrowser_.isOpen()) drawPresets(ui);
  compare_.draw(ui, shelf_.comparison());
  if (colourways_.isOpen()) {
    auto edited = colourways_.draw(ui, *document_.fabric(), sidePictures_.colourways(document_.fabric(), ui.scale));
    if (edited) edit(std::move(*edited));
    if (!colourways_.isOpen()) views_.pause(false);
  }
  drawDraftDialogs(ui);
}

}  // namespace loomlight
