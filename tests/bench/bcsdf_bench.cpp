#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/optics/bcsdf.h"

namespace loomlight {
namespace {

constexpr size_t kQueries = 4096;  // few enough to stay in the cache, many enough not to be learnt by the predictor

struct Query {
  glm::vec3 wo;
  float h;
};

/// Directions as fibres meet them in isotropic light: in proportion to the sine of the angle to the fibre.
std::vector<Query> queries() {
  Random random(1);
  std::vector<Query> result;
  while (result.size() < kQueries) {
    const float x = 2 * random.uniform() - 1, r = std::sqrt(1 - x * x), phi = 6.2831853f * random.uniform();
    if (random.uniform() < r) result.push_back({{x, r * std::cos(phi), r * std::sin(phi)}, 2 * random.uniform() - 1});
  }
  return result;
}

Fibre fibreOf(const benchmark::State& state) {
  Fibre fibre;
  fibre.longitudinalRoughness = fibre.azimuthalRoughness = static_cast<double>(state.range(0)) / 100;
  fibre.scaleTilt_deg = static_cast<double>(state.range(1));
  return fibre;
}

void sample(benchmark::State& state) {
  const FibreBcsdf bcsdf(fibreOf(state));
  const std::vector<Query> list = queries();
  Random random(2);
  size_t i = 0;
  for (auto _ : state) {
    const Query& query = list[i++ % kQueries];
    benchmark::DoNotOptimize(bcsdf.sample(query.wo, query.h, random));
  }
}

void sampleWithoutPdf(benchmark::State& state) {
  const FibreBcsdf bcsdf(fibreOf(state));
  const std::vector<Query> list = queries();
  Random random(2);
  size_t i = 0;
  for (auto _ : state) {
    const Query& query = list[i++ % kQueries];
    benchmark::DoNotOptimize(bcsdf.sampleWithoutPdf(query.wo, query.h, random));
  }
}

void evaluate(benchmark::State& state) {
  const FibreBcsdf bcsdf(fibreOf(state));
  const std::vector<Query> list = queries();
  size_t i = 0;
  for (auto _ : state) {
    const Query& query = list[i++ % kQueries];
    benchmark::DoNotOptimize(bcsdf.evaluate(query.wo, list[i % kQueries].wo, query.h));
  }
}

/// The same directions, eight side by side.
struct EightQueries {
  Vec3Of<Float32x8> wo{};
  Float32x8 h{};
};
std::vector<EightQueries> byEights(const std::vector<Query>& list) {
  std::vector<EightQueries> result(list.size() / 8);
  for (size_t i = 0; i < list.size(); ++i) {
    EightQueries& eight = result[i / 8];
    const size_t lane = i % 8;
    eight.wo.x[lane] = list[i].wo.x;
    eight.wo.y[lane] = list[i].wo.y;
    eight.wo.z[lane] = list[i].wo.z;
    eight.h[lane] = list[i].h;
  }
  return result;
}

void sampleEight(benchmark::State& state) {
  const FibreBcsdf bcsdf(fibreOf(state));
  const std::vector<EightQueries> list = byEights(queries());
  std::vector<Random> random;
  std::array<Random*, 8> each;
  for (uint64_t lane = 0; lane < 8; ++lane) random.emplace_back(lane);
  for (size_t lane = 0; lane < 8; ++lane) each[lane] = &random[lane];
  RandomLanes<Float32x8> numbers(each);
  size_t i = 0;
  for (auto _ : state) {
    const EightQueries& query = list[i++ % list.size()];
    benchmark::DoNotOptimize(bcsdf.sample(query.wo, query.h, numbers, true));
  }
}

void evaluateEight(benchmark::State& state) {
  const FibreBcsdf bcsdf(fibreOf(state));
  const std::vector<EightQueries> list = byEights(queries());
  std::array<FibreBcsdf::ValueOf<Float32x8>, 1> values;
  size_t i = 0;
  for (auto _ : state) {
    const EightQueries& query = list[i++ % list.size()];
    bcsdf.evaluate(query.wo, list[i % list.size()].wo, {&query.h, 1}, values);
    benchmark::DoNotOptimize(values);
  }
}

void construct(benchmark::State& state) {
  const Fibre fibre = fibreOf(state);
  for (auto _ : state) benchmark::DoNotOptimize(FibreBcsdf(fibre));
}

// Arguments: roughness in hundredths, scale tilt in degrees.
BENCHMARK(sample)->Args({5, 0})->Args({30, 0})->Args({80, 0})->Args({30, 3});
BENCHMARK(sampleWithoutPdf)->Args({5, 0})->Args({30, 0})->Args({80, 0})->Args({30, 3});
BENCHMARK(evaluate)->Args({5, 0})->Args({30, 0})->Args({80, 0})->Args({30, 3});
BENCHMARK(sampleEight)->Args({5, 0})->Args({30, 0})->Args({80, 0})->Args({30, 3});
BENCHMARK(evaluateEight)->Args({5, 0})->Args({30, 0})->Args({80, 0})->Args({30, 3});
BENCHMARK(construct)->Args({5, 0})->Args({30, 0})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace loomlight

BENCHMARK_MAIN();
