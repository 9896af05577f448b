#include "app/bench/bench_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/bench/bench_targets.h"
#include "app/bench/edit_script.h"
#include "app/bench/live_clock.h"
#include "app/bench/machine_facts.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/validate.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

/// What one way to make a kind of edit took, over all rounds.
struct Transitions {
  std::vector<double> build_s, volume_s, coarse_s, sample_s;
  uint64_t mostBricks = 0;

  void add(const LiveTimes& times) {
    if (times.build_s > 0) build_s.push_back(times.build_s);
    volume_s.push_back(times.volume_s);
    coarse_s.push_back(times.coarse_s);
    if (times.sample_s > 0) sample_s.push_back(times.sample_s);
    mostBricks = std::max(mostBricks, times.bricks);
  }
};

struct EditResult {
  EditKind kind;
  Transitions made, undone, redone;
  double full_s = 0;     ///< a scene of the edited fabric made of nothing
  double alone_s = 0;    ///< the same made of the scene before, median; nobody traces beside either
  size_t allBricks = 0;  ///< of its volume
};

struct ClothResult {
  std::string name;
  Fabric fabric;
  VolumeCounts counts;
  double opened_s = 0;  ///< to the first picture
  std::vector<EditResult> edits;
  std::vector<double> strokeWaits_s;
  uint64_t strokeBricks = 0;
};

/// What all measurements have in common.
struct Bench {
  bool quick = false;
  int threads = 1;
  std::stop_token stop;

  int rounds() const { return quick ? 1 : 20; }
  int strokeLength() const { return quick ? 20 : 100; }
  int width() const { return quick ? 64 : 640; }
  int height() const { return quick ? 48 : 400; }
};

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}
double slowest(const std::vector<double>& values) {
  return quantile(values, 0.95);
}

/// The scene of the edited fabric and its medium of nothing; and of the scene before. False when stopped.
bool buildAlone(const Scene& before, const Fabric& fabric, const Bench& bench, EditResult& result) {
  Task task;
  task.stop = bench.stop;
  task.threads = bench.threads;
  const auto after = std::make_shared<const Fabric>(fabric);
  const auto seconds = [&](const Scene* previous) {
    Stopwatch watch;
    const auto scene = makeScene(after, task, previous);
    if (!scene || !makeMedium(*scene, defaultMemoryLimit_bytes(), task)) return 0.0;
    const double spent = watch.lap();
    if (!previous) result.allBricks = scene->cloth->volume->counts().bricks;
    return spent;
  };
  result.full_s = seconds(nullptr);
  std::vector<double> alone_s;
  for (int round = 0; round < bench.rounds(); ++round) alone_s.push_back(seconds(&before));
  result.alone_s = median(alone_s);
  return !bench.stop.stop_requested();
}

bool measure(LiveClock& clock, const Fabric& fabric, bool wholeSample, const Bench& bench, Transitions& transitions) {
  const auto times = clock.show(fabric, wholeSample, bench.stop);
  if (times) transitions.add(*times);
  return times.has_value();
}

/// The edit, undone, done again, and undone for the next kind.
bool measure(LiveClock& clock, const Fabric& before, int round, const Bench& bench, EditResult& result) {
  const Fabric after = result.kind.apply(before, round);
  validate(after, result.kind.name);
  const bool wholeSample = round == 0;  // it takes as long as all the rest
  return measure(clock, after, wholeSample, bench, result.made) &&
         measure(clock, before, false, bench, result.undone) && measure(clock, after, false, bench, result.redone) &&
         measure(clock, before, false, bench, result.undone);
}

bool measureFullBuilds(LiveClock& clock, const Bench& bench, ClothResult& result) {
  clock.pause(true);
  Task task;
  task.stop = bench.stop;
  task.threads = bench.threads;
  const auto before = makeScene(std::make_shared<const Fabric>(result.fabric), task);
  if (!before) return false;
  for (EditResult& edit : result.edits)
    if (!buildAlone(*before, edit.kind.apply(result.fabric, 0), bench, edit)) return false;
  clock.pause(false);
  return true;
}

std::optional<ClothResult> study(const EditedCloth& cloth, const Bench& bench) {
  constexpr double kEventInterval_s = 1.0 / 60;
  ClothResult result;
  result.name = cloth.name;
  result.fabric = cloth.fabric;
  LiveClock clock(bench.width(), bench.height(), bench.threads);
  const auto opened = clock.show(cloth.fabric, true, bench.stop);
  if (!opened) return std::nullopt;
  result.opened_s = opened->coarse_s;
  result.counts = clock.status().counts;
  for (EditKind& kind : editKinds()) {
    fmt::print(stderr, "loomlight: {}: {}\n", cloth.name, kind.name);
    EditResult& edit = result.edits.emplace_back();
    edit.kind = std::move(kind);
    for (int round = 0; round < bench.rounds(); ++round)
      if (!measure(clock, cloth.fabric, round, bench, edit)) return std::nullopt;
  }
  fmt::print(stderr, "loomlight: {}: a stroke\n", cloth.name);
  const uint64_t bricksBefore = clock.status().bricksVoxelised;
  result.strokeWaits_s = clock.play(stroke(cloth.fabric, bench.strokeLength()), kEventInterval_s, bench.stop);
  if (result.strokeWaits_s.empty()) return std::nullopt;
  result.strokeBricks = clock.status().bricksVoxelised - bricksBefore;
  fmt::print(stderr, "loomlight: {}: the same edits in full\n", cloth.name);
  if (!measureFullBuilds(clock, bench, result)) return std::nullopt;
  return result;
}

std::string milliseconds(double seconds) {
  return fmt::format("{:.{}f}", 1e3 * seconds, seconds < 1e-2 ? 2 : seconds < 0.1 ? 1 : 0);
}
/// Median and 95th percentile.
std::string spread(const std::vector<double>& seconds) {
  return fmt::format("{} ({})", milliseconds(median(seconds)), milliseconds(slowest(seconds)));
}
/// Both alone; 0 of edits that build nothing.
double fullOverEdit(const EditResult& edit) {
  return edit.made.build_s.empty() ? 0 : edit.full_s / edit.alone_s;
}

void addCloth(ReportPage& page, const ClothResult& result) {
  page.heading(
      fmt::format("{} x {} crossings: {}", result.fabric.weave.ends(), result.fabric.weave.picks(), result.name));
  page.paragraph(fmt::format("{} bricks, {:.2f} MB; {} ms from opening it to the first picture.", result.counts.bricks,
                             static_cast<double>(result.counts.bytes) / 1e6, milliseconds(result.opened_s)));
  std::vector<std::vector<std::string>> rows;
  for (const EditResult& edit : result.edits)
    rows.push_back(
        {edit.kind.name, std::to_string(edit.made.mostBricks), spread(edit.made.volume_s), spread(edit.made.coarse_s),
         milliseconds(median(edit.made.sample_s)), std::to_string(edit.undone.mostBricks), spread(edit.undone.coarse_s),
         std::to_string(edit.redone.mostBricks), spread(edit.redone.coarse_s), std::to_string(edit.allBricks),
         milliseconds(edit.full_s), fmt::format("{:.3f}", 1e3 * edit.alone_s), ratioText(fullOverEdit(edit))});
  page.table("edit_" + result.name,
             {"edit", "bricks voxelised", "volume, ms", "first picture, ms", "one sample, ms", "undo: bricks",
              "undo: first picture, ms", "redo: bricks", "redo: first picture, ms", "full build: bricks",
              "full build, ms", "the edit alone, ms", "full : edit"},
             rows);
  page.paragraph(fmt::format("A stroke of {} crossings, 60 a second: {} ms from crossing to picture, {} bricks.",
                             result.strokeWaits_s.size(), spread(result.strokeWaits_s), result.strokeBricks));
}

/// What holds over all cloths.
struct Worst {
  uint64_t crossing = 0, optics = 0, undo = 0;  ///< bricks
  double coarse_s = 0, stroke_s = 0;            ///< 95th percentile, of the slowest kind on the slowest cloth
  double paintRatio = 0;                        ///< on the jacquard of 1000 x 1000, or what stands for it
};

Worst worstOf(const std::vector<ClothResult>& results) {
  constexpr size_t kJacquard = 2;
  Worst worst;
  for (const ClothResult& result : results) {
    worst.stroke_s = std::max(worst.stroke_s, slowest(result.strokeWaits_s));
    for (const EditResult& edit : result.edits) {
      worst.undo = std::max({worst.undo, edit.undone.mostBricks, edit.redone.mostBricks});
      const auto kind = edit.kind.voxelises;
      if (kind == EditKind::Voxelises::crossing) worst.crossing = std::max(worst.crossing, edit.made.mostBricks);
      if (kind == EditKind::Voxelises::nothing) worst.optics = std::max(worst.optics, edit.made.mostBricks);
      if (edit.made.mostBricks < edit.allBricks) worst.coarse_s = std::max(worst.coarse_s, slowest(edit.made.coarse_s));
    }
  }
  worst.paintRatio = fullOverEdit(results[kJacquard].edits.front());
  return worst;
}

void addAllTargets(ReportPage& page, const Worst& worst) {
  using Kind = Target::Kind;
  const auto count = [](uint64_t n) { return static_cast<double>(n); };
  addTargets(
      page, "edit_targets",
      {{"bricks voxelised for one crossing", "", "", Kind::count, kMostOfCrossing, kMostOfCrossing,
        count(worst.crossing)},
       {"bricks voxelised for colour, optics, light, camera, drape", "", "", Kind::count, 0, 0, count(worst.optics)},
       {"bricks voxelised to undo or redo", "", "", Kind::count, 0, 0, count(worst.undo)},
       {"full build : one crossing, jacquard", "", "", Kind::ratio, 500, 500, worst.paintRatio},
       {"edit to first picture where not all is rebuilt, 95 %", "", "", Kind::milliseconds, 100, 33,
        1e3 * worst.coarse_s},
       {"crossing of a stroke to a picture of it, 95 %", "", "", Kind::milliseconds, 100, 33, 1e3 * worst.stroke_s}});
}

nlohmann::ordered_json jsonOf(const Transitions& transitions) {
  const auto spread = [](const std::vector<double>& seconds) {
    return nlohmann::ordered_json{{"median", median(seconds)}, {"p95", slowest(seconds)}};
  };
  nlohmann::ordered_json json;
  json["bricks"] = transitions.mostBricks;
  json["volume_seconds"] = spread(transitions.volume_s);
  json["first_picture_seconds"] = spread(transitions.coarse_s);
  if (!transitions.sample_s.empty()) json["one_sample_seconds"] = median(transitions.sample_s);
  return json;
}

nlohmann::ordered_json jsonOf(const ClothResult& result) {
  nlohmann::ordered_json json;
  json["cloth"] = result.name;
  json["ends"] = result.fabric.weave.ends();
  json["picks"] = result.fabric.weave.picks();
  json["bricks"] = result.counts.bricks;
  for (const EditResult& edit : result.edits) {
    nlohmann::ordered_json one;
    one["edit"] = edit.kind.name;
    one["made"] = jsonOf(edit.made);
    one["undone"] = jsonOf(edit.undone);
    one["redone"] = jsonOf(edit.redone);
    one["full_build"] = {{"bricks", edit.allBricks}, {"seconds", edit.full_s}};
    one["alone_seconds"] = edit.alone_s;
    json["edits"].push_back(std::move(one));
  }
  json["stroke"] = {{"crossings", result.strokeWaits_s.size()},
                    {"bricks", result.strokeBricks},
                    {"median", median(result.strokeWaits_s)},
                    {"p95", slowest(result.strokeWaits_s)}};
  return json;
}

}  // namespace

int run(const EditBenchCommand& command) {
  const Interrupt interrupt;
  const Bench bench{command.quick, command.threads > 0 ? command.threads : hardwareThreads(), interrupt.token()};
  Stopwatch watch;
  ReportPage page(command.folder, "edit", "Edits: what the editor does again, and how soon it shows");
  page.paragraph(fmt::format(
      "Every edit as the window makes it, through the builder and the tracer of the editor at work on a picture of "
      "{} x {}, {} times each, then undone and redone; milliseconds from the edit on, median and in brackets 95th "
      "percentile; one sample of every pixel the first time only. Beside it the same edit as a full build of volume, "
      "shell and light tables, and as it is made of the cloth before; both in the same run while nothing is traced "
      "(beside the tracer, whose caches it finds cold, an edit may take several times as long), and their ratio.",
      bench.width(), bench.height(), bench.rounds()));
  std::vector<ClothResult> results;
  for (const EditedCloth& cloth : editedCloths(bench.quick)) {
    auto result = study(cloth, bench);
    if (!result) return Interrupt::kExitStatus;
    addCloth(page, *result);
    results.push_back(std::move(*result));
  }
  page.paragraph(fmt::format("Measured in {} on {}", durationText(watch.lap()), machineFacts(bench.threads)));
  addAllTargets(page, worstOf(results));
  const std::string file = page.finish();
  if (command.json) {
    auto list = nlohmann::ordered_json::array();
    for (const ClothResult& result : results) list.push_back(jsonOf(result));
    fmt::print("{}\n", list.dump(2));
  } else {
    fmt::print("{}\n", file);
  }
  return 0;
}

}  // namespace loomlight
