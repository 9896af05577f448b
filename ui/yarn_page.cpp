#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/validate.h"
#include "core/fabric/yarn_count.h"
#include "ui/choices.h"
#include "ui/count_text.h"
#include "ui/inspector.h"
#include "ui/member_fields.h"

namespace loomlight {
namespace {

bool isUsed(const Fabric& fabric, int yarn) {
  auto has = [&](const std::vector<int>& sequence) {
    return std::find(sequence.begin(), sequence.end(), yarn) != sequence.end();
  };
  return has(fabric.warpSequence) || has(fabric.weftSequence);
}

Fabric withYarnCopied(const Fabric& fabric, int yarn) {
  Fabric edited = fabric;
  Yarn copy = fabric.yarns[static_cast<size_t>(yarn)];
  Fibre fibre = fabric.fibres[static_cast<size_t>(copy.fibre)];
  copy.name += " copy";
  if (static_cast<int>(fabric.fibres.size()) < kMaxKinds) {
    // A new yarn is wanted for a new colour more often than not, so it gets a fibre of its own.
    copy.fibre = static_cast<int>(fabric.fibres.size());
    edited.fibres.push_back(std::move(fibre));
  }
  edited.yarns.push_back(std::move(copy));
  return edited;
}

Fabric withoutYarn(const Fabric& fabric, int yarn) {
  Fabric edited = fabric;
  edited.yarns.erase(edited.yarns.begin() + yarn);
  for (std::vector<int>* sequence : {&edited.warpSequence, &edited.weftSequence})
    for (int& index : *sequence)
      if (index > yarn) --index;
  return edited;
}

std::optional<Fabric> yarnList(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  yarnChooser(ui, fabric, model.yarnColours, view.yarn, "inspector");
  std::optional<Fabric> edited;
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ui.px(8));
  if (button(ui, "yarn.copy", "New from this", half, static_cast<int>(fabric.yarns.size()) < kMaxKinds,
             "Add a yarn that begins as a copy of this one")) {
    edited = withYarnCopied(fabric, view.yarn);
    view.yarn = static_cast<int>(fabric.yarns.size());
  }
  ImGui::SameLine();
  const bool removable = fabric.yarns.size() > 1 && !isUsed(fabric, view.yarn);
  if (button(ui, "yarn.remove", "Remove", half, removable, "A yarn can be removed when no end and no pick uses it")) {
    edited = withoutYarn(fabric, view.yarn);
    view.yarn = std::max(0, view.yarn - 1);
  }
  return edited;
}

/// Mass by the count, or by how many fibres there are.
bool massRows(Ui& ui, Yarn& yarn, const Fibre& fibre) {
  static constexpr const char* kNames[] = {"Count", "Fibres"};
  int way = yarn.fibresPerPly ? 1 : 0;
  bool changed = false;
  if (segmentField(ui,
                   {"yarn.mass_by", "Fineness by",
                    "A spinner says how thick a yarn is by its count. For few, "
                    "coarse fibres it is easier to say how many there are."},
                   kNames, way)) {
    changed = true;
    if (way == 0) {
      yarn.count_tex = std::clamp(yarnCount_tex(yarn, fibre), 0.5, 5000.0);
      yarn.fibresPerPly.reset();
    } else {
      yarn.fibresPerPly = std::clamp(static_cast<int>(std::lround(fibresInYarn(yarn, fibre) / yarn.plies)), 1, 2000);
    }
  }
  if (yarn.fibresPerPly) {
    const FieldInfo info = fieldInfo(&Yarn::fibresPerPly);
    changed |= wholeNumberField(ui, rowText("yarn", &Yarn::fibresPerPly), "", static_cast<int>(info.min),
                                static_cast<int>(info.max), *yarn.fibresPerPly);
    return changed;
  }
  const FieldInfo info = fieldInfo(&Yarn::count_tex);
  NumberStyle style;
  style.unit = info.unit;
  style.min = info.min;
  style.max = info.max;
  style.logarithmic = true;
  style.decimals = 1;
  style.parse = texFromText;
  changed |= numberField(ui,
                         {"yarn.count_tex", info.label,
                          "How thick the yarn is: grams of one kilometre. Typed counts are understood too: "
                          "30/2 Ne, 2/60 Nm, 150 den."},
                         style, yarn.count_tex);
  return changed;
}

bool twistRows(Ui& ui, Yarn& yarn) {
  constexpr double kTurnsPerPixel = 4.0;
  bool changed = memberField(ui, "yarn", yarn, &Yarn::plyTwist_per_m, 0, kTurnsPerPixel);
  changed |= memberChoice(ui, "yarn", yarn, &Yarn::plyTwistDirection, twistNames());
  if (yarn.plies < 2) return changed;
  changed |= memberField(ui, "yarn", yarn, &Yarn::yarnTwist_per_m, 0, kTurnsPerPixel);
  changed |= memberChoice(ui, "yarn", yarn, &Yarn::yarnTwistDirection, twistNames());
  return changed;
}

}  // namespace

std::optional<Fabric> yarnPage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  if (auto edited = yarnList(ui, fabric, model, view)) return edited;
  Yarn yarn = fabric.yarns[static_cast<size_t>(view.yarn)];
  const Fibre& fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];

  drawYarnSection(ui, model.section ? *model.section : YarnSection{}, model.yarnColours[static_cast<size_t>(view.yarn)],
                  ui.px(128));
  hint(ui, fmt::format("{:.1f} tex  \xC2\xB7  {:.2f} mm across  \xC2\xB7  {:.0f} fibres", yarnCount_tex(yarn, fibre),
                       yarnDiameter_mm(yarn, fibre), fibresInYarn(yarn, fibre)));

  bool changed = textField(ui, rowText("yarn", &Yarn::name), yarn.name);
  std::vector<const char*> fibreNames;
  for (const Fibre& f : fabric.fibres) fibreNames.push_back(f.name.c_str());
  changed |= choiceField(ui, rowText("yarn", &Yarn::fibre), fibreNames, yarn.fibre);
  changed |= massRows(ui, yarn, fibre);
  changed |= memberField(ui, "yarn", yarn, &Yarn::plies);
  changed |= twistRows(ui, yarn);
  changed |= memberField(ui, "yarn", yarn, &Yarn::packing, 2);
  changed |= memberField(ui, "yarn", yarn, &Yarn::flattening, 2);
  changed |= memberChoice(ui, "yarn", yarn, &Yarn::layout, layoutNames());
  changed |= memberField(ui, "yarn", yarn, &Yarn::migration, 2);
  changed |= memberField(ui, "yarn", yarn, &Yarn::hairiness_per_mm, 1, 0.05);
  if (yarn.hairiness_per_mm > 0) changed |= memberField(ui, "yarn", yarn, &Yarn::hairLength_mm, 2);
  visibilitySection(ui, model.visibility, view.visibilityOpen);
  if (!changed) return std::nullopt;
  Fabric edited = fabric;
  edited.yarns[static_cast<size_t>(view.yarn)] = std::move(yarn);
  return edited;
}

}  // namespace loomlight
