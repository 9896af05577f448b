#include "app/editor/controllers/inset_model.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/widgets/number_text.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

std::string memoryText(double bytes) {
  return bytes < 0.95e9 ? fmt::format("{:.0f} MB", bytes * 1e-6) : fmt::format("{:.1f} GB", bytes * 1e-9);
}

std::string countText(double count) {
  if (count < 0.95e6) return fmt::format(words::lens::thousand, count * 1e-3);
  if (count < 0.95e9) return fmt::format(words::lens::million, count * 1e-6);
  return fmt::format(words::lens::billion, count * 1e-9);
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

/// `isLast`: no samples are to come.
void describeDifference(const InsetFrame& shown, bool isLast, InsetModel& model) {
  constexpr int kSteps = 32;
  const Difference* const found = shown.difference.get();
  if (!found) {
    model.caption = isLast && shown.fibres->samples < 2 ? words::lens::differenceOfOne : words::lens::differenceWaiting;
    return;
  }
  model.caption = fmt::format(words::lens::differenceSeen, Difference::kGain, signedText(found->mean_percent),
                              found->error_percent);
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
      model.caption = words::lens::waiting;
      break;
    case Phase::needless:
      model.trouble = words::lens::needless;
      break;
    case Phase::laying:
      model.laying = true;
      model.progress = status.progress;
      model.caption = fmt::format(words::lens::laying, countText(status.segments),
                                  status.isWholePiece ? "" : words::lens::ofOneRepeat, memoryText(status.bytes),
                                  100 * status.progress);
      break;
    case Phase::tooLarge:
      model.trouble =
          fmt::format(words::lens::tooLarge, countText(status.segments), memoryText(status.bytes),
                      memoryText(limit_bytes), drape.kind == DrapeKind::flat ? "" : words::lens::orLaidFlat);
      if (const auto fitting = fittingPiece(drape, status.bytes, limit_bytes))
        model.remedy = fmt::format(words::lens::makeSmaller, fitting->width_mm, fitting->height_mm);
      model.limitMatters = true;
      break;
    case Phase::failed:
      model.trouble = fmt::format(words::lens::failed, status.error);
      break;
    case Phase::tracing:
    case Phase::converged:
      if (!shown) {
        model.caption = words::lens::starting;
      } else if (difference) {
        describeDifference(*shown, status.phase == Phase::converged, model);
      } else {
        const int samples = shown->fibres->samples;
        model.caption =
            fmt::format(words::lens::seen, status.isWholePiece ? "" : words::lens::ofOneRepeat, sampleText(samples));
      }
      break;
  }
  return model;
}

}  // namespace loomlight
