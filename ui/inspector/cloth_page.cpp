#include <fmt/core.h>

#include <algorithm>

#include "core/base/units.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/yarn_need.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/list_field.h"
#include "ui/inspector/mill_rows.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/cloth_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

constexpr const char* kUnknown = words::panels::none;

bool spacingField(Ui& ui, const RowText& text, std::vector<double>& spacing) {
  const std::string expected =
      fmt::format(words::clothPage::spacingExpected, kMostSpacing, kSpacingRange.min, kSpacingRange.max);
  bool changed = false;
  listField(ui, text, spacingText(spacing), words::clothPage::even, expected, [&](const std::string& typed) {
    auto wanted = spacingFromText(typed);
    if (!wanted) return false;
    changed = *wanted != spacing;
    spacing = std::move(*wanted);
    return true;
  });
  return changed;
}

bool settRows(Ui& ui, bool inches, Fabric& fabric) {
  const double cmPerUnit = inches ? kMmPerInch / 10 : 1;
  auto settField = [&](double Fabric::* member) {
    const FieldInfo info = fieldInfo(member);
    NumberStyle style;
    style.unit = inches ? "/in" : info.unit;
    style.min = info.min * cmPerUnit;
    style.max = info.max * cmPerUnit;
    style.logarithmic = true;
    style.decimals = 1;
    double& perCm = fabric.*member;
    double value = perCm * cmPerUnit;
    if (!numberField(ui, rowText("cloth", member), style, value)) return false;
    perCm = std::clamp(value / cmPerUnit, info.min, info.max);
    return true;
  };
  heading(ui, words::clothPage::sett);
  bool changed = settField(&Fabric::ends_per_cm);
  changed |= settField(&Fabric::picks_per_cm);
  changed |= spacingField(ui, {"cloth.warp_spacing", words::warpSpacing}, fabric.warpSpacing);
  changed |= spacingField(ui, {"cloth.weft_spacing", words::weftSpacing}, fabric.weftSpacing);
  changed |= memberField(ui, "cloth", fabric, &Fabric::settCv_percent, 1);
  changed |= memberField(ui, "cloth", fabric, &Fabric::crowding, 1);
  if (inches)
    readout(ui, {"cloth.per_cm", words::clothPage::perCm},
            fmt::format("{:.1f} \xC3\x97 {:.1f}", fabric.ends_per_cm, fabric.picks_per_cm));
  else
    readout(ui, {"cloth.per_inch", words::clothPage::perInch},
            fmt::format("{:.0f} \xC3\x97 {:.0f}", 0.1 * kMmPerInch * fabric.ends_per_cm,
                        0.1 * kMmPerInch * fabric.picks_per_cm));
  return changed;
}

bool finishRows(Ui& ui, Fabric& fabric) {
  heading(ui, words::clothPage::finish);
  bool changed = memberField(ui, "cloth", fabric, &Fabric::press, 2);
  changed |= memberField(ui, "cloth", fabric, &Fabric::crimpBalance, 2);
  changed |= switchField(ui, rowText("cloth", &Fabric::singed), fabric.singed);
  changed |= switchField(ui, rowText("cloth", &Fabric::brushed), fabric.brushed);
  changed |= memberField(ui, "cloth", fabric, &Fabric::milling, 2);
  changed |= switchField(ui, rowText("cloth", &Fabric::mercerised), fabric.mercerised);
  return changed;
}

std::string sizeText(const Fabric& fabric, int64_t ends, int64_t picks, bool inches) {
  const double width_mm = static_cast<double>(ends) * fabric.warpPitch_mm();
  const double height_mm = static_cast<double>(picks) * fabric.weftPitch_mm();
  if (inches) return fmt::format("{:.2f} \xC3\x97 {:.2f} in", width_mm / kMmPerInch, height_mm / kMmPerInch);
  return fmt::format("{:.1f} \xC3\x97 {:.1f} mm", width_mm, height_mm);
}

/// Ends and picks, and below them the size.
void repeatRows(Ui& ui, const Fabric& fabric, const std::string& id, const Word& word, const char* size, int64_t ends,
                int64_t picks, bool inches) {
  readout(ui, {id + "_threads", word.label, word.help}, fmt::format("{} \xC3\x97 {}", ends, picks));
  readout(ui, {id, size, word.help}, sizeText(fabric, ends, picks, inches));
}

void clothRows(Ui& ui, const Fabric& fabric, const InspectorModel& model, CountSystem counts) {
  heading(ui, words::clothPage::thisCloth);
  auto measured = [&](const std::string& text) { return model.measured ? text : std::string(kUnknown); };
  readout(ui, {"cloth.mass", words::mass}, measured(fmt::format("{:.0f} g/m\xC2\xB2", model.arealMass_g_m2)));
  readout(ui, {"cloth.thickness", words::thickness}, measured(fmt::format("{:.2f} mm", model.thickness_mm)));
  const Weave& weave = fabric.weave;
  repeatRows(ui, fabric, "cloth.repeat", words::weaveRepeat, words::weaveSize.label, weave.ends(), weave.picks(),
             model.inches);
  repeatRows(ui, fabric, "cloth.pattern", words::patternRepeat, words::patternSize.label, patternEnds(fabric),
             patternPicks(fabric), model.inches);
  const CoverFactors cover = coverFactors(fabric);
  readout(ui, {"cloth.warp_cover", words::warpCover}, fmt::format("{:.1f}", cover.warp));
  readout(ui, {"cloth.weft_cover", words::weftCover}, fmt::format("{:.1f}", cover.weft));
  readout(ui, {"cloth.cover", words::clothCover}, fmt::format("{:.1f}", cover.cloth));
  readout(ui, {"cloth.crimp_warp", words::clothPage::warpCrimp},
          measured(fmt::format("{:.1f} %", 100 * model.crimpWarp)));
  readout(ui, {"cloth.crimp_weft", words::clothPage::weftCrimp},
          measured(fmt::format("{:.1f} %", 100 * model.crimpWeft)));
  readout(ui, {"cloth.warp_count", words::clothPage::warpCount},
          countText(meanCount_tex(fabric, System::warp), counts));
  readout(ui, {"cloth.weft_count", words::clothPage::weftCount},
          countText(meanCount_tex(fabric, System::weft), counts));
}

void bindingRows(Ui& ui, const Fabric& fabric, const InspectorModel& model) {
  heading(ui, words::clothPage::binding);
  auto floatText = [&](System system, int cells, int unbound) {
    if (unbound > 0) return fmt::format(words::clothPage::unbound, unbound);
    return fmt::format("{} \xC2\xB7 {:.1f} mm", cells, floatLength_mm(fabric, system, cells));
  };
  const bool known = model.floats && model.binding;
  readout(ui, {"cloth.warp_float", words::longestWarpFloat},
          known ? floatText(System::warp, model.floats->warp(), model.floats->idleEnds) : kUnknown);
  readout(ui, {"cloth.weft_float", words::longestWeftFloat},
          known ? floatText(System::weft, model.floats->weft(), model.floats->idlePicks) : kUnknown);
  readout(ui, {"cloth.balance", words::clothPage::warpOnFace},
          known ? fmt::format("{:.0f} %", 100 * model.binding->warpOnFace) : kUnknown);
  readout(ui, {"cloth.interlacings", words::clothPage::interlacings},
          known ? fmt::format("{}", model.binding->warpInterlacings + model.binding->weftInterlacings) : kUnknown);
}

std::string lengthText(double length_m) {
  if (length_m >= 1e4) return fmt::format("{:.1f} km", 1e-3 * length_m);
  return fmt::format("{:.0f} m", length_m);
}

std::string massText(double mass_kg) {
  return mass_kg >= 1 ? fmt::format("{:.2f} kg", mass_kg) : fmt::format("{:.0f} g", 1e3 * mass_kg);
}

void needRow(Ui& ui, const std::string& id, const char* label, const YarnNeed& need) {
  const std::string tooltip =
      fmt::format(words::clothPage::needHelp, label, lengthText(need.warp_m), lengthText(need.weft_m));
  readout(ui, {id, label, tooltip.c_str()},
          fmt::format("{} \xC2\xB7 {}", lengthText(need.warp_m + need.weft_m), massText(need.mass_kg)));
}

void pieceRows(Ui& ui, const Fabric& fabric, const InspectorModel& model, PieceSize& piece) {
  heading(ui, words::clothPage::yarnForPiece);
  pieceSizeRows(ui, "cloth", piece);
  const double crimpWarp = model.measured ? model.crimpWarp : 0, crimpWeft = model.measured ? model.crimpWeft : 0;
  const std::vector<YarnNeed> needs = yarnNeed(fabric, piece, crimpWarp, crimpWeft);
  YarnNeed warp, weft;
  int used = 0;
  for (size_t i = 0; i < needs.size(); ++i) {
    const double all_m = needs[i].warp_m + needs[i].weft_m;
    if (all_m == 0) continue;
    ++used;
    warp.warp_m += needs[i].warp_m;
    weft.weft_m += needs[i].weft_m;
    warp.mass_kg += needs[i].mass_kg * needs[i].warp_m / all_m;
    weft.mass_kg += needs[i].mass_kg * needs[i].weft_m / all_m;
  }
  needRow(ui, "cloth.need_warp", words::panels::systems[0], warp);
  needRow(ui, "cloth.need_weft", words::panels::systems[1], weft);
  if (used < 2) return;
  for (size_t i = 0; i < needs.size(); ++i)
    if (needs[i].warp_m + needs[i].weft_m > 0)
      needRow(ui, fmt::format("cloth.need_{}", i), model.yarns.names[i].c_str(), needs[i]);
}

void remarks(Ui& ui, const InspectorModel& model) {
  heading(ui, words::clothPage::remarks);
  if (!model.warnings || model.warnings->empty()) {
    hint(ui, model.warnings ? words::clothPage::noRemarks : kUnknown);
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
  ImGui::PushTextWrapPos(0);
  for (const std::string& warning : *model.warnings) ImGui::TextUnformatted(warning.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ui.probe.recordItem("cloth.remarks");
}

}  // namespace

std::optional<Fabric> clothPage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  Fabric edited = fabric;
  bool changed = textField(ui, rowText("cloth", &Fabric::name), edited.name);
  changed |= textField(ui, rowText("cloth", &Fabric::description), edited.description);
  changed |= settRows(ui, model.inches, edited);
  changed |= finishRows(ui, edited);
  changed |= millRows(ui, edited, model);
  clothRows(ui, fabric, model, view.units.count);
  bindingRows(ui, fabric, model);
  pieceRows(ui, fabric, model, view.units.piece);
  remarks(ui, model);
  if (!changed) return std::nullopt;
  return edited;
}

}  // namespace loomlight
