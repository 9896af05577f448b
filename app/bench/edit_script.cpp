#include "app/bench/edit_script.h"

#include <algorithm>
#include <cstdlib>

#include "bench_cloth_text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/weave/jacquard.h"

namespace loomlight {
namespace {

using Voxelises = EditKind::Voxelises;

Weave weaveOf(int side, const std::function<bool(int pick, int end)>& warpOver) {
  std::vector<Weave::Row> rows(static_cast<size_t>(side), Weave::Row(static_cast<size_t>(side)));
  for (int pick = 0; pick < side; ++pick)
    for (int end = 0; end < side; ++end) rows[pick][end] = warpOver(pick, end);
  return Weave(rows);
}

Weave twill(int side) {
  return weaveOf(side, [side](int pick, int end) { return (end - pick + side) % side < side / 2; });
}

/// Lozenges of twill, threaded to a point and back.
Weave dobby(int side) {
  const auto point = [side](int i) { return std::abs(i - side / 2); };
  return weaveOf(side, [&](int pick, int end) { return (point(pick) + point(end)) % 8 < 3 + point(end) % 3; });
}

/// Flat, one repeat of this weave; seen from a distance that shows kSeen_mm of it, or all where it is smaller.
Fabric posed(Fabric fabric, const Weave& weave, bool quick) {
  constexpr double kLeast_mm = 8, kSeen_mm = 30;
  fabric.weave = weave;
  fabric.draft.reset();
  fabric.drape.kind = DrapeKind::flat;
  fabric.drape.width_mm = std::max(kLeast_mm, weave.ends() * fabric.warpPitch_mm());
  fabric.drape.height_mm = std::max(kLeast_mm, weave.picks() * fabric.weftPitch_mm());
  fabric.camera.target_mm = glm::dvec3(0);
  fabric.camera.distance_mm = 2.5 * std::min(kSeen_mm, fabric.drape.height_mm);
  fabric.render.resolution = quick ? 2 : 8;
  return fabric;
}

Fabric painted(Fabric fabric, int pick, int end) {
  const Weave& weave = fabric.weave;
  pick %= weave.picks();
  end %= weave.ends();
  fabric.weave = weave.with(pick, end, !weave.at(pick, end));
  return fabric;
}

/// A square of the weave copied to another place.
Fabric pasted(Fabric fabric, int round) {
  const Weave from = fabric.weave;
  const int along = round / from.picks();
  const int side = std::max(2, std::min({32, from.ends() / 2, from.picks() / 2}));
  for (int p = 0; p < side; ++p)
    for (int e = 0; e < side; ++e) {
      const int pick = (p + side / 2 + 1 + round) % from.picks(), end = (e + side / 2 + 1 + along) % from.ends();
      fabric.weave = fabric.weave.with(pick, end, from.at(p, e));
    }
  return fabric;
}

}  // namespace

std::vector<EditedCloth> editedCloths(bool quick) {
  const Fabric twilled = fabricFromJson(kBenchBlueCloth, "blue cloth");
  const Fabric figured = fabricFromJson(kBenchJacquard, "jacquard");
  std::vector<EditedCloth> cloths{{"twill_8", posed(twilled, twill(8), quick)},
                                  {"dobby_64", posed(twilled, dobby(64), quick)}};
  for (const int side : quick ? std::vector{160} : std::vector{1000, 4000})
    cloths.push_back({"jacquard_" + std::to_string(side), posed(figured, damaskJacquard(side, side), quick)});
  return cloths;
}

std::vector<EditKind> editKinds() {
  const auto times = [](double value, int round) { return value * (1.05 + 0.01 * round); };
  return {{"paint one crossing", Voxelises::crossing,
           [](Fabric f, int round) { return painted(std::move(f), 3 + 5 * round, 2 + 3 * round + round / 8); }},
          {"paste an area", Voxelises::anything, [](Fabric f, int round) { return pasted(std::move(f), round); }},
          {"resize the repeat", Voxelises::anything,
           [](Fabric f, int round) {
             f.weave = f.weave.resized(f.weave.ends() + 1 + round, f.weave.picks());
             return f;
           }},
          {"twist", Voxelises::anything,
           [times](Fabric f, int round) {
             f.yarns[0].plyTwist_per_m = times(f.yarns[0].plyTwist_per_m, round);
             return f;
           }},
          {"ply", Voxelises::anything,
           [](Fabric f, int round) {
             f.yarns[0].plies += 1 + round % 3;
             f.yarns[0].yarnTwist_per_m = 300 + 20 * round;
             return f;
           }},
          {"tex", Voxelises::anything,
           [times](Fabric f, int round) {
             f.yarns[0].fibresPerPly.reset();
             f.yarns[0].count_tex = times(f.yarns[0].count_tex, round);
             return f;
           }},
          {"sett", Voxelises::anything,
           [times](Fabric f, int round) {
             f.ends_per_cm = times(f.ends_per_cm, round);
             return f;
           }},
          {"colour sequence", Voxelises::nothing,
           [](Fabric f, int round) {
             // As many yarns of one shape in two colours.
             Yarn other = f.yarns[f.warpSequence[0]];
             f.fibres.push_back(f.fibres[other.fibre]);
             f.fibres.back().absorption_per_mm = Rgb(1 + round, 5, 20);
             other.fibre = static_cast<int>(f.fibres.size()) - 1;
             f.yarns.push_back(other);
             f.warpSequence.assign(4, f.warpSequence[0]);
             f.warpSequence[3] = static_cast<int>(f.yarns.size()) - 1;
             return f;
           }},
          {"absorption", Voxelises::nothing,
           [](Fabric f, int round) {
             f.fibres[0].absorption_per_mm.primaries += Rgb(3 + round, 1, 2);
             return f;
           }},
          {"refractive index", Voxelises::nothing,
           [](Fabric f, int round) {
             f.fibres[0].refractiveIndex += 0.01 + 0.002 * round;
             return f;
           }},
          {"light", Voxelises::nothing,
           [](Fabric f, int round) {
             f.light.azimuth_deg += 10 + round;
             return f;
           }},
          {"camera", Voxelises::nothing,
           [](Fabric f, int round) {
             f.camera.azimuth_deg += 10 + round;
             return f;
           }},
          {"drape", Voxelises::nothing, [](Fabric f, int round) {
             f.drape.kind = DrapeKind::cylinder;
             f.drape.radius_mm = f.drape.width_mm / 3 + round;
             return f;
           }}};
}

std::vector<Fabric> stroke(Fabric fabric, int crossings) {
  std::vector<Fabric> after;
  for (int i = 0; i < crossings; ++i) {
    fabric = painted(std::move(fabric), i / 2 + 1, i);
    after.push_back(fabric);
  }
  return after;
}

}  // namespace loomlight
