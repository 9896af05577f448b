#include "app/bench/bench_converge.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "app/bench/machine_facts.h"
#include "app/bench/studies/bench_cloths.h"
#include "app/bench/studies/convergence_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/interrupt.h"
#include "render/transport/make_medium.h"

namespace loomlight {
namespace {

struct ConvergeExtent {
  int width, height, rounds;
  uint32_t samples, referenceSamples;
};

constexpr ConvergeExtent kFullConverge{40, 30, 2, 16, 128};
constexpr ConvergeExtent kQuickConverge{24, 16, 1, 4, 16};

/// A flat piece of forty ends, which fills most of the picture.
Fabric swatchOf(Fabric fabric, const ConvergeExtent& extent) {
  fabric.drape = Drape{};
  fabric.drape.width_mm = 40 * fabric.warpPitch_mm();
  fabric.drape.height_mm = fabric.drape.width_mm;
  fabric.camera = Camera{};
  fabric.camera.distance_mm = 2 * fabric.drape.width_mm;
  fabric.render.width = extent.width;
  fabric.render.height = extent.height;
  return fabric;
}

struct LightCase {
  const char* name;
  LightKind kind;
};
constexpr LightCase kLightCases[] = {
    {"sun and sky", LightKind::sky}, {"white dome", LightKind::dome}, {"headlight", LightKind::headlight}};

using Row = std::vector<std::string>;

/// What one variant came to on all cloths under one light.
struct Outcome {
  double logError = 0;  ///< of its error at equal samples over that of `all on`
  double logWork = 0;   ///< of error times time over the same
  int pictures = 0;
};

class ConvergeBench {
 public:
  ConvergeBench(const ConvergeBenchCommand& command, Task task)
      : extent_(command.quick ? kQuickConverge : kFullConverge),
        task_(std::move(task)),
        page_(command.folder, "converge", kTitle) {}

  /// False when stopped.
  bool run(std::vector<BenchCloth> cloths) {
    for (BenchCloth& cloth : cloths) {
      cloth.fabric = swatchOf(std::move(cloth.fabric), extent_);
      std::shared_ptr<const Scene> scene;
      for (const LightCase& light : kLightCases) {
        cloth.fabric.light = Light{};
        cloth.fabric.light.kind = light.kind;
        scene = makeScene(std::make_shared<const Fabric>(cloth.fabric), task_, scene.get());
        if (!scene || !study(cloth.name, light, *scene)) return false;
        fmt::print(stderr, "loomlight: {} under {} measured\n", cloth.name, light.name);
      }
    }
    return true;
  }

  std::string finish() {
    page_.paragraph(fmt::format(
        "Pictures of {} x {} of six cloths under three lights. Error is relMSE against {} samples of another seed, the "
        "mean over {} seeds; time is processor time. Ratios to `all on` are geometric means over the cloths: at equal "
        "samples, and of error times time, which says how much longer the same quality takes. Above 1, what was "
        "switched off earns its place. Where lamps are not looked for, pictures of so few samples mostly miss the sun, "
        "which relMSE forgives, until one path meets it and outweighs them all.",
        extent_.width, extent_.height, extent_.referenceSamples, extent_.rounds));
    std::vector<Row> rows;
    for (const LightCase& light : kLightCases)
      for (const SamplingVariant& variant : samplingVariants()) {
        const Outcome& o = outcomes_[light.name + ("/" + variant.name)];
        if (o.pictures == 0 || variant.name == samplingVariants().front().name) continue;
        rows.push_back({light.name, variant.name, fmt::format("{:.2f}", std::exp(o.logError / o.pictures)),
                        fmt::format("{:.2f}", std::exp(o.logWork / o.pictures))});
      }
    page_.heading("What each way of sampling is worth");
    page_.table("converge_summary", {"light", "changed", "error, equal samples", "error x time"}, rows);
    page_.heading("Error against time");
    page_.table("converge", {"cloth", "light", "sampling", "samples", "relMSE", "CPU s"}, rows_);
    page_.paragraph(fmt::format("Measured on {}", machineFacts(task_.threads)));
    return page_.finish();
  }

 private:
  static constexpr const char* kTitle = "Convergence: what each way of sampling is worth";

  bool study(const std::string& cloth, const LightCase& light, const Scene& scene) {
    const auto medium = makeMedium(scene, defaultMemoryLimit_bytes(), task_);
    if (!medium) return false;
    const ConvergenceStudy study(scene, *medium, extent_.referenceSamples, extent_.rounds, task_);
    ConvergenceStudy::Point whole;
    for (const SamplingVariant& variant : samplingVariants()) {
      const bool delta = scene.lighting->isDelta(), sampled = scene.lighting->wantsSampling();
      if (variant.name == "lamps not looked for" && (delta || !sampled)) continue;
      if (variant.name == "lamps at every event" && !sampled) continue;
      const auto points = study.measure(variant, extent_.samples);
      if (points.empty()) return false;
      for (const auto& point : points) addRow(cloth, light, variant.name, fmt::format("{}", point.samples), point);
      const auto& last = points.back();
      if (variant.name == samplingVariants().front().name) whole = last;
      Outcome& outcome = outcomes_[light.name + ("/" + variant.name)];
      outcome.logError += std::log(last.error / whole.error);
      outcome.logWork += std::log(last.error * last.seconds / (whole.error * whole.seconds));
      ++outcome.pictures;
    }
    for (const int divider : {8, 4, 2}) {
      const auto point = study.coarse(divider);
      if (!point) return false;
      addRow(cloth, light, fmt::format("coarse, 1/{}", divider), "1", *point);
    }
    return true;
  }

  void addRow(const std::string& cloth, const LightCase& light, const std::string& sampling, const std::string& samples,
              const ConvergenceStudy::Point& point) {
    rows_.push_back({cloth, light.name, sampling, samples, fmt::format("{:.4f}", point.error),
                     fmt::format("{:.3f}", point.seconds)});
  }

  ConvergeExtent extent_;
  Task task_;
  ReportPage page_;
  std::map<std::string, Outcome> outcomes_;
  std::vector<Row> rows_;
};

}  // namespace

int run(const ConvergeBenchCommand& command) {
  const Interrupt interrupt;
  const Task task = interrupt.task(command.threads);
  std::vector<BenchCloth> cloths = cylinderCloths();
  for (BenchCloth& cloth : largeCloths())
    if (cloths.size() < 6) cloths.push_back(std::move(cloth));
  if (command.quick) cloths.resize(1);
  ConvergeBench bench(command, task);
  if (!bench.run(std::move(cloths))) return Interrupt::kExitStatus;
  fmt::print("{}\n", bench.finish());
  return 0;
}

}  // namespace loomlight
