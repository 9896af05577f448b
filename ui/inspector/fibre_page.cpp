#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/colour.h"
#include "core/fabric/yarn/dyeing.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "ui/inspector/count_text.h"
#include "ui/inspector/inspector.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/fibre_words.h"

namespace loomlight {
namespace {

void dye(Fibre& fibre, const Rgb& colour) {
  fibre.absorption_per_mm =
      glm::clamp(absorptionFromColour(colour, fibre.azimuthalRoughness, fibre.radius_um), Rgb(0.0f), Rgb(10000.0f));
}

/// A kind of fibre, and how many of its numbers this fibre has.
int agreement(const Fibre& fibre, const Fibre& kind) {
  return (fibre.radius_um == kind.radius_um) + (fibre.density_g_cm3 == kind.density_g_cm3) +
         (fibre.refractiveIndex == kind.refractiveIndex) + (fibre.longitudinalRoughness == kind.longitudinalRoughness) +
         (fibre.azimuthalRoughness == kind.azimuthalRoughness) + (fibre.scaleTilt_deg == kind.scaleTilt_deg) +
         (fibre.section == kind.section);
}

/// The kind that it has most numbers of; null where it has hardly any. Colour and name are the designer's.
const FibrePreset* kindOf(const Fibre& fibre, const std::vector<FibrePreset>& presets) {
  constexpr int kFewest = 4;
  const auto most = std::max_element(presets.begin(), presets.end(), [&](const FibrePreset& a, const FibrePreset& b) {
    return agreement(fibre, a.fibre) < agreement(fibre, b.fibre);
  });
  return agreement(fibre, most->fibre) >= kFewest ? &*most : nullptr;
}

bool presetRow(Ui& ui, Fibre& fibre, const std::vector<FibrePreset>& presets, const FibrePreset* kind) {
  std::vector<const char*> names;
  for (const FibrePreset& preset : presets) names.push_back(preset.fibre.name.c_str());
  constexpr int kAll = 7;
  const bool whole = kind && agreement(fibre, kind->fibre) == kAll;
  int chosen = whole ? static_cast<int>(kind - presets.data()) : -1;
  const std::string otherwise =
      kind ? fmt::format(words::fibrePage::muchLike, kind->fibre.name) : words::fibrePage::ownValues;
  if (!choiceField(ui, {"fibre.preset", words::fibrePage::preset}, names, chosen, otherwise.c_str())) return false;
  Fibre filled = presets[static_cast<size_t>(chosen)].fibre;
  const bool namedAsKind = std::any_of(presets.begin(), presets.end(),
                                       [&](const FibrePreset& preset) { return preset.fibre.name == fibre.name; });
  if (!namedAsKind) filled.name = fibre.name;
  filled.unknown = fibre.unknown;
  fibre = dyedLike(std::move(filled), fibre);
  return true;
}

/// A number, and in its tooltip where it is from, or what its kind has.
bool sourcedField(Ui& ui, Fibre& fibre, double Fibre::* member, int decimals, const FibrePreset* kind,
                  const char* FibreSources::* source) {
  const FieldInfo info = fieldInfo(member);
  NumberStyle style;
  style.unit = info.unit;
  style.min = info.min;
  style.max = info.max;
  style.logarithmic = info.logarithmic;
  style.decimals = decimals;
  std::string help = info.help;
  if (kind && kind->fibre.*member == fibre.*member)
    help = fmt::format(words::fibrePage::sourceOf, info.help, kind->fibre.name, kind->sources.*source);
  else if (kind)
    help = fmt::format(words::fibrePage::ownNumber, info.help, kind->fibre.name, kind->fibre.*member, decimals,
                       info.unit, kind->sources.*source);
  return numberField(ui, {std::string("fibre.") + info.key, info.label, help.c_str()}, style, fibre.*member);
}

bool absorptionRows(Ui& ui, Fibre& fibre) {
  static constexpr const char* kIds[] = {"fibre.absorption_r", "fibre.absorption_g", "fibre.absorption_b"};
  static constexpr const char* kLabels[] = {words::depthRed.label, words::depthGreen.label, words::depthBlue.label};
  const Absorption& known = fibre.absorption_per_mm;
  const std::string said = known.bands          ? words::fibrePage::bands
                           : known.dyes.empty() ? words::fibrePage::threeDepths
                                                : fmt::format(words::fibrePage::recipe, known.dyes.size());
  readout(ui, {"fibre.absorption_known", words::absorptionKnown}, said);
  const FieldInfo info = fieldInfo(&Fibre::absorption_per_mm);
  NumberStyle style;
  style.unit = info.unit;
  style.min = info.min;
  style.max = info.max;
  style.logarithmic = true;
  style.decimals = 1;
  bool changed = false;
  for (int i = 0; i < 3; ++i) {
    double value = fibre.absorption_per_mm.primaries[i];
    if (!numberField(ui, {kIds[i], kLabels[i], info.help}, style, value)) continue;
    fibre.absorption_per_mm.primaries[i] = static_cast<float>(value);
    changed = true;
  }
  return changed;
}

/// Yarns that are spun of a fibre, but for one.
std::string usersOf(const Fabric& fabric, int fibre, int except, const ShownYarns& shown) {
  std::string names;
  for (int i = 0; i < static_cast<int>(fabric.yarns.size()); ++i) {
    const Yarn& yarn = fabric.yarns[static_cast<size_t>(i)];
    if (i == except || (yarn.fibre != fibre && yarn.blendFibre != fibre)) continue;
    if (!names.empty()) names += ", ";
    names += shown.names[static_cast<size_t>(i)];
  }
  return names;
}

/// Which of a blend's fibres is looked at; the first of any other yarn.
void blendRow(Ui& ui, const Yarn& yarn, InspectorView& view) {
  if (!yarn.blendFibre) {
    view.secondFibre = false;
    return;
  }
  segmentField(ui, {"fibre.of_blend", words::fibrePage::ofBlend}, words::fibrePage::fibresOfBlend, view.secondFibre);
}

/// The same as the radius, as fibres are traded.
bool finenessField(Ui& ui, Fibre& fibre) {
  const FieldInfo radius = fieldInfo(&Fibre::radius_um);
  const auto at = [&](double radius_um) {
    Fibre other = fibre;
    other.radius_um = radius_um;
    return fibreFineness_dtex(other);
  };
  NumberStyle style;
  style.unit = "dtex";
  style.min = at(radius.min);
  style.max = at(radius.max);
  style.logarithmic = true;
  style.parse = [&](std::string_view text) { return finenessFromText(text, fibre.density_g_cm3); };
  style.otherwise = words::fibrePage::finenessLooksLike;
  double fineness_dtex = fibreFineness_dtex(fibre);
  if (!numberField(ui, {"fibre.fineness", words::fibreFineness}, style, fineness_dtex)) return false;
  fibre.radius_um = std::clamp(fibreRadius_um(fineness_dtex, fibre.density_g_cm3), radius.min, radius.max);
  return true;
}

void finenessRows(Ui& ui, Fibre& fibre, const FibrePreset* kind, bool& changed) {
  heading(ui, words::fibrePage::fineness);
  changed |= sourcedField(ui, fibre, &Fibre::radius_um, 1, kind, &FibreSources::fineness);
  changed |= sourcedField(ui, fibre, &Fibre::density_g_cm3, 2, kind, &FibreSources::density);
  changed |= finenessField(ui, fibre);
}

void opticsRows(Ui& ui, Fibre& fibre, const FibrePreset* kind, bool& changed) {
  heading(ui, words::fibrePage::optics);
  changed |= sourcedField(ui, fibre, &Fibre::refractiveIndex, 3, kind, &FibreSources::refractiveIndex);
  changed |= sourcedField(ui, fibre, &Fibre::longitudinalRoughness, 2, kind, &FibreSources::roughness);
  changed |= sourcedField(ui, fibre, &Fibre::azimuthalRoughness, 2, kind, &FibreSources::roughness);
  changed |= sourcedField(ui, fibre, &Fibre::scaleTilt_deg, 1, kind, &FibreSources::scaleTilt);
  changed |= memberChoice(ui, "fibre", fibre, &Fibre::section, fibreSectionNames());
}

}  // namespace

std::optional<Fabric> fibrePage(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  yarnChooser(ui, model.yarns, view.yarn, "inspector");
  const Yarn& yarn = fabric.yarns[static_cast<size_t>(view.yarn)];
  quietLine(ui, "fibre.of", fmt::format(words::fibrePage::fibreOf, model.yarns.names[static_cast<size_t>(view.yarn)]));
  blendRow(ui, yarn, view);
  const int index = shownFibre(fabric, view);
  Fibre fibre = fabric.fibres[static_cast<size_t>(index)];
  const std::vector<FibrePreset> presets = fibrePresets();
  const FibrePreset* const kind = kindOf(fibre, presets);

  bool changed = textField(ui, rowText("fibre", &Fibre::name), fibre.name);
  changed |= presetRow(ui, fibre, presets, kind);
  heading(ui, words::fibrePage::colour);
  clothColourRows(ui, view.clothColour.dyed(view.yarn, index), model.clothColour, view.clothColour);
  Rgb colour = fibreReflectance(fibre);
  if (colourField(ui, {"fibre.colour", words::looseStock}, colour)) {
    dye(fibre, colour);
    fibre.name = nameOnceDyed(fabric, index);
    changed = true;
  }
  changed |= absorptionRows(ui, fibre);
  finenessRows(ui, fibre, kind, changed);
  opticsRows(ui, fibre, kind, changed);

  const std::string others = usersOf(fabric, index, view.yarn, model.yarns);
  if (!others.empty()) {
    hint(ui, fmt::format(words::fibrePage::alsoFibreOf, others));
    if (button(ui, "fibre.own", words::fibrePage::giveOwn, 0, static_cast<int>(fabric.fibres.size()) < kMaxKinds)) {
      Fabric edited = fabric;
      Yarn& own = edited.yarns[static_cast<size_t>(view.yarn)];
      (view.secondFibre ? *own.blendFibre : own.fibre) = addFibre(edited, fibre, index);
      return edited;
    }
  }
  if (!changed) return std::nullopt;
  Fabric edited = fabric;
  edited.fibres[static_cast<size_t>(index)] = std::move(fibre);
  return edited;
}

}  // namespace loomlight
