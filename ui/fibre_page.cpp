#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/colour.h"
#include "core/fabric/presets.h"
#include "core/fabric/yarn_count.h"
#include "ui/choices.h"
#include "ui/inspector.h"
#include "ui/member_fields.h"

namespace loomlight {
namespace {

Rgb colourOf(const Fibre& fibre) {
  return colourFromAbsorption(fibre.absorption_per_mm, fibre.azimuthalRoughness, fibre.radius_um);
}

void dye(Fibre& fibre, const Rgb& colour) {
  fibre.absorption_per_mm =
      glm::clamp(absorptionFromColour(colour, fibre.azimuthalRoughness, fibre.radius_um), Rgb(0.0f), Rgb(10000.0f));
}

/// The preset whose optics and fineness this fibre has; -1 for none. Colour and name are the designer's.
int presetOf(const Fibre& fibre, const std::vector<FibrePreset>& presets) {
  for (size_t i = 0; i < presets.size(); ++i) {
    Fibre same = presets[i].fibre;
    same.name = fibre.name;
    same.absorption_per_mm = fibre.absorption_per_mm;
    same.unknown = fibre.unknown;
    if (same == fibre) return static_cast<int>(i);
  }
  return -1;
}

bool presetRow(Ui& ui, Fibre& fibre) {
  const std::vector<FibrePreset> presets = fibrePresets();
  std::vector<const char*> names;
  for (const FibrePreset& preset : presets) names.push_back(preset.fibre.name.c_str());
  int chosen = presetOf(fibre, presets);
  const std::string provenance = chosen >= 0 ? presets[static_cast<size_t>(chosen)].provenance : std::string();
  const std::string tooltip = "Fills in fineness, optics and section, and keeps the colour." +
                              (provenance.empty() ? std::string() : "\n\n" + provenance);
  if (!choiceField(ui, {"fibre.preset", "Kind", tooltip.c_str()}, names, chosen, "Own values")) return false;
  const Rgb colour = colourOf(fibre);
  Fibre filled = presets[static_cast<size_t>(chosen)].fibre;
  filled.name = fibre.name;
  filled.unknown = fibre.unknown;
  dye(filled, colour);
  fibre = filled;
  return true;
}

bool absorptionRows(Ui& ui, Fibre& fibre) {
  static constexpr const char* kIds[] = {"fibre.absorption_r", "fibre.absorption_g", "fibre.absorption_b"};
  static constexpr const char* kLabels[] = {"Absorption red", "Absorption green", "Absorption blue"};
  const FieldInfo info = fieldInfo(&Fibre::absorption_per_mm);
  NumberStyle style;
  style.unit = info.unit;
  style.min = info.min;
  style.max = info.max;
  style.logarithmic = true;
  style.decimals = 1;
  bool changed = false;
  for (int i = 0; i < 3; ++i) {
    double value = fibre.absorption_per_mm[i];
    if (!numberField(ui, {kIds[i], kLabels[i], info.help}, style, value)) continue;
    fibre.absorption_per_mm[i] = static_cast<float>(value);
    changed = true;
  }
  return changed;
}

std::string usersOf(const Fabric& fabric, int fibre, int except) {
  std::string names;
  for (int i = 0; i < static_cast<int>(fabric.yarns.size()); ++i) {
    if (i == except || fabric.yarns[static_cast<size_t>(i)].fibre != fibre) continue;
    if (!names.empty()) names += ", ";
    names += fabric.yarns[static_cast<size_t>(i)].name;
  }
  return names;
}

}  // namespace

std::optional<Fabric> fibrePage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  yarnChooser(ui, fabric, model.yarnColours, view.yarn, "inspector");
  const Yarn& yarn = fabric.yarns[static_cast<size_t>(view.yarn)];
  const int index = yarn.fibre;
  Fibre fibre = fabric.fibres[static_cast<size_t>(index)];
  hint(ui, fmt::format("The fibre of {}.", yarn.name));

  bool changed = textField(ui, rowText("fibre", &Fibre::name), fibre.name);
  changed |= presetRow(ui, fibre);

  heading(ui, "Colour");
  Rgb colour = colourOf(fibre);
  if (colourField(ui,
                  {"fibre.colour", "In a thick mass",
                   "The colour that a bundle of this fibre shows, sRGB with the "
                   "white of daylight (D65). Cloth that light comes through "
                   "looks paler."},
                  colour)) {
    dye(fibre, colour);
    changed = true;
  }
  changed |= absorptionRows(ui, fibre);

  heading(ui, "Fineness");
  changed |= memberField(ui, "fibre", fibre, &Fibre::radius_um, 1);
  changed |= memberField(ui, "fibre", fibre, &Fibre::density_g_cm3, 2);
  readout(ui, {"fibre.fineness", "Fineness", "Mass of ten kilometres of one fibre, from its radius and density"},
          fmt::format("{:.2f} dtex", fibreFineness_dtex(fibre)));

  heading(ui, "Optics");
  changed |= memberField(ui, "fibre", fibre, &Fibre::refractiveIndex, 2);
  changed |= memberField(ui, "fibre", fibre, &Fibre::longitudinalRoughness, 2);
  changed |= memberField(ui, "fibre", fibre, &Fibre::azimuthalRoughness, 2);
  changed |= memberField(ui, "fibre", fibre, &Fibre::scaleTilt_deg, 1);
  changed |= memberChoice(ui, "fibre", fibre, &Fibre::section, fibreSectionNames());

  const std::string others = usersOf(fabric, index, view.yarn);
  std::optional<Fabric> edited;
  if (!others.empty()) {
    hint(ui, "Also the fibre of " + others + ".");
    if (button(ui, "fibre.own", "Give this yarn its own", 0, fabric.fibres.size() < 64)) {
      edited = fabric;
      edited->yarns[static_cast<size_t>(view.yarn)].fibre = static_cast<int>(fabric.fibres.size());
      edited->fibres.push_back(fibre);
      return edited;
    }
  }
  if (!changed) return std::nullopt;
  edited = fabric;
  edited->fibres[static_cast<size_t>(index)] = std::move(fibre);
  return edited;
}

}  // namespace loomlight
