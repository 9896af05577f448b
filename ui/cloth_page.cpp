#include <fmt/core.h>

#include "core/fabric/derived.h"
#include "core/fabric/yarn_count.h"
#include "ui/inspector.h"
#include "ui/member_fields.h"

namespace loomlight {

std::optional<Fabric> clothPage(Ui& ui, const Fabric& fabric, const InspectorModel& model) {
  std::string name = fabric.name, description = fabric.description;
  double ends = fabric.ends_per_cm, picks = fabric.picks_per_cm;
  bool changed = textField(ui, rowText("cloth", &Fabric::name), name);
  changed |= textField(ui, rowText("cloth", &Fabric::description), description);

  heading(ui, "Sett");
  auto settField = [&](double Fabric::*member, double& value) {
    const FieldInfo info = fieldInfo(member);
    NumberStyle style;
    style.unit = info.unit;
    style.min = info.min;
    style.max = info.max;
    style.logarithmic = true;
    style.decimals = 1;
    return numberField(ui, rowText("cloth", member), style, value);
  };
  changed |= settField(&Fabric::ends_per_cm, ends);
  changed |= settField(&Fabric::picks_per_cm, picks);

  heading(ui, "This cloth");
  const CoverFactors cover = coverFactors(fabric);
  readout(ui, {"cloth.repeat", "Repeat", "Size of one repeat of the weave"},
          fmt::format("{:.1f} \xC3\x97 {:.1f} mm", fabric.weave.ends() * fabric.warpPitch_mm(),
                      fabric.weave.picks() * fabric.weftPitch_mm()));
  readout(ui, {"cloth.warp_cover", "Warp cover", "Peirce's cover factor of the warp; at 28 round yarns touch"},
          fmt::format("{:.1f}", cover.warp));
  readout(ui, {"cloth.weft_cover", "Weft cover", "Peirce's cover factor of the weft; at 28 round yarns touch"},
          fmt::format("{:.1f}", cover.weft));
  auto crimp = [&](double value) {
    return model.measured ? fmt::format("{:.1f} %", 100 * value) : std::string("\xE2\x80\x93");
  };
  readout(ui, {"cloth.crimp_warp", "Warp crimp", "How much longer the warp yarn is than the cloth it lies in"},
          crimp(model.crimpWarp));
  readout(ui, {"cloth.crimp_weft", "Weft crimp", "How much longer the weft yarn is than the cloth it lies in"},
          crimp(model.crimpWeft));
  readout(ui, {"cloth.warp_count", "Warp count", "Mean count of the warp yarns"},
          fmt::format("{:.1f} tex", meanCount_tex(fabric, System::warp)));
  readout(ui, {"cloth.weft_count", "Weft count", "Mean count of the weft yarns"},
          fmt::format("{:.1f} tex", meanCount_tex(fabric, System::weft)));

  if (!changed) return std::nullopt;
  Fabric edited = fabric;
  edited.name = name;
  edited.description = description;
  edited.ends_per_cm = ends;
  edited.picks_per_cm = picks;
  return edited;
}

}  // namespace loomlight
