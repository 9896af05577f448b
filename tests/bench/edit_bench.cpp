#include <benchmark/benchmark.h>

#include "core/base/random.h"
#include "core/volume/traverse/cloth_volume.h"

// What an edit of the weave costs, against a build of all of it, on one core: a jacquard of random crossings, its whole
// repeat one piece. Geometry counts too.
namespace loomlight {
namespace {

Fabric jacquard(int side) {
  Random random(1);
  std::vector<std::vector<uint8_t>> rows(side, std::vector<uint8_t>(side));
  for (auto& row : rows)
    for (uint8_t& cell : row) cell = random.below(2) != 0;
  Fabric fabric;
  fabric.weave = Weave(rows);
  return fabric;
}

std::shared_ptr<const ClothVolume> build(const Fabric& fabric, const ClothVolume* previous) {
  Task task;
  task.threads = 1;
  const int side = fabric.weave.ends();
  const auto geometry =
      std::make_shared<const ClothGeometry>(fabric, side, side, previous ? &previous->geometry() : nullptr);
  return ClothVolume::build(geometry, 8, task, previous);
}

void whole(benchmark::State& state) {
  const Fabric fabric = jacquard(static_cast<int>(state.range(0)));
  VolumeCounts counts;
  for (auto _ : state) counts = build(fabric, nullptr)->counts();
  state.counters["bricks"] = static_cast<double>(counts.bricks);
  state.counters["MB"] = static_cast<double>(counts.bytes) * 1e-6;
}

/// So many crossings in a row, each time elsewhere.
void paint(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  Fabric fabric = jacquard(side);
  auto volume = build(fabric, nullptr);
  Random random(2);
  for (auto _ : state) {
    state.PauseTiming();
    const int pick = random.below(side), end = random.below(side);
    for (int i = 0; i < state.range(1); ++i) {
      const int e = (end + i) % side;
      fabric.weave = fabric.weave.with(pick, e, !fabric.weave.at(pick, e));
    }
    state.ResumeTiming();
    volume = build(fabric, volume.get());
  }
}

BENCHMARK(whole)->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(paint)->ArgsProduct({{1000, 4000}, {1, 100}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace loomlight

BENCHMARK_MAIN();
