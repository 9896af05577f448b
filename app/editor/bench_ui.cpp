#include "app/editor/bench_ui.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/editor/gl/opengl_driver.h"
#include "app/editor/gl/window.h"
#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/thread_clock.h"
#include "app/editor/session.h"
#include "core/base/quantile.h"
#include "core/base/stopwatch.h"
#include "core/fabric/weave/jacquard.h"

namespace loomlight {
namespace {

/// What a frame took, ms.
struct FrameTimes {
  double besides = 0;    ///< between the last one and this, and for the workers: all but drawing
  double panels = 0;     ///< what the panels show, as triangles
  double panelsCpu = 0;  ///< the same without what other threads and programs took of the processor
  double pixels = 0;     ///< OpenGL and the window system
};

/// Steps of twist, each of which has every brick of the warp made anew; to undo them is as heavy.
Document heavyDocument(int side, int edits) {
  Fabric fabric = sampleFabric();
  fabric.draft.reset();
  fabric.weave = damaskJacquard(side, side);
  fabric.drape.width_mm = side * fabric.warpPitch_mm();
  fabric.drape.height_mm = side * fabric.weftPitch_mm();
  Document document(fabric);
  for (int i = 1; i <= edits; ++i) {
    for (Yarn& yarn : fabric.yarns) yarn.plyTwist_per_m += 40;
    document.edit(fabric, static_cast<uint64_t>(i));
  }
  return document;
}

FrameTimes drawFrame(Window& window, Session& session, WidgetProbe& probe, FieldMemory& memory, Stopwatch& watch) {
  const Theme theme = Theme::dark();
  FrameTimes times;
  window.waitForEvents(0);
  times.besides = 1e3 * (watch.lap() + session.workSeconds());
  window.beginFrame();
  times.pixels = 1e3 * watch.lap();
  Ui ui{theme, window.fonts(), probe, memory, window.scale(), 0};
  const double cpuBefore_s = threadSeconds();
  session.frame(ui);
  times.panelsCpu = 1e3 * (threadSeconds() - cpuBefore_s);
  times.panels = 1e3 * (watch.lap() - session.workSeconds());
  window.drawAnew();  // each is measured as one that shows something new
  window.endFrame(theme, 0);
  times.pixels += 1e3 * watch.lap();
  return times;
}

struct Measure {
  const char *key, *name;
  double FrameTimes::* time;
};
constexpr Measure kMeasures[] = {{"besides_drawing_ms", "all but drawing", &FrameTimes::besides},
                                 {"panels_ms", "drawing: panels", &FrameTimes::panels},
                                 {"panels_cpu_ms", "the same, processor time", &FrameTimes::panelsCpu},
                                 {"pixels_ms", "drawing: OpenGL", &FrameTimes::pixels}};

}  // namespace

int runUiBench(const UiBenchOptions& options) {
  const int side = options.quick ? 200 : 4000, edits = options.quick ? 2 : 8;
  const double seconds = options.quick ? 0.3 : 3;
  constexpr size_t kFewestFrames = 8;  // of each edit, however slow the machine
  Window window("Loomlight", 1440, 900, 1);
  OpenGlDriver driver;
  Settings settings;
  settings.hintsSeen = true;
  Session session(heavyDocument(side, edits), settings, driver, Window::wake, options.threads);
  WidgetProbe probe(false);
  FieldMemory memory;
  std::vector<FrameTimes> frames;
  Stopwatch watch;
  drawFrame(window, session, probe, memory, watch);  // the first loads what all others have
  for (int i = 0; i <= edits; ++i) {
    if (i > 0) session.run(Command::undo);
    const size_t before = frames.size();
    for (double spent_s = 0; spent_s < seconds || frames.size() < before + kFewestFrames;) {
      frames.push_back(drawFrame(window, session, probe, memory, watch));
      const FrameTimes& times = frames.back();
      spent_s += 1e-3 * (times.besides + times.panels + times.pixels);
    }
  }
  session.close();
  nlohmann::ordered_json json;
  json["crossings"] = fmt::format("{0} x {0}", side);
  json["frames"] = frames.size();
  std::string table =
      fmt::format("| {0} x {0} crossings, {1} frames | median, ms | 99 %, ms | longest, ms |\n", side, frames.size()) +
      "|---|---:|---:|---:|\n";
  for (const Measure& measure : kMeasures) {
    std::vector<double> values;
    for (const FrameTimes& times : frames) values.push_back(times.*measure.time);
    const double median = quantile(values, 0.5), most = quantile(values, 0.99), longest = quantile(values, 1);
    json[measure.key] = {{"median", median}, {"p99", most}, {"longest", longest}};
    table += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} |\n", measure.name, median, most, longest);
  }
  fmt::print("{}", options.json ? json.dump(2) + "\n" : table);
  return 0;
}

}  // namespace loomlight
