// What recolouring costs in a viewport of 640 x 400: milliseconds to dye the picture anew, and bytes that a sample's
// path takes on record. In pairs: the same cloth with fibres known by three numbers, and by 36 bands.
#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/fabric/json/fabric_json.h"
#include "render/colour/primaries.h"
#include "render/display/recolour.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

constexpr int kWidth = 640, kHeight = 400;
constexpr uint32_t kSamples = 8;
constexpr size_t kRecords = size_t{256} << 20;  // as the window keeps (app/live/tracer.cpp)

enum class Known { byThreeNumbers, inBands };

void knowInBands(Fabric& fabric) {
  for (Fibre& fibre : fabric.fibres)
    fibre.absorption_per_mm = Absorption(mixed(colourPrimaries(), fibre.absorption_per_mm.primaries));
}

void dyeDeeper(Colouring& colouring) {
  for (Rgb& primaries : colouring.primaries_per_mm) primaries *= 1.01f;
  for (size_t i = 0; i < colouring.bands_per_mm.size(); ++i) {
    Spectrum deeper = colouring.bands_per_mm[i];
    for (float& band : deeper) band *= 1.01f;
    colouring.setBands(i, deeper);
  }
}

void recolourPicture(benchmark::State& state, const char* file, LightKind light, Known known) {
  const std::string path = std::string(LOOMLIGHT_SAMPLES "/") + file;
  Fabric fabric = readFabric(path);
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = 20;
  fabric.camera = Camera{};
  fabric.camera.distance_mm = 40;
  fabric.light = Light{};
  fabric.light.kind = light;
  if (known == Known::inBands) knowInBands(fabric);
  const auto scene = makeScene(std::make_shared<const Fabric>(std::move(fabric)), Task{});
  const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), Task{});
  const CameraRays camera(scene->fabric->camera, kWidth, kHeight);
  Film film(kWidth, kHeight);
  PathRecords records(kWidth, kHeight, static_cast<int>(scene->cloth->materials.size()), kRecords);
  for (uint32_t samples = 1; samples <= kSamples; ++samples)
    renderUpTo(samples, *scene, *medium, camera, film, Task{}, {.records = &records});
  Recolouring recolouring{scene->colouring, Rgb(1)};
  for (auto _ : state) {
    dyeDeeper(recolouring.colouring);
    benchmark::DoNotOptimize(recolour(film, records, recolouring, 0));
  }
  const uint32_t kept = records.samples(0, 0);
  state.counters["samples"] = kept;
  state.counters["bytes/sample"] = static_cast<double>(records.bytes()) / (double{kWidth} * kHeight * kept);
  state.counters["pixels/s"] =
      benchmark::Counter(double{kWidth} * kHeight, benchmark::Counter::kIsIterationInvariantRate);
}

/// By the processor's time, which other programs do not take.
void timed(benchmark::internal::Benchmark* one) {
  one->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(20);
}

BENCHMARK_CAPTURE(recolourPicture, blue_sky_three, "blue_cloth.json", LightKind::sky, Known::byThreeNumbers)
    ->Apply(timed);
BENCHMARK_CAPTURE(recolourPicture, blue_sky_bands, "blue_cloth.json", LightKind::sky, Known::inBands)->Apply(timed);
BENCHMARK_CAPTURE(recolourPicture, blue_dome_three, "blue_cloth.json", LightKind::dome, Known::byThreeNumbers)
    ->Apply(timed);
BENCHMARK_CAPTURE(recolourPicture, blue_dome_bands, "blue_cloth.json", LightKind::dome, Known::inBands)->Apply(timed);
BENCHMARK_CAPTURE(recolourPicture, denim_sky_three, "denim.json", LightKind::sky, Known::byThreeNumbers)->Apply(timed);
BENCHMARK_CAPTURE(recolourPicture, denim_sky_bands, "denim.json", LightKind::sky, Known::inBands)->Apply(timed);

}  // namespace
}  // namespace loomlight

BENCHMARK_MAIN();
