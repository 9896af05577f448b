// What recolouring costs: bytes that a sample's path takes on record, and milliseconds to dye a picture anew.
#include <benchmark/benchmark.h>

#include "core/fabric/json/fabric_json.h"
#include "render/display/recolour.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

constexpr int kWidth = 320, kHeight = 240;

void recolourPicture(benchmark::State& state, const char* file, LightKind light) {
  const std::string path = std::string(LOOMLIGHT_SAMPLES "/") + file;
  Fabric fabric = readFabric(path);
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = 20;
  fabric.camera = Camera{};
  fabric.camera.distance_mm = 40;
  fabric.light = Light{};
  fabric.light.kind = light;
  const auto scene = makeScene(std::make_shared<const Fabric>(std::move(fabric)), Task{});
  const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), Task{});
  const CameraRays camera(scene->fabric->camera, kWidth, kHeight);
  Film film(kWidth, kHeight);
  // The window's share of a viewport of 640 x 480.
  PathRecords records(kWidth, kHeight, static_cast<int>(scene->cloth->materials.size()), size_t{64} << 20);
  for (uint32_t samples = 1; samples <= 16; ++samples)
    renderUpTo(samples, *scene, *medium, camera, film, {0, 0, kWidth, kHeight}, Task{}, 0, &records);
  Recolouring recolouring{scene->colouring, Rgb(1)};
  for (auto _ : state) {
    recolouring.colouring.primaries_per_mm[0] *= 0.99f;
    benchmark::DoNotOptimize(recolour(film, records, recolouring, 1));
  }
  const uint32_t kept = records.samples(0, 0);
  state.counters["samples"] = kept;
  state.counters["bytes/sample"] = static_cast<double>(records.bytes()) / (double{kWidth} * kHeight * kept);
  state.counters["pixels/s"] =
      benchmark::Counter(double{kWidth} * kHeight, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(recolourPicture, blue_sky, "blue_cloth.json", LightKind::sky)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);
BENCHMARK_CAPTURE(recolourPicture, blue_dome, "blue_cloth.json", LightKind::dome)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);
BENCHMARK_CAPTURE(recolourPicture, denim_sky, "denim.json", LightKind::sky)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);

}  // namespace
}  // namespace loomlight

BENCHMARK_MAIN();
