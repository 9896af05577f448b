#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/session.h"
#include "tests/headless/editor/headless_input.h"
#include "tests/support/memory_driver.h"
#include "tests/support/wakes.h"

namespace loomlight {

/// The whole editor without a window: its session with all workers, in a home of its own, drawn by Dear ImGui into
/// memory and driven by mouse and keys. Widgets and facts are those that tests of the real window see
/// (--widget-dump), by the same names.
///
/// Nothing here leans on time: clicks and keys are held for frames, time goes by with frames and sleeps, and whoever
/// waits is woken by the workers. What does not come about throws Vain, with what the editor says of itself.
class HeadlessEditor {
 public:
  struct Vain : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  struct Screen {
    int width = 1280, height = 720;
    float scale = 1;
    int samples = 1;  ///< a pixel at which the picture rests, soon, as the processors are for other tests too
  };
  HeadlessEditor() : HeadlessEditor(Screen{}) {}
  explicit HeadlessEditor(Screen screen);
  ~HeadlessEditor();
  HeadlessEditor(const HeadlessEditor&) = delete;
  HeadlessEditor& operator=(const HeadlessEditor&) = delete;

  /// A folder of this editor alone, gone with it.
  const std::filesystem::path& home() const { return home_; }
  std::string homeFile(const std::string& name) const { return (home_ / name).string(); }
  /// Begins on the cloth, which is written to its file first. Returns the file.
  std::string start(const Fabric& cloth, const std::string& name = "cloth.json");
  /// Begins on a cloth that has no file yet.
  void startWithoutFile(Fabric cloth);
  /// Begins again on a file, with the settings that leave() has kept.
  void startOn(const std::string& file);
  /// With which it begins the next time.
  Settings& settings() { return settings_; }
  /// As if it had been killed: what was kept of unsaved work is left behind.
  void crash();
  /// The button of the window; the session may ask.
  void closeWindow();
  /// Ctrl+Q, without saving; the settings are kept for the next start.
  void leave();
  /// Whether the session has ended, as after Ctrl+Q and what it asks.
  bool isOver() const { return session_->isOver(); }

  // What there is to see.
  using Rect = WidgetProbe::Rect;
  bool shows(const std::string& widget) const { return snapshot().widgets.count(widget) > 0; }
  Rect rect(const std::string& widget) const;
  std::string fact(const std::string& name) const;
  uint64_t number(const std::string& name) const;
  const WidgetProbe::Snapshot& snapshot() const { return probe_.snapshot(); }
  ImVec2 screen() const { return ImVec2(static_cast<float>(screen_.width), static_cast<float>(screen_.height)); }
  /// A picture on the screen, and as much of its place as is not cut off.
  struct Drawn {
    const Pixels8* picture = nullptr;
    Rect place;
  };
  /// The driver's pictures that are drawn within the widget, the topmost last.
  std::vector<Drawn> drawnIn(const std::string& widget) const;
  /// The topmost of them; null where there is none.
  const Pixels8* pictureIn(const std::string& widget) const;

  // What is done.
  int actions() const { return input_.actions().count(); }  ///< so far, as designers would count them
  void frame();
  /// Draws and waits for the workers until it is so.
  void until(const std::string& what, const std::function<bool()>& condition);
  void untilNoDialogIsOpen() {
    until("no dialog is open", [this] { return fact("dialog") == "none"; });
  }
  /// Acts, and waits until the fabric is another one.
  void edits(const std::string& what, const std::function<void()>& act);
  /// The first one of the draft: so there is unsaved work.
  void turnACrossing() {
    click("draft.cell_0_0");
    until("the cloth is edited", [this] { return fact("dirty") == "yes"; });
  }
  /// Until the picture of the fabric as it is now is shown.
  void untilPictured();
  /// Its middle, once it has come to rest.
  ImVec2 centre(const std::string& widget);
  void move(ImVec2 place);
  void press(int button = 0);
  void release(int button = 0);
  void click(const std::string& widget, int button = 0) { clickAt(centre(widget), button); }
  void clickAt(ImVec2 place, int button = 0);
  void drag(ImVec2 start, ImVec2 end, int button = 0, int steps = 6);
  void dragWidget(const std::string& widget, float dx, float dy = 0);
  void wheelAt(ImVec2 place, float clicks);
  void hold(const std::string& key);
  void let(const std::string& key);
  /// "ctrl+shift+s": each is pressed in turn, and let go.
  void key(const std::string& combination);
  /// A key whose letter no keyboard is asked for: "?".
  void character(const std::string& utf8);
  /// Into the field that listens.
  void type(const std::string& text);
  /// Clicks the field, replaces its text and presses Return.
  void enter(const std::string& field, const std::string& text);
  /// Of a list: clicks it, then the choice.
  void choose(const std::string& list, const std::string& choice);
  /// A file is dropped on the window.
  void drop(const std::string& file);
  void nameFile(const std::string& file);  ///< in the file browser
  void answer(int index = 0);              ///< of a message that is up or comes
  /// The cloth that Ctrl+S saves in the file it has.
  Fabric saved();
  /// The cloth that is saved under that name.
  Fabric savedAs(const std::string& file);

 private:
  void frameOf(float length_s);
  void begin(Document document);
  void untilDrawn();
  void settle();
  void pause();
  std::string plight() const;

  std::filesystem::path home_;
  Screen screen_;
  ImGuiContext* context_;
  HeadlessInput input_;
  float shownScale_ = 0;
  Fonts fonts_;
  Theme theme_ = Theme::dark();
  MemoryDriver driver_;
  Wakes wakes_;
  WidgetProbe probe_{true};
  FieldMemory memory_;
  Settings settings_;
  double time_s_ = 0;
  double wakeIn_s_ = 0;
  std::unique_ptr<Session> session_;
};

/// Mean and standard deviation of all samples, 0..1.
struct PictureSpread {
  double mean = 0, deviation = 0;
};
PictureSpread spreadOf(const Pixels8& picture);

}  // namespace loomlight
