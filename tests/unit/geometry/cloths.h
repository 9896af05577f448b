#pragma once

#include <utility>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight::cloths {

inline Weave twill22() {
  return Weave({{1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {1, 0, 0, 1}});
}

inline Weave satin8() {
  std::vector<std::vector<uint8_t>> rows(8, std::vector<uint8_t>(8, 0));
  for (size_t pick = 0; pick < 8; ++pick) rows[pick][3 * pick % 8] = 1;
  return Weave(rows);
}

/// A cotton single in plain weave, a round yarn at a sett that leaves it room.
inline Fabric plain() {
  Fabric f;
  f.name = "plain";
  f.ends_per_cm = 22;
  f.picks_per_cm = 20;
  return f;
}

inline Fabric twill(FibreLayout layout = FibreLayout::packed) {
  Fabric f = plain();
  f.name = "twill";
  f.weave = twill22();
  f.yarns[0].layout = layout;
  f.yarns[0].plyTwistDirection = TwistDirection::s;
  return f;
}

inline Fabric pliedSatin() {
  Fabric f = plain();
  f.name = "plied satin";
  f.weave = satin8();
  f.ends_per_cm = 21;
  f.picks_per_cm = 18;
  Yarn& yarn = f.yarns[0];
  yarn.plies = 2;
  yarn.plyTwist_per_m = 800;
  yarn.yarnTwist_per_m = 520;
  return f;
}

/// A sewing thread: three cords of two plies each, twisted back each time.
inline Fabric cabled() {
  Fabric f = pliedSatin();
  f.name = "cabled";
  f.ends_per_cm = 14;
  f.picks_per_cm = 12;
  Yarn& yarn = f.yarns[0];
  yarn.count_tex = 60;
  yarn.cords = 3;
  yarn.cableTwist_per_m = 280;
  return f;
}

inline Fabric hairy() {
  Fabric f = twill();
  f.name = "hairy";
  f.yarns[0].hairiness_per_mm = 6;
  f.yarns[0].hairLength_mm = 0.8;
  f.yarns[0].migration = 0.3;
  return f;
}

/// Thick and thin, plied and filament, warp and weft unlike: no two neighbouring cells need have equal nodes.
inline Fabric mixed() {
  Fabric f = plain();
  f.name = "mixed";
  f.weave = satin8();
  f.ends_per_cm = 18;
  f.picks_per_cm = 16;
  Yarn thick;
  thick.count_tex = 45;
  thick.flattening = 1.6;
  Yarn plied;
  plied.plies = 3;
  plied.count_tex = 36;
  plied.yarnTwist_per_m = 400;
  plied.layout = FibreLayout::random;
  Yarn filament;
  filament.fibresPerPly = 48;
  filament.plyTwist_per_m = 0;
  filament.packing = 0.75;
  f.yarns = {thick, plied, filament};
  f.warpSequence = {0, 1, 0, 2, 2};
  f.weftSequence = {1, 2, 0};
  return f;
}

/// Unevenly spun, with slubs, and woven in an uneven sett.
inline Fabric slubby() {
  Fabric f = hairy();
  f.name = "slubby";
  f.yarns[0].evennessCv_percent = 20;
  f.yarns[0].slubs_per_m = 12;
  f.yarns[0].slubLength_mm = 10;
  f.yarns[0].slubRatio = 2;
  f.settCv_percent = 8;
  return f;
}

/// Pairs of threads that float together, and draw together.
inline Fabric hopsack() {
  Fabric f = hairy();
  f.name = "hopsack";
  f.weave = Weave({{1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 1, 1}});
  f.crowding = 1;
  return f;
}

/// Ends in pairs as of one dent, every third pick apart.
inline Fabric spaced() {
  Fabric f = mixed();
  f.name = "spaced";
  f.ends_per_cm = 12;
  f.picks_per_cm = 12;
  f.warpSpacing = {1, 2};
  f.weftSpacing = {1, 1, 1.6};
  return f;
}

inline std::vector<Fabric> all() {
  return {plain(),   twill(), twill(FibreLayout::random), pliedSatin(), cabled(), hairy(), mixed(), slubby(),
          hopsack(), spaced()};
}

}  // namespace loomlight::cloths
