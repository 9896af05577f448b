#include "app/editor/editor.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "app/editor/sample_fabric.h"
#include "app/editor/session.h"
#include "app/editor/thread_clock.h"
#include "app/editor/user_folders.h"
#include "app/editor/widget_dump.h"
#include "app/editor/window.h"
#include "app/workers/file_name.h"
#include "core/fabric/fabric_json.h"

namespace loomlight {
namespace {

/// An event is drawn out over a few frames: ImGui answers a click a frame late, layout settles after it, and a dialog
/// that a key opens takes four until its text field listens.
constexpr int kFramesPerEvent = 6;
/// The longest sleep; what wakes the window otherwise is input or a worker.
constexpr double kLongestSleep_s = 5.0;

/// A weaving file or a picture is opened into the sample, by the session, which says what was wrong in it.
bool isFabric(const std::string& file) {
  return lowerExtension(file) == ".json";
}

Document firstDocument(const EditorOptions& options, bool isFirstStart) {
  if (!isFabric(options.fabricFile)) return Document(isFirstStart ? welcomeFabric() : sampleFabric());
  return Document(readFabric(options.fabricFile), options.fabricFile);
}

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// What those who watch the window are told of its frames: those that a person would notice, by the processor time of
/// the window's thread, and the longest.
class FrameWatch {
 public:
  void count(double seconds, WidgetProbe& probe) {
    constexpr double kNoticed_s = 0.033;
    slow_ += seconds > kNoticed_s;
    longest_s_ = std::max(longest_s_, seconds);
    probe.fact("slow_frames", std::to_string(slow_));
    probe.fact("longest_frame_ms", std::to_string(std::lround(1e3 * longest_s_)));
  }

 private:
  int slow_ = 0;
  double longest_s_ = 0;
};

/// Draws one frame; returns after how many seconds the next one is wanted without any event.
double drawFrame(Window& window, Session& session, WidgetProbe& probe, FieldMemory& memory, FrameWatch& watch) {
  const Theme theme = session.settings().darkTheme ? Theme::dark() : Theme::light();
  window.setTheme(theme);
  window.setInterfaceSize(session.settings().interfaceSize);
  window.beginFrame();
  probe.beginFrame();
  Ui ui{theme, window.fonts(), probe, memory, window.scale(), seconds()};
  const double before_s = threadSeconds();
  session.frame(ui);
  watch.count(threadSeconds() - before_s, probe);
  window.endFrame(theme);
  window.setTitle(session.title());
  return ui.wakeIn;
}

void runLoop(Window& window, Session& session, const std::string& dumpFile) {
  WidgetProbe probe(!dumpFile.empty());
  WidgetDump dump(dumpFile);
  FieldMemory memory;
  FrameWatch watch;
  int framesLeft = kFramesPerEvent;
  double wakeIn = 0;
  while (!session.isOver()) {
    const bool sleeps = framesLeft <= 0;
    const bool input = window.waitForEvents(sleeps ? std::min(wakeIn, kLongestSleep_s) : 0);
    framesLeft = input || sleeps ? kFramesPerEvent - 1 : framesLeft - 1;
    session.drop(window.takeDroppedFiles());
    if (window.closeWanted()) {
      window.refuseClose();
      session.askToQuit();
    }
    wakeIn = drawFrame(window, session, probe, memory, watch);
    window.setFullScreen(session.wantsFullScreen());
    if (probe.watching()) dump.write(probe.snapshot());
  }
}

}  // namespace

bool hasDisplay() {
  if (!glfwInit()) return false;
  glfwTerminate();
  return true;
}

int runEditor(const EditorOptions& options) {
  Settings settings = readSettings(settingsFile());
  Document document = firstDocument(options, !settings.hintsSeen);
  if (options.width > 0) settings.windowWidth = options.width;
  if (options.height > 0) settings.windowHeight = options.height;
  Window window("Loomlight", settings.windowWidth, settings.windowHeight, options.scale);
  Session session(std::move(document), settings, Window::wake, options.threads);
  session.offerRecovery();
  if (!options.fabricFile.empty() && !isFabric(options.fabricFile)) session.openFile(options.fabricFile);
  runLoop(window, session, options.widgetDump);
  session.close();
  Settings last = session.settings();
  last.windowWidth = static_cast<int>(window.sizeInWindow().x);
  last.windowHeight = static_cast<int>(window.sizeInWindow().y);
  writeSettings(settingsFile(), last);
  return 0;
}

}  // namespace loomlight
