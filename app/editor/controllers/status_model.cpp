#include "app/editor/controllers/status_model.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/words/status_words.h"

namespace loomlight {
namespace {

std::string workOf(const LiveStatus& status, const Frame* shown) {
  const std::string help = !shown                     ? ""
                           : !shown->denoised.empty() ? words::status::andDenoised
                           : shown->shared            ? words::status::andShared
                           : !shown->helped.empty()   ? words::status::andSmoothed
                                                      : "";
  if (shown && shown->quality == PreviewQuality::sketch) return fmt::format(words::status::firstLook, help);
  switch (status.phase) {
    case LiveStatus::Phase::idle:
      return fmt::format(words::status::waiting, help);
    case LiveStatus::Phase::voxelising:
      return fmt::format(words::status::building, 100 * status.buildProgress, help);
    case LiveStatus::Phase::tracing:
      if (!shown || shown->quality != PreviewQuality::recoloured) return fmt::format(words::status::refining, help);
      if (help.empty()) return words::status::recolouredRefining;
      return fmt::format(words::status::recoloured, help);  // all three would need more room
    case LiveStatus::Phase::converged:
      break;
  }
  return fmt::format(words::status::converged, help);
}

void tellFigures(const FabricStats& stats, const ClothMeasures& measures, StatusModel& model) {
  const int warp = stats.floats.warp(), weft = stats.floats.weft();
  const double warp_mm = floatLength_mm(*stats.fabric, System::warp, warp);
  const double weft_mm = floatLength_mm(*stats.fabric, System::weft, weft);
  model.figuresKnown = true;
  model.unboundYarns = stats.floats.idleEnds + stats.floats.idlePicks;
  model.longestFloat = warp_mm >= weft_mm ? warp : weft;
  model.longestFloat_mm = std::max(warp_mm, weft_mm);
  model.longFloats = stats.longFloats.count;
  model.longFloat_mm = stats.longFloats.limit_mm;
  model.coverPercent = 100 * measures.cover;
  model.arealMass_g_m2 = measures.arealMass_g_m2;
  model.thickness_mm = measures.thickness_mm;
  if (stats.warnings.empty()) return;
  model.warning = stats.warnings.front();
  model.moreWarnings = static_cast<int>(stats.warnings.size()) - 1;
}

}  // namespace

StatusModel statusModel(const FabricStats* stats, const LiveStatus& status, const VisibilityWorker::Status& baking,
                        const Frame* shown) {
  StatusModel model;
  if (stats && status.measures.thickness_mm > 0) tellFigures(*stats, status.measures, model);
  if (!status.notices.empty() && model.warning.empty()) model.warning = status.notices.front();
  if (!baking.error.empty() && model.warning.empty()) model.warning = baking.error;
  if (shown) {
    model.samples = shown->samples;
    model.seconds = shown->seconds;
  }
  if (baking.baking)
    model.background = baking.borrowing ? fmt::format(words::status::borrowed, 100 * baking.progress)
                                        : fmt::format(words::status::visibility, 100 * baking.progress);
  model.work = workOf(status, shown);
  return model;
}

}  // namespace loomlight
