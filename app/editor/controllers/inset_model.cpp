#include "app/editor/controllers/inset_model.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

std::string memoryText(double bytes) {
  return bytes < 0.95e9 ? fmt::format("{:.0f} MB", bytes * 1e-6) : fmt::format("{:.1f} GB", bytes * 1e-9);
}

std::string countText(double count) {
  if (count < 0.95e6) return fmt::format("{:.0f} thousand", count * 1e-3);
  if (count < 0.95e9) return fmt::format("{:.1f} million", count * 1e-6);
  return fmt::format("{:.1f} billion", count * 1e-9);
}

/// To two digits, downwards.
double roundedDown(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit) * unit;
}

/// With a minus of the width of a plus.
std::string signedText(double value) {
  const std::string digits = fmt::format("{:.1f}", std::abs(value));
  return (value < 0 ? "\xE2\x88\x92" : "+") + digits;
}

void describeDifference(const Difference* found, InsetModel& model) {
  constexpr int kSteps = 32;
  if (!found) {
    model.caption = "difference, waiting for samples";
    return;
  }
  model.caption = fmt::format("difference \xC3\x97{:g}, mean {} \xC2\xB1 {:.1f} %", Difference::kGain,
                              signedText(found->mean_percent), found->error_percent);
  for (const Rgb& colour : differenceScale(kSteps)) model.scale.push_back(toDisplayColour(colour));
  model.scaleEnd = fmt::format("{:g} %", 100 / Difference::kGain);
}

}  // namespace

std::optional<Drape> fittingPiece(const Drape& drape, double bytes, double limit_bytes) {
  constexpr double kLeast_mm = 2, kSpare = 0.95;
  if (drape.kind == DrapeKind::mesh || !(bytes > limit_bytes)) return std::nullopt;
  const double share = std::sqrt(kSpare * limit_bytes / bytes);
  const double width = drape.width_mm * share, height = drape.height_mm * share;
  if (!(std::min(width, height) >= kLeast_mm)) return std::nullopt;
  Drape fitting = drape;
  fitting.width_mm = roundedDown(width);
  fitting.height_mm = roundedDown(height);
  return fitting;
}

InsetModel insetModel(const InsetStatus& status, const InsetFrame* shown, bool difference, double limit_bytes,
                      const Drape& drape) {
  using Phase = InsetStatus::Phase;
  InsetModel model;
  switch (status.phase) {
    case Phase::closed:
      break;
    case Phase::waiting:
      model.caption = "waiting for the cloth";
      break;
    case Phase::needless:
      model.trouble =
          "The whole picture shows every fibre already. Choose the method Volume on the Scene page to compare the two.";
      break;
    case Phase::laying:
      model.laying = true;
      model.progress = status.progress;
      model.caption =
          fmt::format("laying {} fibre segments{}, {}: {:.0f} %", countText(status.segments),
                      status.isWholePiece ? "" : " of one repeat", memoryText(status.bytes), 100 * status.progress);
      break;
    case Phase::tooLarge:
      model.trouble = fmt::format(
          "Every fibre of this piece, {} segments, would take {} of memory. The limit is {}. A smaller piece shows the "
          "same cloth{}.",
          countText(status.segments), memoryText(status.bytes), memoryText(limit_bytes),
          drape.kind == DrapeKind::flat ? "" : "; laid flat, one repeat can stand for all of it");
      if (const auto fitting = fittingPiece(drape, status.bytes, limit_bytes))
        model.remedy = fmt::format("Make it {:g} \xC3\x97 {:g} mm", fitting->width_mm, fitting->height_mm);
      model.limitMatters = true;
      break;
    case Phase::failed:
      model.trouble = "The fibres could not be laid: " + status.error;
      break;
    case Phase::tracing:
    case Phase::converged:
      if (!shown) {
        model.caption = "fibres, starting";
      } else if (difference) {
        describeDifference(shown->difference.get(), model);
      } else {
        const int samples = shown->fibres->samples;
        model.caption = fmt::format("fibres{}, {}", status.isWholePiece ? "" : " of one repeat",
                                    samples > 0 ? fmt::format("{} spp", samples) : std::string("preview"));
      }
      break;
  }
  return model;
}

}  // namespace loomlight
