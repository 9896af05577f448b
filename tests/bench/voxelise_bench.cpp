#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/fabric/json/fabric_json.h"
#include "core/volume/traverse/cloth_volume.h"

// Where the time of a volume's construction goes, on one core; segments/s counts the fibre segments of its bricks.
namespace loomlight {
namespace {

constexpr int kResolutions[] = {4, 8, 16};

/// A sample fabric in a piece as large as its drape, and the keys of all its bricks.
struct Sample {
  Fabric fabric;
  std::shared_ptr<const ClothGeometry> geometry;
  std::vector<YarnCellKey> keys;
  double segments = 0;

  explicit Sample(const std::filesystem::path& file) : fabric(readFabric(file.string())) {
    geometry = makeGeometry();
    for (const System system : {System::warp, System::weft}) {
      const TileMap tiles(*geometry, system, std::make_shared<BrickPool>(glm::ivec3(1)), oneThread());
      for (const TileMap::Kind kind : tiles.missing()) keys.push_back(tiles.key(kind));
    }
    for (const YarnCellKey& key : keys) segments += static_cast<double>(geometry->strands(key).segments());
  }
  std::shared_ptr<const ClothGeometry> makeGeometry() const {
    const int ends = static_cast<int>(fabric.drape.width_mm / fabric.warpPitch_mm());
    const int picks = static_cast<int>(fabric.drape.height_mm / fabric.weftPitch_mm());
    return std::make_shared<const ClothGeometry>(fabric, std::max(1, ends), std::max(1, picks));
  }
};

void countSegments(benchmark::State& state, const Sample& sample) {
  state.counters["segments/s"] =
      benchmark::Counter(sample.segments, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
  state.counters["bricks"] = static_cast<double>(sample.keys.size());
}

void geometry(benchmark::State& state, const Sample& sample) {
  for (auto _ : state) benchmark::DoNotOptimize(sample.makeGeometry());
  countSegments(state, sample);
}

void tileMaps(benchmark::State& state, const Sample& sample) {
  const auto pool = std::make_shared<BrickPool>(glm::ivec3(1));
  for (auto _ : state)
    for (const System system : {System::warp, System::weft})
      benchmark::DoNotOptimize(TileMap(*sample.geometry, system, pool, oneThread()));
  countSegments(state, sample);
}

void strands(benchmark::State& state, const Sample& sample) {
  for (auto _ : state)
    for (const YarnCellKey& key : sample.keys) benchmark::DoNotOptimize(sample.geometry->strands(key));
  countSegments(state, sample);
}

void bricks(benchmark::State& state, const Sample& sample, int resolution) {
  Voxeliser voxelise(makeGrid(*sample.geometry, resolution));
  for (auto _ : state)
    for (const YarnCellKey& key : sample.keys)
      benchmark::DoNotOptimize(voxelise(sample.geometry->strands(key), key.system));
  countSegments(state, sample);
}

void whole(benchmark::State& state, const Sample& sample, int resolution) {
  for (auto _ : state) benchmark::DoNotOptimize(ClothVolume::build(sample.makeGeometry(), resolution, oneThread()));
  countSegments(state, sample);
}

}  // namespace
}  // namespace loomlight

int main(int argc, char** argv) {
  using namespace loomlight;
  benchmark::Initialize(&argc, argv);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(LOOMLIGHT_SAMPLES))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const auto sample = std::make_shared<const Sample>(file);
    const auto add = [&](const std::string& what, auto&& run) {
      benchmark::RegisterBenchmark(fmt::format("{}/{}", file.stem().string(), what).c_str(), run)
          ->Unit(benchmark::kMillisecond);
    };
    add("geometry", [sample](benchmark::State& state) { geometry(state, *sample); });
    add("tile_maps", [sample](benchmark::State& state) { tileMaps(state, *sample); });
    add("strands", [sample](benchmark::State& state) { strands(state, *sample); });
    for (const int resolution : kResolutions) {
      add(fmt::format("bricks/{}", resolution),
          [sample, resolution](benchmark::State& state) { bricks(state, *sample, resolution); });
      add(fmt::format("whole/{}", resolution),
          [sample, resolution](benchmark::State& state) { whole(state, *sample, resolution); });
    }
  }
  benchmark::RunSpecifiedBenchmarks();
}
