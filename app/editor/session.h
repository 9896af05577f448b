#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/controllers/colour_desk.h"
#include "app/editor/controllers/file_desk.h"
#include "app/editor/controllers/file_preview_desk.h"
#include "app/editor/controllers/picture_desk.h"
#include "app/editor/controllers/preset_desk.h"
#include "app/editor/controllers/render_desk.h"
#include "app/editor/controllers/side_pictures.h"
#include "app/editor/controllers/snapshot_shelf.h"
#include "app/editor/controllers/view_desk.h"
#include "app/editor/model/autosave.h"
#include "app/editor/model/document.h"
#include "app/editor/model/settings.h"
#include "app/export/snapshot.h"
#include "ui/dialogs/busy_dialog.h"
#include "ui/dialogs/colourways_dialog.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/file_browser.h"
#include "ui/dialogs/keys_dialog.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/preset_browser.h"
#include "ui/dialogs/structure_dialog.h"
#include "ui/dialogs/tile_dialog.h"
#include "ui/dialogs/wif_dialog.h"
#include "ui/draft/draft_commands.h"
#include "ui/first_hints.h"
#include "ui/inspector/inspector.h"
#include "ui/status_bar.h"
#include "ui/viewport/viewport_panel.h"
#include "ui/widgets/commands.h"
#include "ui/widgets/preset_list.h"

namespace loomlight {

/// One designer at work: the document, the workers that follow it, and what each panel remembers. Draws a frame at a
/// time, in the window's thread, and waits for nobody.
class Session {
 public:
  /// `driver` keeps the pictures that are shown, and outlives the session. `wake` brings the window to draw again;
  /// called from the workers. `threads`: for tracing; 0 leaves one hardware thread to the window.
  Session(Document document, Settings settings, DisplayDriver& driver, std::function<void()> wake, int threads);

  void frame(Ui& ui);
  /// Of the last frame, spent on all but drawing: taking what workers have brought, and telling them what to do next.
  double workSeconds() const { return work_s_; }
  void run(Command command);
  void run(DraftCommand command);
  /// Opens a fabric, or uses a mesh or an environment, by what the file is.
  void openFile(const std::string& file);
  /// The same for files dropped on the window, each once no dialog is open: an answer is for what it was asked about.
  void drop(const std::vector<std::string>& files);
  /// Says why a file could not be opened.
  void sayUnopened(const std::string& problem);
  /// Asks about unsaved work first, once.
  void askToQuit();
  /// Offers what an editor that did not end well has left behind, once no dialog is in the way.
  void offerRecovery() { recoveryDue_ = true; }

  bool isOver() const { return over_; }
  /// The end has come as it should: nothing is left to be taken up again.
  void close() { autosave_.endWell(); }
  bool wantsFullScreen() const { return fullScreen_; }
  const Settings& settings() const { return settings_; }
  Settings& settings() { return settings_; }
  std::string title() const;

 private:
  enum class FileTask {
    none,
    open,
    saveAs,
    mesh,
    environment,
    snapshot,
    exportWif,
    exportBitmap,
    exportDraft,
    exportTile,
    picture
  };
  enum class Question { none, said, unsaved, forgetRecent, recover };
  /// What unsaved work stands in the way of.
  enum class Afterwards { nothing, quit, beginAnew, open, takeUp };

  /// Of which a picture joins the strip as soon as there is one, and is renewed while it gets better.
  struct ViewToKeep {
    std::shared_ptr<const Fabric> fabric;  ///< usually null
    Tone tone;                             ///< as it was seen
    std::string id;                        ///< on the shelf; empty until it is there
    int samples = 0;                       ///< of the picture there
  };

  // session_panels.cpp: what is drawn
  void drawPanels(Ui& ui);
  void keepSettings();
  void drawDraft(Ui& ui);
  void drawViewport(Ui& ui, const Insight* insight, const LiveStatus& status);
  void drawInspector(Ui& ui, const Insight* insight, const LiveStatus& status);
  StatusModel statusToSay(const Insight* insight, const LiveStatus& status) const;
  LensModel lensModelFor(const LensStatus& status);
  void lookUnderPointer();
  void tellProbe(Ui& ui, const LiveStatus& status) const;

  // session_commands.cpp: what is done
  void readKeys();
  void edit(Fabric fabric);
  void drawDialogs(Ui& ui);
  void answered(int answer);
  void startOver(Document document);
  /// Goes on with it at once where nothing is unsaved; else asks first.
  void leaveFor(Afterwards next);
  void goOn();
  /// `safe`: the answer that loses nothing, which Enter gives.
  void ask(Question question, std::string title, std::string text, std::vector<std::string> answers, int safe);
  void say(std::string title, std::string text);
  bool dialogIsOpen() const;
  Tone tone() const;

  // session_files.cpp: cloths from files and into them
  void lookNextIn(const std::string& fileThere);
  void remember(const std::string& file);
  void openRecent(const std::string& file);
  void openFabric(const std::string& file);
  void save(const std::string& file);
  void openDropped();
  void askForRecovery();
  void takeUp(Fabric fabric, const std::string& left);
  void drawBusy(Ui& ui);
  void fileDone(FileDesk::Result result);
  std::filesystem::path folderToLookIn() const;
  std::filesystem::path fileCalledAsCloth(const std::string& ending) const;
  void browse(FileTask task);
  void fileChosen(const std::string& file);

  // draft_files.cpp: drafts and weaves from files and into them
  void weavingOpened(Fabric fabric, const std::string& file, std::vector<WifWarning> warnings);
  void openPicture(const std::string& file);
  void drawPicture(Ui& ui);
  void exportTo(FileTask task, const std::string& file);
  void drawDraftDialogs(Ui& ui);
  void drawStructures(Ui& ui);
  void drawTile(Ui& ui);
  void takeWeave(Rewoven result);
  EditPlace placeInDraft() const;
  EditPlace placeInInspector() const;
  void goTo(const EditPlace& place);

  // session_presets.cpp: what is kept at hand
  void drawPresets(Ui& ui);
  void changePresets(const PresetBrowserEdit& change);
  void applyPreset(const PresetChoice& choice);
  void dress(const Fabric& cloth);
  void hearOfPresets();

  // session_snapshots.cpp: views that are kept
  void keepView();
  void followViewToKeep();
  SnapshotPrint printOfSnapshot() const;
  void drawSnapshot(Ui& ui);
  void drawStrip(Ui& ui);
  void restoreView(size_t index);

  // session_workers.cpp: what the workers are asked for
  void follow();
  Sight sight() const;
  void keepCopy();
  void followColour();

  Settings settings_;
  Document document_;
  std::function<void()> wake_;
  std::vector<std::string> sampleNames_;
  Autosave autosave_;
  ColourDesk colours_;
  SidePictures sidePictures_;
  SnapshotShelf shelf_;
  PresetDesk presetDesk_;
  ViewDesk views_;
  RenderDesk snapshot_, tile_;
  FileDesk files_;

  DraftView draft_;
  ViewportView viewport_;
  InspectorView inspector_;
  FileBrowser browser_;
  FilePreviewDesk previews_;
  BusyDialog busyDialog_;
  MessageDialog message_;
  SnapshotDialog snapshotDialog_;
  PreferencesDialog preferences_;
  KeysDialog keys_;
  ColourwaysDialog colourways_;
  CompareDialog compare_;
  PresetBrowser presetBrowser_;
  std::string presetProblem_;  ///< why the last change of presets was not made
  SnapshotStripView strip_;
  FirstHints hints_;
  StructureDialog structures_;
  PictureDialog pictureDialog_;
  PictureDesk pictures_;
  TileDialog tileDialog_;
  WifDialog wifDialog_;
  std::shared_ptr<const Fabric> wifKept_;  ///< the weaving file's cloth with the designer's own sizes

  FileTask fileTask_ = FileTask::none;
  Question question_ = Question::none;
  std::string pendingFile_;          ///< to be opened once the user has agreed
  std::string leftBehind_;           ///< the copy of unsaved work that was found, and is asked about or taken up
  std::deque<std::string> dropped_;  ///< files that wait until no dialog is open
  EditPlace place_;                  ///< where edits are made now
  std::string refusal_;              ///< why the last edit was not taken
  ViewToKeep viewToKeep_;
  std::optional<CrossingIndex> underPointer_;  ///< the crossing of the cloth under the mouse
  std::string underPointerYarn_;
  uint64_t keptRevision_ = 0;  ///< of the document, last handed to autosave
  uint64_t gesture_ = 1;
  double work_s_ = 0;
  uint64_t colourWish_ = 0, colourGesture_ = 0;  ///< the newest wish for a colour, and the gesture that made it
  Afterwards afterwards_ = Afterwards::nothing;  ///< once the work is saved, or need not be
  bool recoveryDue_ = false;                     ///< an offer is to be made
  bool over_ = false, fullScreen_ = false;
};

}  // namespace loomlight
