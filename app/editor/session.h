#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/controllers/document_controller.h"
#include "app/editor/controllers/draft_controller.h"
#include "app/editor/controllers/file_controller.h"
#include "app/editor/controllers/handover_controller.h"
#include "app/editor/controllers/inspector_controller.h"
#include "app/editor/controllers/preset_controller.h"
#include "app/editor/controllers/profile_controller.h"
#include "app/editor/controllers/question_controller.h"
#include "app/editor/controllers/snapshot_controller.h"
#include "app/editor/controllers/tile_controller.h"
#include "app/editor/controllers/viewport_controller.h"
#include "app/editor/model/settings.h"
#include "app/editor/services/yarn_colour_service.h"
#include "ui/dialogs/keys_dialog.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dock_layout.h"
#include "ui/first_hints.h"
#include "ui/status_bar.h"
#include "ui/widgets/commands.h"
#include "ui/words/message_words.h"

namespace loomlight {

/// One designer at work: the document, a controller for each panel, and what is asked between them. A controller is
/// given what it shows and hands back what is to be edited; the session alone edits. Draws a frame at a time, in the
/// window's thread, and waits for nobody.
class Session {
 public:
  /// `driver` keeps the pictures that are shown, and outlives the session. `wake` brings the window to draw again;
  /// called from the workers. `threads`: for tracing; 0: all that the machine has.
  Session(Document document, Settings settings, DisplayDriver& driver, const std::function<void()>& wake, int threads);

  void frame(Ui& ui);
  /// Of the last frame, spent on all but drawing: taking what workers have brought, and telling them what to do next.
  double workSeconds() const { return work_s_; }
  void run(Command command);
  void run(DraftCommand command);
  /// Opens a fabric, or uses a mesh, an environment, a lamp or a measured swatch, by what the file is. `yarn`: that it
  /// was dropped on.
  void openFile(const std::string& file, const std::optional<int>& yarn = {});
  /// Opens files that were dropped on the window, one after the other. Each waits until no dialog is open, so that no
  /// answer is taken for a question that was not asked.
  void drop(const std::vector<std::string>& files) { files_.drop(files); }
  /// Says why a file could not be opened.
  void sayUnopened(const std::string& problem) { questions_.say(words::messages::unopenedTitle, problem); }
  /// Says what was remarked when the fabric was read that is shown, where anything was.
  void sayLooksOtherwise(const std::string& file, const std::vector<WifWarning>& remarks);
  /// Asks about unsaved work first, once.
  void askToQuit() { leaveFor({Errand::Kind::quit}); }
  /// Offers what an editor that did not end well has left behind, once no dialog is in the way.
  void offerRecovery() { recoveryIsDue_ = true; }

  bool isOver() const { return window_.isOver; }
  /// The end has come as it should: nothing is left to be taken up again.
  void close() { document_.endWell(); }
  /// `display`: the profile (ICC) that the system has for the display; empty: it says none.
  void startProfiles(std::string display) { profiles_.start(std::move(display)); }
  /// Through which all that is drawn is shown; null: the display is sRGB.
  std::shared_ptr<const ColourCube> displayCube() const { return profiles_.displayCube(); }
  bool wantsFullScreen() const { return window_.isFull; }
  const Settings& settings() const { return settings_; }
  /// To be remembered, with how the panels are looked at now.
  Settings settingsToKeep() const;
  std::string title() const;

 private:
  void openColours(const std::string& file, const std::optional<int>& yarn);
  void openLamp(const std::string& file);
  /// Of the cloth in the viewport.
  std::optional<int> yarnUnderPointer();
  using Question = QuestionController::Question;

  struct Help {
    KeysDialog keys;
    FirstHints hints;
  };
  struct WindowWish {
    bool isOver = false, isFull = false;
  };

  // session_panels.cpp: what is drawn
  void drawPanels(Ui& ui);
  void drawDraft(Ui& ui);
  void drawViewport(Ui& ui);
  void drawStrip(Ui& ui);
  void drawInspector(Ui& ui);
  void drawDialogs(Ui& ui);
  void drawPreferences(Ui& ui);
  void drawFabricDialogs(Ui& ui);
  void drawRenderings(Ui& ui);
  bool dialogIsOpen() const;
  StatusModel statusToSay() const;
  SnapshotController::Sight sightNow() const {
    return {document_.fabric(),
            document_.cloth(),
            {draft_.view().back, viewport_.flatView(), document_.document().judgedUnder()},
            viewport_.tone(document_.fabric()->light)};
  }
  void tellProbe(Ui& ui);

  // session.cpp: what is done
  void readKeys();
  void follow(Ui& ui);
  void startOver(Document document);
  void applyPreset(const PresetChoice& choice);
  void dress(const Fabric& cloth);
  void look(const Camera& camera);
  void goTo(const EditPlace& place);

  // session_files.cpp: cloths from files and into them
  /// Goes on with it at once where nothing is unsaved; else asks first.
  void leaveFor(Errand next);
  void goOn();
  void answered(const QuestionController::Answer& answer);
  void openRecent(const std::string& file);
  void openPending();
  void remember(const std::string& file);
  void lookNextIn(const std::string& fileThere);
  void fileDone(FileService::Result result);
  void opened(FileService::Result result);
  void takeUp(Fabric fabric, const std::string& left);
  std::filesystem::path folderToLookIn() const;
  std::filesystem::path fileCalledAsCloth(const std::string& ending) const;
  std::filesystem::path startOf(FileTask task) const;
  void browse(FileTask task) { files_.browse(task, startOf(task)); }
  void fileChosen(const FileController::Chosen& chosen);
  void exportTo(FileTask task, const std::string& file);
  void printDraft(const std::string& file);
  void writeSheet(FileTask what, const std::string& file);

  Settings settings_;
  DocumentController document_;
  ViewportController viewport_;
  DraftController draft_;
  InspectorController inspector_;
  YarnColourService yarnColours_;
  SnapshotController snapshots_;
  PresetController presets_;
  TileController tile_;
  HandoverController handover_;
  ProfileController profiles_;
  FileController files_;
  QuestionController questions_;
  Errand errand_;               ///< goes on once the work is saved, or need not be
  bool recoveryIsDue_ = false;  ///< an offer is to be made
  PreferencesDialog preferences_;
  Help help_;
  WindowWish window_;
  double work_s_ = 0;
};

}  // namespace loomlight
