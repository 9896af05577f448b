#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/yarn_need.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/mill_rows.h"
#include "ui/widgets/member_fields.h"

namespace loomlight {
namespace {

constexpr const char* kUnknown = "\xE2\x80\x93";
constexpr double kMmPerInch = 25.4;

bool settRows(Ui& ui, bool inches, double& ends, double& picks) {
  const double cmPerUnit = inches ? kMmPerInch / 10 : 1;
  auto settField = [&](double Fabric::* member, double& perCm) {
    const FieldInfo info = fieldInfo(member);
    NumberStyle style;
    style.unit = inches ? "/in" : info.unit;
    style.min = info.min * cmPerUnit;
    style.max = info.max * cmPerUnit;
    style.logarithmic = true;
    style.decimals = 1;
    double value = perCm * cmPerUnit;
    if (!numberField(ui, rowText("cloth", member), style, value)) return false;
    perCm = std::clamp(value / cmPerUnit, info.min, info.max);
    return true;
  };
  heading(ui, "Sett");
  bool changed = settField(&Fabric::ends_per_cm, ends);
  changed |= settField(&Fabric::picks_per_cm, picks);
  if (inches)
    readout(ui, {"cloth.per_cm", "Per cm", "Ends and picks on one centimetre"},
            fmt::format("{:.1f} \xC3\x97 {:.1f}", ends, picks));
  else
    readout(ui, {"cloth.per_inch", "Per inch", "Ends and picks on one inch"},
            fmt::format("{:.0f} \xC3\x97 {:.0f}", 0.1 * kMmPerInch * ends, 0.1 * kMmPerInch * picks));
  return changed;
}

bool finishRows(Ui& ui, Fabric& fabric) {
  heading(ui, "Finish");
  bool changed = memberField(ui, "cloth", fabric, &Fabric::press, 2);
  changed |= memberField(ui, "cloth", fabric, &Fabric::crimpBalance, 2);
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
  heading(ui, "This cloth");
  auto measured = [&](const std::string& text) { return model.measured ? text : std::string(kUnknown); };
  const auto worded = [](const char* id, const Word& word) { return RowText{id, word.label, word.help}; };
  readout(ui, worded("cloth.mass", words::mass), measured(fmt::format("{:.0f} g/m\xC2\xB2", model.arealMass_g_m2)));
  readout(ui, worded("cloth.thickness", words::thickness), measured(fmt::format("{:.2f} mm", model.thickness_mm)));
  const Weave& weave = fabric.weave;
  repeatRows(ui, fabric, "cloth.repeat", words::weaveRepeat, words::weaveSize.label, weave.ends(), weave.picks(),
             model.inches);
  repeatRows(ui, fabric, "cloth.pattern", words::patternRepeat, words::patternSize.label, patternEnds(fabric),
             patternPicks(fabric), model.inches);
  const CoverFactors cover = coverFactors(fabric);
  readout(ui, worded("cloth.warp_cover", words::warpCover), fmt::format("{:.1f}", cover.warp));
  readout(ui, worded("cloth.weft_cover", words::weftCover), fmt::format("{:.1f}", cover.weft));
  readout(ui, worded("cloth.cover", words::clothCover), fmt::format("{:.1f}", cover.cloth));
  readout(ui, {"cloth.crimp_warp", "Warp crimp", "How much longer the warp yarn is than the cloth it lies in"},
          measured(fmt::format("{:.1f} %", 100 * model.crimpWarp)));
  readout(ui, {"cloth.crimp_weft", "Weft crimp", "How much longer the weft yarn is than the cloth it lies in"},
          measured(fmt::format("{:.1f} %", 100 * model.crimpWeft)));
  readout(ui, {"cloth.warp_count", "Warp count", "Mean count of the warp yarns"},
          countText(meanCount_tex(fabric, System::warp), counts));
  readout(ui, {"cloth.weft_count", "Weft count", "Mean count of the weft yarns"},
          countText(meanCount_tex(fabric, System::weft), counts));
}

void bindingRows(Ui& ui, const Fabric& fabric, const InspectorModel& model) {
  heading(ui, "Binding");
  auto floatText = [&](System system, int cells, int unbound) {
    if (unbound > 0) return fmt::format("{} unbound", unbound);
    return fmt::format("{} \xC2\xB7 {:.1f} mm", cells, floatLength_mm(fabric, system, cells));
  };
  const bool known = model.floats && model.binding;
  readout(ui, {"cloth.warp_float", words::longestWarpFloat.label, words::longestWarpFloat.help},
          known ? floatText(System::warp, model.floats->warp(), model.floats->idleEnds) : kUnknown);
  readout(ui, {"cloth.weft_float", words::longestWeftFloat.label, words::longestWeftFloat.help},
          known ? floatText(System::weft, model.floats->weft(), model.floats->idlePicks) : kUnknown);
  readout(ui,
          {"cloth.balance", "Warp on the face",
           "Share of the crossings with the warp on top: at 50 % face and back are alike"},
          known ? fmt::format("{:.0f} %", 100 * model.binding->warpOnFace) : kUnknown);
  readout(ui, {"cloth.interlacings", "Interlacings", "Changes of side in one repeat, of all its ends and picks"},
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
  const std::string tooltip = fmt::format("{}: warp {}, weft {}. Loom waste and shrinkage are not counted.", label,
                                          lengthText(need.warp_m), lengthText(need.weft_m));
  readout(ui, {id, label, tooltip.c_str()},
          fmt::format("{} \xC2\xB7 {}", lengthText(need.warp_m + need.weft_m), massText(need.mass_kg)));
}

void pieceRows(Ui& ui, const Fabric& fabric, const InspectorModel& model, PieceSize& piece) {
  heading(ui, "Yarn for a piece");
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
  needRow(ui, "cloth.need_warp", "Warp", warp);
  needRow(ui, "cloth.need_weft", "Weft", weft);
  if (used < 2) return;
  for (size_t i = 0; i < needs.size(); ++i)
    if (needs[i].warp_m + needs[i].weft_m > 0)
      needRow(ui, fmt::format("cloth.need_{}", i), model.yarns.names[i].c_str(), needs[i]);
}

void remarks(Ui& ui, const InspectorModel& model) {
  heading(ui, "Remarks");
  if (!model.warnings || model.warnings->empty()) {
    hint(ui, model.warnings ? "Nothing that a weaver would object to." : kUnknown);
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
  changed |= settRows(ui, model.inches, edited.ends_per_cm, edited.picks_per_cm);
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
