#include "app/bench/bench_close_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/bench/bench_targets.h"
#include "app/bench/machine_facts.h"
#include "app/bench/studies/cloth_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/progress.h"
#include "app/wardrobe/wardrobe.h"
#include "core/base/stopwatch.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// Of two films each; a picture is the mean of both.
struct CloseUpPlan {
  int width = 96, height = 72;
  int samples = 512;
};
constexpr CloseUpPlan kFullCloseUp{}, kQuickCloseUp{32, 24, 24};

/// Flat, from straight above, a fibre of the finest yarn a pixel wide: so near that all paths go among the fibres.
Fabric seenSoNear(Fabric fabric, const CloseUpPlan& plan) {
  double fibre_mm = 1;
  for (const Fibre& fibre : fabric.fibres) fibre_mm = std::min(fibre_mm, 2e-3 * fibre.radius_um);
  const ClothGeometry geometry(fabric, 1, 1);
  const double seen_mm = plan.width * fibre_mm;
  constexpr double kMargin = 3.5;  // in thicknesses: what light travels sideways inside of the cloth
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = seen_mm + 4 * kMargin * geometry.halfThickness_mm();
  fabric.camera.target_mm = glm::dvec3(0);
  fabric.camera.azimuth_deg = -90;
  fabric.camera.elevation_deg = 90;
  fabric.camera.fov_deg = 20;
  const double half = std::tan(0.5 * fabric.camera.fov_deg * kPi / 180);
  fabric.camera.distance_mm = geometry.halfThickness_mm() + 0.5 * plan.height * fibre_mm / half;
  fabric.render.width = plan.width;
  fabric.render.height = plan.height;
  return fabric;
}

/// What is traced, in this order. The fibres are traced twice: how far they are from themselves is noise.
enum Traced : size_t { kExplicit, kExplicitAgain, kVolumeAlone, kInCloseUp };
const Variant kTraced[] = {{"fibres", Method::fibres, Estimator::loomlight, 8},
                           {"the same fibres, other noise", Method::fibres, Estimator::loomlight, 8},
                           {"volume alone", Method::volume, Estimator::loomlight, 8},
                           {"close-up", Method::volume, Estimator::loomlight, 8, {}, true}};

struct CloseUpFigures {
  std::array<double, std::size(kTraced)> time{};  ///< beside that of the volume alone
  std::array<double, std::size(kTraced)> flip{};  ///< to the fibres
};

/// The cloth's rows and picture. nullopt when stopped.
std::optional<CloseUpFigures> addCloseUp(ReportPage& page, const char* file, const ReportBench& bench, const Task& task,
                                         std::vector<std::vector<std::string>>& rows) {
  const CloseUpPlan& plan = bench.quick ? kQuickCloseUp : kFullCloseUp;
  const Fabric cloth = wardrobeFabric(file);
  Fabric fabric = seenSoNear(cloth, plan);
  std::vector<PreparedCloth> cloths;
  for (const Variant& variant : kTraced) {
    fmt::print(stderr, "loomlight: {}: {}\n", cloth.name, variant.name);
    auto prepared = prepare(fabric, variant, bench, task);
    if (!prepared) return std::nullopt;
    cloths.push_back(std::move(*prepared));
    if (cloths.size() == 1) fabric.render.seed += 2;  // of the two films of a picture each has a seed
  }
  const auto pictures = renderInTurns(cloths, fabric.light, plan.samples, task);
  if (!pictures) return std::nullopt;
  CloseUpFigures figures;
  std::vector<Pixels8> strip;
  for (size_t i = 0; i < pictures->size(); ++i) {
    const TwoPictures& ours = (*pictures)[i];
    if (i != kExplicitAgain) strip.push_back(magnified(shown(ours), 3));
    if (i == kExplicit) continue;
    const StudyErrors errors = errorsOf(ours, (*pictures)[kExplicit], task.threads);
    figures.time[i] = ours.render_s / (*pictures)[kVolumeAlone].render_s;
    figures.flip[i] = errors.flip;
    rows.push_back(
        {cloth.name, cloths[i].variant.name, fmt::format("{:.2f}", figures.time[i]),
         fmt::format("{:+.1f} {:+.1f} {:+.1f}", errors.mean_percent.r, errors.mean_percent.g, errors.mean_percent.b),
         fmt::format("{:.1f}", errors.rms_percent), fmt::format("{:.3f}", errors.flip)});
  }
  page.picture(fmt::format("closeup_{}", file), sideBySide(strip),
               fmt::format("{}: explicit fibres, the volume alone, close-up", cloth.name));
  return figures;
}

}  // namespace

bool benchCloseUp(const ReportBench& bench, const Task& task) {
  Stopwatch watch;
  ReportPage page(bench.folder, "closeup", "Close-ups: fibres where you look");
  page.paragraph(
      "Flat cloth from straight above in its file's own light, the finest fibre a pixel wide, against explicit fibres "
      "of the whole piece. Time is the processor time of a picture beside that of the volume alone, in one run, in "
      "turns. FLIP holds what noise there is: the first line of each cloth says how much that is.");
  std::vector<std::vector<std::string>> rows;
  CloseUpFigures sums;
  double count = 0;
  for (const char* file : {"taffeta", "poplin", "gabardine", "denim_raw"}) {
    if (bench.quick && count > 0) break;
    const auto figures = addCloseUp(page, file, bench, task, rows);
    if (!figures) return false;
    for (size_t i = 0; i < figures->time.size(); ++i) {
      sums.time[i] += figures->time[i];
      sums.flip[i] += figures->flip[i];
    }
    ++count;
  }
  page.table("closeup", {"cloth", "method", "time", "mean colour, %", "RMS without noise, %", "mean FLIP"}, rows);
  page.paragraph(fmt::format("Measured in {} on {}", durationText(watch.lap()), machineFacts(task.threads)));
  addTargets(page, "closeup_targets",
             {{"time of a close-up beside the volume's, mean over the cloths", "", "", Target::Kind::percent, 150, 100,
               100 * sums.time[kInCloseUp] / count},
              {"mean FLIP of a close-up beside the volume's, noise included", "", "", Target::Kind::percent, 50, 25,
               100 * sums.flip[kInCloseUp] / sums.flip[kVolumeAlone]}});
  fmt::print("{}\n", page.finish());
  return true;
}

}  // namespace loomlight
