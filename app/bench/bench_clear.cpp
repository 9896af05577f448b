#include "app/bench/bench_clear.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bench/bench_targets.h"
#include "app/bench/clear_drag.h"
#include "app/bench/clear_settings.h"
#include "app/bench/machine_facts.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/interrupt.h"
#include "core/base/error.h"
#include "core/fabric/model/validate.h"
#include "render/display/display_picture.h"

namespace loomlight {
namespace {

using Row = std::vector<std::string>;

/// What is looked at: an edit of a cloth, with light shared between repeats or not.
struct ClearCase {
  const ClearSetting& setting;
  const ClearEdit& edit;
  bool shared;

  /// The first columns of its rows.
  Row columns() const { return {setting.cloth, setting.drape, setting.light, edit.name, shared ? "yes" : "no"}; }
};

struct ClearExtent {
  int width, height;
  uint32_t referenceSamples;
  double seconds;
};
constexpr ClearExtent kFullClear{640, 400, 1024, 12};
constexpr ClearExtent kQuickClear{160, 100, 64, 2};

const std::vector<double> kTimes_s{0.3, 1, 3, 10};
constexpr double kClear[] = {0.10, 0.05, 0.03};
constexpr double kDragInterval_s = 0.05;

void expectKnown(const std::vector<std::string>& names) {
  const std::vector<std::string> known = clearNames();
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(fmt::format("--only: expected some of {}, got '{}'", fmt::join(known, ", "), name));
}

std::string secondsText(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.2f}", seconds) : "-";
}

/// Of a figure of many pictures: NaN where there is none.
class OverPictures {
 public:
  void add(double value) {
    sum_ += value;
    worst_ = count_++ > 0 ? std::max(worst_, value) : value;
  }
  double mean() const { return sum_ / count_; }
  double worst() const { return worst_; }

 private:
  double sum_ = 0, worst_ = std::numeric_limits<double>::quiet_NaN();
  int count_ = 0;
};

/// How clear a picture must be how soon, of those that share their light, as the editor's do.
class ClearTargets {
 public:
  /// Of a picture that was looked at for `watched_s`: what it was like later, nobody knows.
  void add(const ClearCase& of, const ClearCourse& course, double watched_s) {
    if (!of.shared) return;
    const bool isPlain = of.setting.drape == "flat" || of.setting.drape == "cylinder";
    const double time_s = isPlain ? kPlain_s : kFolded_s;
    if (time_s <= watched_s) (isPlain ? plain_ : folded_).add(course.at(time_s));
    stepBack_.add(course.worstStepBack());
  }
  void addDrag(const ClearCase& of, const DragCourse& course) {
    if (of.shared && course.pictures > 0) drag_.add(course.worstFlip);
  }

  std::vector<Target> all() const {
    using Kind = Target::Kind;
    const auto flip = [](std::string what, double atLeast, double aim, double ours) {
      return Target{std::move(what), "", "", Kind::flip, atLeast, aim, ours};
    };
    const std::string plain = fmt::format("flat and cylinder after {} s: FLIP", kPlain_s),
                      folded = fmt::format("folds and skirts after {} s: FLIP", kFolded_s);
    return {flip(plain + ", mean", 0.05, 0.03, plain_.mean()),
            flip(plain + ", worst", 0.05, 0.03, plain_.worst()),
            flip(folded + ", mean", 0.05, 0.03, folded_.mean()),
            flip(folded + ", worst", 0.05, 0.03, folded_.worst()),
            flip("in a drag: FLIP, worst", 0.15, 0.10, drag_.worst()),
            {"worst step back", "", "", Kind::stepBack, 1.1, 1, stepBack_.worst()}};
  }

 private:
  static constexpr double kPlain_s = 1, kFolded_s = 3;
  OverPictures plain_, folded_, drag_, stepBack_;
};

static_assert(ClearBenchCommand::kLeastSide >= kLeastClearSide_px);

class ClearBench {
 public:
  ClearBench(const ClearBenchCommand& command, Task task)
      : command_(command),
        extent_(command.quick ? kQuickClear : kFullClear),
        task_(std::move(task)),
        page_(command.folder, "clear", "From an edit to a clear picture") {
    if (command.width > 0) {
      extent_.width = command.width;
      extent_.height = command.height;
    }
    if (command.seconds > 0) extent_.seconds = command.seconds;
    if (command.referenceSamples > 0) extent_.referenceSamples = static_cast<uint32_t>(command.referenceSamples);
  }

  /// False when stopped.
  bool run() {
    const ClearChoice choice{command_.only};
    for (const ClearSetting& setting : clearSettings(choice, command_.quick))
      if (!study(setting, clearEdits(choice))) return false;
    return true;
  }

  std::string finish() {
    page_.paragraph(fmt::format(
        "Pictures of {} x {}, each looked at after an edit of one that is clear: for {} s, and until the first of "
        "them. FLIP is the mean over nine windows, a twentieth of the picture each way, of what the display shows, "
        "against {} samples of another seed. That of the reference is how far these are themselves from what they "
        "converge to, by chance: the picture of the latter would be as far from them. A step back is how much worse "
        "than the best before it a picture was, at worst.",
        extent_.width, extent_.height, extent_.seconds, extent_.referenceSamples));
    Row header{"cloth", "drape", "light", "edit", "light shared", "first picture, s", "its FLIP"};
    for (const double time_s : kTimes_s) header.push_back(fmt::format("FLIP after {} s", time_s));
    header.push_back("FLIP of the reference");
    for (const double flip : kClear) header.push_back(fmt::format("s to {:.2f}", flip));
    header.insert(header.end(), {"worst step back", "samples at the end"});
    page_.table("clear", header, rows_);
    if (!drags_.empty()) {
      page_.paragraph(fmt::format(
          "While somebody drags, a step each {} s: pictures that were shown, each against the view that it is of.",
          kDragInterval_s));
      page_.table("drag",
                  {"cloth", "drape", "light", "edit", "light shared", "pictures", "s between them", "FLIP, mean",
                   "FLIP, worst"},
                  drags_);
    }
    addTargets(page_, "clear_targets", targets_.all());
    page_.csv("clear_course", {"cloth", "drape", "light", "edit", "light shared", "s", "samples", "FLIP"}, courses_);
    page_.paragraph(
        fmt::format("Measured on {}", machineFacts(command_.threads > 0 ? command_.threads : task_.threads)));
    return page_.finish();
  }

 private:
  bool study(const ClearSetting& setting, const std::vector<ClearEdit>& edits) {
    for (const ClearEdit& edit : edits) {
      const std::vector<Fabric> steps = edit.steps(setting.fabric);
      const Fabric& edited = steps.back();
      validate(edited, edit.name);
      const ClearReference reference(edited, references(extent_.referenceSamples), task_);
      if (task_.stopped()) return false;
      const double referenceNoise = reference.noise(task_.threads);
      for (const bool shared : {false, true}) {
        using Sharing = ClearBenchCommand::Sharing;
        if (command_.sharing == (shared ? Sharing::off : Sharing::on)) continue;
        if (!measure({setting, edit, shared}, steps, reference, referenceNoise)) return false;
      }
    }
    return true;
  }

  ClearReferenceTask references(uint32_t samples) const {
    return {extent_.width, extent_.height, samples, command_.folder + "/references"};
  }

  bool measure(const ClearCase& of, const std::vector<Fabric>& steps, const ClearReference& reference,
               double referenceNoise) {
    LiveClock clock(extent_.width, extent_.height, command_.threads);
    clock.shareLight(of.shared);
    const auto nothing = [](const std::shared_ptr<const Frame>&, double) {};
    if (of.edit.name != "open" && !clock.watch(of.setting.fabric, extent_.seconds, nothing, task_.stop)) return false;
    const std::span dragged(steps.data(), steps.size() - 1);
    const std::vector<DragPicture> inDrag = watchDrag(clock, dragged, kDragInterval_s, reference, task_.stop);
    std::vector<std::shared_ptr<const Frame>> pictures;
    const ClearCourse course = watchClear(clock, steps.back(), reference, extent_.seconds, kTimes_s,
                                          command_.pictures ? &pictures : nullptr, task_);
    if (task_.stopped()) return false;
    add(of, course, referenceNoise);
    if (!dragged.empty()) {
      clock.pause(true);
      addDrag(of, courseOf(inDrag, dragged, references(extent_.referenceSamples / 8), task_));
      if (task_.stopped()) return false;
    }
    for (size_t i = 0; i < pictures.size(); ++i)
      if (pictures[i]) addPicture(of, kTimes_s[i], *pictures[i]);
    fmt::print(stderr, "loomlight: {}, {}, light {}: {:.3f} after 1 s\n", of.setting.name(), of.edit.name,
               of.shared ? "shared" : "not shared", course.at(1));
    return true;
  }

  void add(const ClearCase& of, const ClearCourse& course, double referenceNoise) {
    targets_.add(of, course, extent_.seconds);
    Row row = of.columns();
    row.push_back(course.points.empty() ? "-" : secondsText(course.points.front().since_s));
    row.push_back(fmt::format("{:.3f}", course.first()));
    for (const double time_s : kTimes_s) {
      const bool isShown = !course.points.empty() && course.points.front().since_s <= time_s;
      row.push_back(isShown && time_s <= extent_.seconds ? fmt::format("{:.3f}", course.at(time_s)) : "-");
    }
    row.push_back(fmt::format("{:.3f}", referenceNoise));
    for (const double flip : kClear) row.push_back(secondsText(course.timeTo(flip)));
    row.push_back(fmt::format("{:.2f}", course.worstStepBack()));
    row.push_back(course.points.empty() ? "0" : std::to_string(course.points.back().samples));
    rows_.push_back(std::move(row));
    for (const ClearCourse::Point& point : course.points) {
      Row one = of.columns();
      one.insert(one.end(), {fmt::format("{:.3f}", point.since_s), std::to_string(point.samples),
                             fmt::format("{:.4f}", point.flip)});
      courses_.push_back(std::move(one));
    }
  }

  void addDrag(const ClearCase& of, const DragCourse& course) {
    targets_.addDrag(of, course);
    Row& row = drags_.emplace_back(of.columns());
    row.insert(row.end(), {std::to_string(course.pictures), fmt::format("{:.3f}", course.interval_s),
                           fmt::format("{:.3f}", course.flip), fmt::format("{:.3f}", course.worstFlip)});
  }

  void addPicture(const ClearCase& of, double time_s, const Frame& frame) {
    Frame shown = frame;
    shown.rgba.assign(frame.shown().begin(), frame.shown().end());
    const auto& [cloth, drape, light, fabric] = of.setting;
    const std::string name =
        fmt::format("{}_{}_{}_{}_{}_{}", cloth, drape, light, of.edit.name, of.shared ? "shared" : "plain", time_s);
    const Pixels8 pixels = displayPicture(shown, Tone{});
    page_.picture(name, frame.divider > 1 ? magnified(pixels, frame.divider) : pixels,
                  fmt::format("{}, {} after {} s, light {}", of.setting.name(), of.edit.name, time_s,
                              of.shared ? "shared" : "not shared"));
  }

  const ClearBenchCommand& command_;
  ClearExtent extent_;
  Task task_;
  ReportPage page_;
  std::vector<Row> rows_, drags_, courses_;
  ClearTargets targets_;
};

}  // namespace

int run(const ClearBenchCommand& command) {
  expectKnown(command.only);
  const Interrupt interrupt;
  ClearBench bench(command, interrupt.task(0));
  if (!bench.run()) return Interrupt::kExitStatus;
  fmt::print("{}\n", bench.finish());
  return 0;
}

}  // namespace loomlight
