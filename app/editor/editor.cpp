#include "app/editor/editor.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>

#include "app/editor/controllers/first_opening.h"
#include "app/editor/gl/opengl_driver.h"
#include "app/editor/gl/system_profile.h"
#include "app/editor/gl/window.h"
#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/thread_clock.h"
#include "app/editor/model/user_folders.h"
#include "app/editor/session.h"
#include "app/editor/widget_dump.h"
#include "app/export/file_name.h"
#include "core/base/error.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace {

/// An event is drawn out over a few frames: ImGui answers a click a frame late, layout settles after it, and a dialog
/// that a key opens takes four until its text field listens.
constexpr int kFramesPerEvent = 6;
/// From one frame to the next where the display does not set the pace.
constexpr std::chrono::microseconds kFrame{16'667};
/// The longest sleep; what wakes the window otherwise is input or a worker.
constexpr double kLongestSleep_s = 5.0;

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// What those who watch the window are told of its frames: the longest, by the processor time of the window's thread.
class FrameWatch {
 public:
  void count(double seconds, WidgetProbe& probe) {
    longest_s_ = std::max(longest_s_, seconds);
    probe.fact("longest_frame_ms", std::to_string(std::lround(1e3 * longest_s_)));
  }

 private:
  double longest_s_ = 0;
};

/// Draws frames one after the other while something happens, and none while nothing does. What is shown is the session,
/// or what comes before it.
class Frames {
 public:
  Frames(Window& window, const OpenGlDriver& driver, const std::string& dumpFile)
      : window_(window), driver_(driver), probe_(!dumpFile.empty()), dump_(dumpFile) {}

  template <class Shown>
  void runUntilOver(Shown& shown) {
    int framesLeft = kFramesPerEvent;
    double wakeIn = 0;
    while (!shown.isOver()) {
      const bool sleeps = framesLeft <= 0;
      if (!sleeps && !waitsForDisplay_) std::this_thread::sleep_until(began_ + kFrame);
      const bool input = window_.waitForEvents(sleeps ? std::min(wakeIn, kLongestSleep_s) : 0);
      framesLeft = input || sleeps ? kFramesPerEvent - 1 : framesLeft - 1;
      shown.drop(window_.takeDroppedFiles());
      if (window_.closeWanted()) {
        window_.refuseClose();
        shown.askToQuit();
      }
      wakeIn = draw(shown, framesLeft <= 0);
      window_.setFullScreen(shown.wantsFullScreen());
      if (probe_.watching()) dump_.write(probe_.snapshot());
    }
  }

 private:
  /// `lastOfEvent`: the window sleeps after this frame, unless it wants to be drawn again at once. Returns after how
  /// many seconds the next frame is wanted without any event.
  template <class Shown>
  double draw(Shown& shown, bool lastOfEvent) {
    const Theme theme = shown.settings().darkTheme ? Theme::dark() : Theme::light();
    window_.setTheme(theme);
    window_.setInterfaceSize(shown.settings().interfaceSize);
    window_.setDisplayCube(shown.displayCube());
    began_ = std::chrono::steady_clock::now();
    window_.beginFrame();
    probe_.beginFrame();
    probe_.fact("inputs", std::to_string(window_.inputCount()));
    probe_.fact("drawn_frames", std::to_string(window_.drawnCount()));
    Ui ui{theme, window_.fonts(), probe_, memory_, window_.scale(), seconds()};
    ui.pixels_per_mm = window_.pixels_per_mm();
    const double before_s = threadSeconds();
    shown.frame(ui);
    watch_.count(threadSeconds() - before_s, probe_);
    probe_.fact("sleeps_then", lastOfEvent && ui.wakeIn > 0 ? "yes" : "no");
    waitsForDisplay_ = window_.endFrame(theme, driver_.changes());
    window_.setTitle(shown.title());
    return ui.wakeIn;
  }

  Window& window_;
  const OpenGlDriver& driver_;  ///< of the pictures that are shown
  WidgetProbe probe_;
  WidgetDump dump_;
  FieldMemory memory_;
  FrameWatch watch_;
  std::chrono::steady_clock::time_point began_;  ///< when the last frame began
  bool waitsForDisplay_ = true;                  ///< the last frame was drawn, and waited for the display to show it
};

}  // namespace

int runEditor(const EditorOptions& options) {
  Settings settings = readSettings(settingsFile());
  Document document(welcomeFabric());
  if (options.width > 0) settings.windowWidth = options.width;
  if (options.height > 0) settings.windowHeight = options.height;
  Window window("Loomlight", settings.windowWidth, settings.windowHeight, options.scale);
  OpenGlDriver driver;
  Frames frames(window, driver, options.widgetDump);

  FileService firstFile(
      Window::wake);  // outlives the session: for a read that was given up nobody waits but at the end
  std::string problem;
  std::vector<WifWarning> warnings;
  std::vector<std::string> dropped;
  // A WIF draft or a picture is opened into the sample, by the session, which says what was wrong in it.
  if (isFabricFile(options.fabricFile)) {
    FirstOpening opening(firstFile, options.fabricFile, std::move(document), settings);
    frames.runUntilOver(opening);
    if (opening.quits()) return 0;
    document = opening.takeDocument();
    problem = opening.problem();
    warnings = opening.warnings();
    dropped = opening.dropped();
  }

  Session session(std::move(document), settings, driver, Window::wake, options.threads);
  session.startProfiles(systemDisplayProfile());
  session.offerRecovery();
  if (!problem.empty()) session.sayUnopened(problem);
  session.sayLooksOtherwise(options.fabricFile, warnings);
  if (!options.fabricFile.empty() && !isFabricFile(options.fabricFile)) session.openFile(options.fabricFile);
  session.drop(dropped);
  frames.runUntilOver(session);
  session.close();
  Settings last = session.settingsToKeep();
  last.windowWidth = static_cast<int>(window.sizeInWindow().x);
  last.windowHeight = static_cast<int>(window.sizeInWindow().y);
  try {
    writeSettings(settingsFile(), last);
  } catch (const InputError& error) {  // no reason to hold up the end of a session whose work is saved
    // fmt::print would throw where the log is on the same full disk.
    std::fputs(fmt::format(words::errors::settingsNotKept, error.what()).c_str(), stderr);
  }
  return 0;
}

}  // namespace loomlight
