#include "ui/inspector/yarn_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/fresh_name.h"
#include "core/fabric/model/finish.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/presets.h"
#include "ui/inspector/count_text.h"
#include "ui/inspector/trade_units.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/yarn_words.h"

namespace loomlight {
namespace {

/// Of the whole yarn, where one that is like `yarn` otherwise has the count that was typed.
double typedTex(const CountEntry& typed, const Yarn& yarn) {
  return typed.tex * (typed.ofSingles ? typed.plies.value_or(yarn.plies) * typed.cords.value_or(yarn.cords) : 1);
}

/// Of each filament. nullopt where the text says none.
std::optional<double> typedFilament_dtex(const CountEntry& typed, const Yarn& yarn) {
  if (!typed.filaments) return std::nullopt;
  return 10 * typedTex(typed, yarn) / (*typed.plies * *typed.cords * *typed.filaments);
}

/// Whether a fabric can hold it. A blend has no filaments of one fineness.
bool isPossible(const CountEntry& typed, const Yarn& yarn, const Fibre& fibre) {
  const FieldInfo count = fieldInfo(&Yarn::count_tex), radius = fieldInfo(&Fibre::radius_um);
  const double tex = typedTex(typed, yarn);
  if (tex < count.min || tex > count.max) return false;
  const std::optional<double> filament_dtex = typedFilament_dtex(typed, yarn);
  if (!filament_dtex) return true;
  const double radius_um = fibreRadius_um(*filament_dtex, fibre.density_g_cm3);
  return !yarn.blendFibre && radius_um >= radius.min && radius_um <= radius.max;
}

/// The count as its system writes it: of a plied yarn in an indirect one the singles, "30 /2 Ne"; "20 /2/3 Ne" of a
/// cable.
bool countRow(Ui& ui, CountSystem system, const Fibre& fibre, Yarn& yarn, std::optional<double>& filament_dtex) {
  const FieldInfo info = fieldInfo(&Yarn::count_tex);
  const int parts = isIndirect(system) ? singlesIn(yarn) : 1;
  std::string unit = countUnit(system);
  if (parts > 1)
    unit = yarn.cords > 1 ? fmt::format("/{}/{} {}", yarn.plies, yarn.cords, unit)
                          : fmt::format("/{} {}", yarn.plies, unit);
  std::optional<CountEntry> typed;
  NumberStyle style;
  style.unit = unit.c_str();
  style.min = countFromTex((isIndirect(system) ? info.max : info.min) / parts, system);
  style.max = countFromTex((isIndirect(system) ? info.min : info.max) / parts, system);
  style.logarithmic = true;
  style.decimals = 1;
  style.otherwise = words::yarnPage::countLooksLike;
  style.parse = [&](std::string_view text) -> std::optional<double> {
    typed = countFromText(text, system);
    if (typed && !isPossible(*typed, yarn, fibre)) typed.reset();
    return typed ? std::optional(countFromTex(typedTex(*typed, yarn) / parts, system)) : std::nullopt;
  };
  style.objection = [&](std::string_view text) -> std::string {
    const std::optional<CountEntry> meant = countFromText(text, system);
    const std::optional<double> dtex = meant ? typedFilament_dtex(*meant, yarn) : std::nullopt;
    if (!dtex) return {};
    if (yarn.blendFibre) return words::yarnPage::blendHasNoFilaments;
    return fmt::format(words::yarnPage::filamentsBeyondFibres, *dtex);
  };
  double count = countFromTex(yarn.count_tex / parts, system);
  const bool changed = numberField(ui, {"yarn.count_tex", words::yarnPage::typedCount}, style, count);
  if (!changed && !typed) return false;
  Yarn edited = yarn;
  edited.count_tex =
      std::clamp(typed ? typedTex(*typed, yarn) : parts * texFromCount(count, system), info.min, info.max);
  if (typed) {
    edited.plies = typed->plies.value_or(yarn.plies);
    edited.cords = typed->cords.value_or(yarn.cords);
    filament_dtex = typedFilament_dtex(*typed, yarn);
  }
  std::swap(yarn, edited);
  return yarn != edited || filament_dtex;
}

/// Turns of a strand of `tex`: per metre, or as the multiplier that spinners know it by.
bool twistRow(Ui& ui, const char* label, bool asMultiplier, double tex, double Yarn::* member, Yarn& yarn) {
  constexpr double kTurnsPerPixel = 4.0;
  const FieldInfo info = fieldInfo(member);
  const auto shown = [&](double turns) { return asMultiplier ? twistMultiplier(turns, tex) : turns; };
  NumberStyle style;
  style.unit = asMultiplier ? "TM" : info.unit;
  style.min = shown(info.min);
  style.max = shown(info.max);
  style.decimals = asMultiplier ? 2 : 0;
  style.perPixel = asMultiplier ? 0.02 : kTurnsPerPixel;
  style.parse = [&](std::string_view text) -> std::optional<double> {
    const std::optional<double> turns = twistFromText(text, tex);
    return turns ? std::optional(shown(*turns)) : std::nullopt;
  };
  double value = shown(yarn.*member);
  const std::string help = fmt::format(words::yarnPage::typedTwist, info.help);
  if (!numberField(ui, {std::string("yarn.") + info.key, label, help.c_str()}, style, value)) return false;
  yarn.*member = std::clamp(asMultiplier ? twist_per_m(value, tex) : value, info.min, info.max);
  return true;
}

}  // namespace

bool countRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn, std::optional<double>& filament_dtex) {
  int way = yarn.fibresPerPly ? 1 : 0;
  bool changed = false;
  if (segmentField(ui, {"yarn.mass_by", words::yarnPage::massBy}, words::yarnPage::massWays, way)) {
    changed = true;
    if (way == 0) {
      const FieldInfo range = fieldInfo(&Yarn::count_tex);
      yarn.count_tex = std::clamp(yarnCount_tex(yarn, fibre), range.min, range.max);
      yarn.fibresPerPly.reset();
    } else {
      const FieldInfo range = fieldInfo(&Yarn::fibresPerPly);
      const double fibres = std::round(fibresInYarn(yarn, fibre) / singlesIn(yarn));
      yarn.fibresPerPly = static_cast<int>(std::clamp(fibres, range.min, range.max));
    }
  }
  if (yarn.fibresPerPly) {
    const FieldInfo info = fieldInfo(&Yarn::fibresPerPly);
    changed |= wholeNumberField(ui, rowText("yarn", &Yarn::fibresPerPly), "", static_cast<int>(info.min),
                                static_cast<int>(info.max), *yarn.fibresPerPly);
    return changed;
  }
  changed |= countRow(ui, units.count, fibre, yarn, filament_dtex);
  countSystemRow(ui, "yarn", units.count);
  return changed;
}

bool twistRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn) {
  bool changed = memberField(ui, "yarn", yarn, &Yarn::plies);
  twistUnitRow(ui, "yarn", units.twistAsMultiplier);
  const double tex = yarnCount_tex(yarn, fibre);
  const auto level = [&](double strand_tex, double Yarn::* twist, TwistDirection Yarn::* way) {
    // A single yarn has one twist, and nobody calls it that of its singles.
    const bool isOnly = yarn.plies == 1 && yarn.cords == 1;
    const char* const label = isOnly ? words::twist.label : fieldInfo(twist).label;
    changed |= twistRow(ui, label, units.twistAsMultiplier, strand_tex, twist, yarn);
    RowText wayText = rowText("yarn", way);
    if (isOnly) wayText.label = words::twistWay.label;
    changed |= segmentField(ui, wayText, twistNames(), yarn.*way);
  };
  level(tex / singlesIn(yarn), &Yarn::plyTwist_per_m, &Yarn::plyTwistDirection);
  if (yarn.plies > 1) level(tex / yarn.cords, &Yarn::yarnTwist_per_m, &Yarn::yarnTwistDirection);
  if (yarn.plies > 1 || yarn.cords > 1) changed |= memberField(ui, "yarn", yarn, &Yarn::cords);
  if (yarn.cords > 1) level(tex, &Yarn::cableTwist_per_m, &Yarn::cableTwistDirection);
  return changed;
}

void twistNewStrands(const Yarn& before, Yarn& yarn) {
  constexpr double kTakenBack = 0.65;
  const auto back = [](TwistDirection way) { return way == TwistDirection::z ? TwistDirection::s : TwistDirection::z; };
  if (before.plies == 1 && yarn.plies > 1 && yarn.yarnTwist_per_m == 0) {
    yarn.yarnTwist_per_m = std::round(kTakenBack * yarn.plyTwist_per_m);
    yarn.yarnTwistDirection = back(yarn.plyTwistDirection);
  }
  if (before.cords == 1 && yarn.cords > 1 && yarn.cableTwist_per_m == 0) {
    const bool plied = yarn.plies > 1;
    yarn.cableTwist_per_m = std::round(kTakenBack * (plied ? yarn.yarnTwist_per_m : yarn.plyTwist_per_m));
    yarn.cableTwistDirection = back(plied ? yarn.yarnTwistDirection : yarn.plyTwistDirection);
  }
}

bool evennessRows(Ui& ui, Yarn& yarn) {
  if (isMonofilament(yarn)) return false;
  bool changed = memberField(ui, "yarn", yarn, &Yarn::evennessCv_percent, 1, 0.05);
  changed |= memberField(ui, "yarn", yarn, &Yarn::slubs_per_m, 1, 0.05);
  if (yarn.slubs_per_m <= 0) return changed;
  changed |= memberField(ui, "yarn", yarn, &Yarn::slubLength_mm, 0);
  changed |= memberField(ui, "yarn", yarn, &Yarn::slubRatio, 2);
  return changed;
}

bool hairRows(Ui& ui, const Fibre& fibre, Yarn& yarn) {
  bool changed = memberField(ui, "yarn", yarn, &Yarn::hairiness_per_mm, 1, 0.05);
  if (yarn.hairiness_per_mm > 0) {
    changed |= memberField(ui, "yarn", yarn, &Yarn::hairLength_mm, 2);
    NumberStyle style;
    style.max = std::max(40.0, hairinessH(yarn, fibre));
    style.decimals = 1;
    style.perPixel = 0.05;
    double wanted = hairinessH(yarn, fibre);
    if (numberField(ui, {"yarn.hairiness_h", words::hairinessH}, style, wanted)) {
      yarn = withHairinessH(std::move(yarn), fibre, wanted);
      changed = true;
    }
    readout(ui, {"yarn.mean_hair", words::meanHairLength},
            fmt::format("{:.2f} mm", meanHairLength_mm(yarn.hairLength_mm, yarnDiameter_mm(yarn, fibre))));
  }
  return changed | memberField(ui, "yarn", yarn, &Yarn::wrappers_per_cm, 1, 0.05);
}

bool bulkRows(Ui& ui, const Fibre& fibre, Yarn& yarn) {
  bool changed = memberField(ui, "yarn", yarn, &Yarn::packing, 2);
  const FieldInfo packing = fieldInfo(&Yarn::packing);
  const double diameter_mm = yarnDiameter_mm(yarn, fibre);
  // d ~ 1 / sqrt(packing)
  const auto at = [&](double share) { return diameter_mm * std::sqrt(yarn.packing / share); };
  NumberStyle style;
  style.unit = "mm";
  style.min = at(packing.max);
  style.max = at(packing.min);
  style.decimals = 3;
  style.logarithmic = true;
  double wanted = diameter_mm;
  if (numberField(ui, {"yarn.diameter_mm", words::diameter}, style, wanted)) {
    const double ratio = diameter_mm / wanted;
    yarn.packing = std::clamp(yarn.packing * ratio * ratio, packing.min, packing.max);
    changed = true;
  }
  return changed;
}

bool fibreRows(Ui& ui, std::vector<Fibre>& fibres, Yarn& yarn) {
  std::vector<const char*> names;
  for (const Fibre& fibre : fibres) names.push_back(fibre.name.c_str());
  bool changed = choiceField(ui, rowText("yarn", &Yarn::fibre), names, yarn.fibre);
  const int count = static_cast<int>(fibres.size());
  std::vector<const char*> blends = {words::yarnPage::noBlend};
  blends.insert(blends.end(), names.begin(), names.end());
  if (count < kMaxKinds) blends.push_back(words::yarnPage::newFibre);
  int second = yarn.blendFibre.value_or(-1) + 1;
  if (choiceField(ui, {"yarn.blend_fibre", words::yarnPage::blend}, blends, second)) {
    yarn.blendFibre = second > 0 ? std::optional(second - 1) : std::nullopt;
    if (second == count + 1) {
      fibres.push_back(fibres[static_cast<size_t>(yarn.fibre)]);
      const auto isTaken = [&](const std::string& name) {
        return std::any_of(fibres.begin(), fibres.end() - 1, [&](const Fibre& fibre) { return fibre.name == name; });
      };
      fibres.back().name = freshName(fibres.back().name, isTaken);
    }
    changed = true;
  }
  if (!yarn.blendFibre) return changed;
  NumberStyle style;
  style.unit = "%";
  style.max = 100;
  style.decimals = 0;
  style.perPixel = 0.5;
  double percent = 100 * yarn.blendShare.value_or(0.5);
  if (numberField(ui, rowText("yarn", &Yarn::blendShare), style, percent)) {
    yarn.blendShare = 0.01 * percent;
    changed = true;
  }
  return changed;
}

}  // namespace loomlight
