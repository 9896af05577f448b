#include "app/bench/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/bench/bench_accuracy.h"
#include "app/bench/bench_close_up.h"
#include "app/bench/bench_figures.h"
#include "app/bench/bench_table1.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/volume_json.h"
#include "core/base/quantile.h"
#include "core/base/stopwatch.h"
#include "core/fabric/model/validate.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

struct ResolutionRow {
  int resolution = 0;
  VolumeCounts volume;
  // Processor time, all threads together:
  double voxelise_s = 0;  ///< strands and voxels of all distinct bricks
  double trace_s = 0;
  TraceCounts trace;
};

/// False when stopped.
bool measure(const Fabric& fabric, int rounds, const Task& task, ResolutionRow& row) {
  row.resolution = fabric.render.resolution;
  const auto scene = makeScene(std::make_shared<const Fabric>(fabric), task);
  if (!scene) return false;
  const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), task);
  if (!medium) return false;
  const ClothGeometry& geometry = scene->cloth->volume->geometry();
  row.volume = scene->cloth->volume->counts();
  const CameraRays camera(fabric.camera, fabric.render.width, fabric.render.height);
  std::vector<double> voxelise, trace;
  for (int round = 0; round < rounds; ++round) {
    CpuStopwatch watch;
    const auto copy = std::make_shared<const ClothGeometry>(fabric, geometry.ends(), geometry.picks());
    if (!ClothVolume::build(copy, fabric.render.resolution, task)) return false;
    voxelise.push_back(watch.lap());
    Film film(fabric.render.width, fabric.render.height);
    watch.lap();
    const auto samples = static_cast<uint32_t>(fabric.render.samplesPerPixel);
    const PassResult pass = renderUpTo(samples, *scene, *medium, camera, film, task);
    if (!pass.complete) return false;
    trace.push_back(watch.lap());
    row.trace = pass.counts;
  }
  row.voxelise_s = quantile(voxelise, 0.5);
  row.trace_s = quantile(trace, 0.5);
  return true;
}

double ratio(double amount, double of) {
  return of > 0 ? amount / of : 0;
}
double pathsPerSecond(const ResolutionRow& row) {
  return ratio(static_cast<double>(row.trace.paths), row.trace_s);
}

void printTable(const std::vector<ResolutionRow>& rows) {
  fmt::print(
      "| resolution | bricks | voxels | components | MB | voxelise, CPU s | segments/s "
      "| paths/s/core | events/path | ns/event | rays/path | voxels/ray |\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const ResolutionRow& row : rows) {
    const auto paths = static_cast<double>(row.trace.paths), events = static_cast<double>(row.trace.events),
               rays = static_cast<double>(row.trace.rays), steps = static_cast<double>(row.trace.steps);
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.3f} | {:.2e} | {:.0f} | {:.2f} | {:.0f} | {:.2f} | {:.2f} |\n",
               row.resolution, row.volume.bricks, row.volume.voxels, row.volume.components,
               static_cast<double>(row.volume.bytes) / 1e6, row.voxelise_s,
               ratio(static_cast<double>(row.volume.segments), row.voxelise_s), pathsPerSecond(row),
               ratio(events, paths), ratio(1e9 * row.trace_s, events), ratio(rays, paths), ratio(steps, rays));
  }
}

void printJson(const std::vector<ResolutionRow>& rows) {
  auto list = nlohmann::ordered_json::array();
  for (const ResolutionRow& row : rows) {
    nlohmann::ordered_json json;
    json["resolution"] = row.resolution;
    addVolume(json, row.volume);
    json["voxelise_cpu_seconds"] = row.voxelise_s;
    json["render_cpu_seconds"] = row.trace_s;
    json["paths"] = row.trace.paths;
    json["events"] = row.trace.events;
    json["rays"] = row.trace.rays;
    json["steps"] = row.trace.steps;
    json["paths_per_second_per_core"] = pathsPerSecond(row);
    list.push_back(std::move(json));
  }
  fmt::print("{}\n", list.dump(2));
}

}  // namespace

int run(const BenchCommand& command) {
  const Interrupt interrupt;
  Task task;
  task.stop = interrupt.token();
  task.threads = command.threads;
  Fabric fabric = withOptions(fabricFrom({command.input, {}}), command.options, command.input);
  if (!command.options.samplesPerPixel) fabric.render.samplesPerPixel = BenchCommand::kSamples;
  validate(fabric, command.input);
  std::vector<ResolutionRow> rows(command.resolutions.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    fabric.render.resolution = command.resolutions[i];
    fmt::print(stderr, "loomlight: measuring at resolution {}\n", command.resolutions[i]);
    if (!measure(fabric, command.rounds, task, rows[i])) return Interrupt::kExitStatus;
  }
  if (command.json)
    printJson(rows);
  else
    printTable(rows);
  return 0;
}

int run(const ReportBenchCommand& command) {
  const Interrupt interrupt;
  const Task task = interrupt.task(command.threads);
  const auto measure = [&] {
    switch (command.suite) {
      case ReportBenchCommand::Suite::table1:
        return benchTable1(command.bench, task);
      case ReportBenchCommand::Suite::figures:
        return benchFigures(command.bench, task);
      case ReportBenchCommand::Suite::accuracy:
        return benchAccuracy(command.bench, task);
      case ReportBenchCommand::Suite::closeup:
        return benchCloseUp(command.bench, task);
    }
    return false;
  };
  return measure() ? 0 : Interrupt::kExitStatus;
}

}  // namespace loomlight
