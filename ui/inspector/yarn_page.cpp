#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/yarn_fields.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/yarn_words.h"

namespace loomlight {
namespace {

std::optional<Fabric> yarnList(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  yarnChooser(ui, model.yarns, view.yarn, "inspector");
  std::optional<Fabric> edited;
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ui.px(8));
  if (button(ui, "yarn.copy", words::yarnPage::copy.label, half, static_cast<int>(fabric.yarns.size()) < kMaxKinds,
             words::yarnPage::copy.help)) {
    edited = withYarnCopied(fabric, view.yarn);
    view.yarn = static_cast<int>(fabric.yarns.size());
  }
  ImGui::SameLine();
  const bool removable = fabric.yarns.size() > 1 && !isWoven(fabric, view.yarn);
  if (button(ui, "yarn.remove", words::yarnPage::remove.label, half, removable, words::yarnPage::remove.help)) {
    edited = withoutYarn(fabric, view.yarn);
    view.clothColour.wanted.clear();  // fibres have other numbers now
    view.yarn = std::max(0, view.yarn - 1);
  }
  return edited;
}

/// Fills in a yarn of the trade. Its fibre comes along, dyed as this yarn is; name and blend are the designer's.
std::optional<Fabric> presetRow(Ui& ui, const Fabric& fabric, int index) {
  const std::vector<YarnPreset> presets = yarnPresets();
  std::vector<const char*> names;
  for (const YarnPreset& preset : presets) names.push_back(preset.yarn.name.c_str());
  int chosen = -1;
  if (!choiceField(ui, {"yarn.preset", words::yarnPage::preset}, names, chosen, words::yarnPage::tradeYarns))
    return std::nullopt;
  const YarnPreset& preset = presets[static_cast<size_t>(chosen)];
  const Fibre& old = fabric.fibres[static_cast<size_t>(fabric.yarns[static_cast<size_t>(index)].fibre)];
  return withYarn(fabric, index, preset.yarn, dyedLike(preset.fibre, old));
}

/// Of the yarn as its section is drawn, flattened as in the cloth; its diameter until that is known.
std::string sizeText(const YarnSection* section, double diameter_mm) {
  const std::string wide = fmt::format("{:.2f}", section ? 2 * section->halfWidth_mm : diameter_mm);
  const std::string high = section ? fmt::format("{:.2f}", 2 * section->halfHeight_mm) : wide;
  return wide == high ? fmt::format(words::yarnPage::round, wide) : fmt::format("{} \xC3\x97 {} mm", wide, high);
}

/// As the yarn looks in the cloth. The two fibres of a blend are told apart by how they differ in a thick mass:
/// together they are as light, and of the hue, that the yarn is.
YarnFibreColours sectionColours(const Yarn& yarn, const std::vector<Fibre>& fibres, const ImVec4& reached) {
  if (!yarn.blendFibre) return {reached, reached};
  const Rgb first = fibreReflectance(fibres[static_cast<size_t>(yarn.fibre)]);
  const Rgb second = fibreReflectance(fibres[static_cast<size_t>(*yarn.blendFibre)]);
  const Rgb both = glm::mix(first, second, static_cast<float>(yarn.blendShare.value_or(0.5)));
  const Rgb seen = toLinearColour(reached) / glm::max(both, Rgb(1e-4f));
  return {toDisplayColour(first * seen), toDisplayColour(second * seen)};
}

}  // namespace

std::optional<Fabric> yarnPage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  if (auto edited = yarnList(ui, fabric, model, view)) return edited;
  Yarn yarn = fabric.yarns[static_cast<size_t>(view.yarn)];
  std::vector<Fibre> fibres = fabric.fibres;
  const Fibre fibre = meanFibre(yarn, fibres);

  const YarnFibreColours colours = sectionColours(yarn, fibres, model.yarns.colours[static_cast<size_t>(view.yarn)]);
  const ImVec2 half(0.5f * (ImGui::GetContentRegionAvail().x - ui.px(8)), ui.px(kCloseUpHeight));
  drawYarnSection(ui, model.section ? *model.section : YarnSection{}, colours, half);
  ImGui::SameLine(0, ui.px(8));
  drawYarnCloseUp(ui, model.closeUp, half);
  quietLine(ui, "yarn.summary",
            fmt::format(words::yarnPage::summary, countText(yarnCount_tex(yarn, fibre), view.units.count),
                        sizeText(model.section, yarnDiameter_mm(yarn, fibre)), fibresInYarn(yarn, fibre)));

  const std::string& called = model.yarns.names[static_cast<size_t>(view.yarn)];
  bool changed = textField(ui, rowText("yarn", &Yarn::name), yarn.name, called.c_str());
  ui.probe.fact("yarn.called", called);
  std::optional<Fabric> filled = presetRow(ui, fabric, view.yarn);
  changed |= fibreRows(ui, fibres, yarn);
  std::optional<double> filament_dtex;
  changed |= countRows(ui, fibre, view.units, yarn, filament_dtex);
  changed |= twistRows(ui, fibre, view.units, yarn);
  changed |= bulkRows(ui, fibre, yarn);
  changed |= memberField(ui, "yarn", yarn, &Yarn::flattening, 2);
  changed |= memberChoice(ui, "yarn", yarn, &Yarn::layout, layoutNames());
  changed |= memberField(ui, "yarn", yarn, &Yarn::migration, 2);
  changed |= memberField(ui, "yarn", yarn, &Yarn::fibreDisorder_deg, 1);
  changed |= hairRows(ui, fibre, yarn);
  changed |= evennessRows(ui, yarn);
  changed |= memberField(ui, "yarn", yarn, &Yarn::shadeVariation_percent, 1, 0.05);
  visibilitySection(ui, model.visibility, view.visibilityOpen);
  if (filled || !changed) return filled;
  twistNewStrands(fabric.yarns[static_cast<size_t>(view.yarn)], yarn);
  Fabric edited = fabric;
  if (fibres.size() > edited.fibres.size()) addFibre(edited, std::move(fibres.back()), yarn.fibre);
  Fibre filament = edited.fibres[static_cast<size_t>(yarn.fibre)];
  edited.yarns[static_cast<size_t>(view.yarn)] = std::move(yarn);
  if (!filament_dtex) return edited;
  filament.radius_um = fibreRadius_um(*filament_dtex, filament.density_g_cm3);
  return withFibre(std::move(edited), view.yarn, std::move(filament));
}

}  // namespace loomlight
