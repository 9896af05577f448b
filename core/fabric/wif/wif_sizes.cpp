#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_most_common.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/wif/wif_yarns.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

using Warnings = std::vector<WifWarning>;

/// The yarn that most of those threads have that the file makes as thick as most. Yarns of many colours may all be of
/// that thickness, and each be rarer than one that is thick or thin.
int usualYarn(const Fabric& fabric, System system) {
  const std::vector<int>& sequence = fabric.sequence(system);
  const bool isWarp = system == System::warp;
  const WifSizes& sizes = isWarp ? fabric.wif->rest.warp : fabric.wif->rest.weft;
  const std::vector<double> thickness = relativeThickness(sizes, isWarp ? fabric.wif->ends : fabric.wif->picks);
  std::vector<int> usual;
  for (size_t thread = 0; thread < thickness.size(); ++thread)
    if (thickness[thread] == 1) usual.push_back(sequence[thread % sequence.size()]);
  return mostCommon(usual.empty() ? sequence : usual);
}

double usualDiameter_mm(const Fabric& fabric, System system) {
  const Yarn& usual = fabric.yarns[usualYarn(fabric, system)];
  return yarnDiameter_mm(usual, meanFibre(usual, fabric.fibres));
}

/// Gives the yarns the file's diameters: a system's are scaled so that the usual one gets its. Both scales are of the
/// yarns as they were: where warp and weft share the yarn that most threads have, the second would find it scaled
/// already, and leave all others of its threads behind. A yarn of both systems takes the warp's.
void scaleYarns(Fabric& fabric, const WifSett& sett, Warnings& warnings) {
  const auto scale = [&fabric](System system, std::optional<double> diameter_mm) {
    return diameter_mm ? std::optional(*diameter_mm / usualDiameter_mm(fabric, system)) : std::nullopt;
  };
  const std::pair<System, std::optional<double>> scales[] = {{System::warp, scale(System::warp, sett.warpDiameter_mm)},
                                                             {System::weft, scale(System::weft, sett.weftDiameter_mm)}};
  std::vector<bool> done(fabric.yarns.size(), false);
  bool held = false;
  for (const auto& [system, factor] : scales) {
    if (!factor) continue;
    for (const int index : fabric.sequence(system)) {
      if (done[index]) continue;
      done[index] = true;
      Yarn& yarn = fabric.yarns[index];
      yarn = heavier(yarn, meanFibre(yarn, fabric.fibres), *factor * *factor, held);
      if (std::lround(1000 * *factor) != 1000) yarn.name.clear();  // it may name a count, and is another yarn
    }
  }
  if (held) warnings.push_back(heldYarns());
}

}  // namespace

WifSett wifSett(const Fabric& fabric) {
  WifSett sett;
  if (!fabric.wif) return sett;
  const WifOrigin& origin = *fabric.wif;
  const auto threads_per_cm = [](const WifSizes& sizes, int threads) -> std::optional<double> {
    const std::optional<double> pitch_mm = sizes.meanSpacing_mm(threads);
    return pitch_mm ? std::optional(tidy(10.0 / *pitch_mm)) : std::nullopt;
  };
  sett.ends_per_cm = threads_per_cm(origin.rest.warp, origin.ends);
  sett.picks_per_cm = threads_per_cm(origin.rest.weft, origin.picks);
  sett.warpDiameter_mm = usualThickness_mm(origin.rest.warp, origin.ends);
  sett.weftDiameter_mm = usualThickness_mm(origin.rest.weft, origin.picks);
  return sett;
}

std::vector<WifWarning> otherWifSizes(const Fabric& fabric) {
  const WifSett sett = wifSett(fabric);
  Warnings warnings;
  const auto note = [&](const char* threads, std::optional<double> file, double mine) {
    if (file && std::abs(*file - mine) > 1e-4 * mine)
      warnings.push_back(
          {fmt::format("The file has {:.4g} {} per cm; the cloth keeps {:g}.", *file, threads, mine), {}});
  };
  note("ends", sett.ends_per_cm, fabric.ends_per_cm);
  note("picks", sett.picks_per_cm, fabric.picks_per_cm);
  const auto noteYarn = [&](const char* yarn, System system, std::optional<double> file_mm) {
    constexpr double kSame = 0.01;  // a yarn of a whole number of fibres may be off by that much
    const double mine_mm = file_mm ? usualDiameter_mm(fabric, system) : 0;
    if (file_mm && std::abs(*file_mm - mine_mm) > kSame * mine_mm)
      warnings.push_back(
          {fmt::format("The file's {} yarn is {:.3g} mm thick; the cloth keeps {:.3g} mm.", yarn, *file_mm, mine_mm),
           {}});
  };
  noteYarn("warp", System::warp, sett.warpDiameter_mm);
  noteYarn("weft", System::weft, sett.weftDiameter_mm);
  return warnings;
}

Fabric withWifSizes(Fabric fabric, std::vector<WifWarning>& warnings) {
  if (!fabric.wif) return fabric;
  const WifSett sett = wifSett(fabric);
  const FieldInfo range = fieldInfo(&Fabric::ends_per_cm);
  const auto set = [&](const char* threads, std::optional<double> file, double& mine) {
    if (!file) {
      warnings.push_back(
          {fmt::format("The file does not say how close its {} lie; it stays at {:g} per cm.", threads, mine), {}});
      return;
    }
    mine = std::clamp(*file, range.min, range.max);
    if (mine != *file)
      warnings.push_back({fmt::format("{:g} {} per cm are out of range; there are {:g}.", *file, threads, mine), {}});
  };
  set("ends", sett.ends_per_cm, fabric.ends_per_cm);
  set("picks", sett.picks_per_cm, fabric.picks_per_cm);

  scaleYarns(fabric, sett, warnings);
  fabric.wif = withSizesOf(*fabric.wif, fabric);
  return fabric;
}

}  // namespace loomlight
