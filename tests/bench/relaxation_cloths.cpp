#include "tests/bench/relaxation_cloths.h"

namespace loomlight {
namespace {

constexpr double kCotton = 1.52, kWool = 1.31, kPolyester = 1.38, kSilk = 1.34, kLinen = 1.50;

Weave plain() {
  return {};
}
/// Each pick is up for the first `up` of `ends`, and one step on from the last.
Weave stepped(size_t ends, size_t up, size_t step) {
  std::vector<Weave::Row> rows(ends, Weave::Row(ends, 0));
  for (size_t pick = 0; pick < ends; ++pick)
    for (size_t i = 0; i < up; ++i) rows[pick][(pick * step + i) % ends] = 1;
  return Weave(rows);
}
Weave basket() {
  return Weave(std::vector<Weave::Row>{{1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 1, 1}});
}
/// Two picks in a shed: warp rib.
Weave rib() {
  return Weave(std::vector<Weave::Row>{{1, 0}, {1, 0}, {0, 1}, {0, 1}});
}
/// Two ends as one: weft rib.
Weave oxford() {
  return Weave(std::vector<Weave::Row>{{0, 0, 1, 1}, {1, 1, 0, 0}});
}
Weave honeycomb() {
  return Weave(std::vector<Weave::Row>{{1, 0, 0, 0, 0, 0},
                                       {1, 1, 0, 0, 0, 1},
                                       {1, 1, 1, 0, 1, 1},
                                       {1, 1, 1, 1, 1, 1},
                                       {1, 1, 1, 0, 1, 1},
                                       {1, 1, 0, 0, 0, 1}});
}

RelaxedYarn cotton(double tex, double twist_per_m) {
  return {tex, kCotton, 0.5, twist_per_m};
}
RelaxedCloth cloth(const Weave& weave, double ends, double picks, const RelaxedYarn& warp, const RelaxedYarn& weft) {
  return {weave, ends, picks, warp, weft};
}

RelaxedMeasures found(double crimpWarp_percent, double crimpWeft_percent, double thickness_mm,
                      const std::array<double, 2>& drawnAside_mm = {}) {
  RelaxedMeasures measures;
  measures.drawnAside_mm = drawnAside_mm;
  measures.crimpWarp = 0.01 * crimpWarp_percent;
  measures.crimpWeft = 0.01 * crimpWeft_percent;
  measures.thickness_mm = thickness_mm;
  return measures;
}
Fabric fabricOf(const RelaxedCloth& cloth, double press) {
  Fabric fabric;
  fabric.weave = cloth.weave;
  fabric.ends_per_cm = cloth.ends_per_cm;
  fabric.picks_per_cm = cloth.picks_per_cm;
  fabric.press = press;
  fabric.fibres.assign(2, fabric.fibres[0]);
  fabric.yarns.assign(2, fabric.yarns[0]);
  for (size_t i = 0; i < 2; ++i) {
    const RelaxedYarn& yarn = i == 0 ? cloth.warp : cloth.weft;
    fabric.fibres[i].density_g_cm3 = yarn.density_g_cm3;
    fabric.yarns[i].fibre = static_cast<int>(i);
    fabric.yarns[i].count_tex = yarn.count_tex;
    fabric.yarns[i].packing = yarn.packing;
    fabric.yarns[i].plyTwist_per_m = yarn.twist_per_m;
  }
  fabric.warpSequence = {0};
  fabric.weftSequence = {1};
  return fabric;
}

constexpr bool kUnlikePressed = true, kRib = true;

}  // namespace

std::vector<Construction> constructions() {
  const RelaxedYarn worsted = {33.3, kWool, 0.5, 560}, filament = {4.67, kSilk, 0.7, 300};
  const RelaxedYarn satin = {29.5, kPolyester, 0.7, 100}, linen = {56, kLinen, 0.5, 420};
  const RelaxedYarn fine = cotton(14.8, 1000), sheeting = cotton(19.7, 850), middle = cotton(30, 700);
  return {
      {"denim, 3/1 twill", true, cloth(stepped(4, 3, 1), 26, 17, cotton(84, 480), cotton(66, 480)),
       found(8.5, 11.1, 0.705, {0.031, 0.021}), found(7.9, 10.5, 0.582), 0.825, kUnlikePressed},
      {"poplin, plain, setts unlike", true, cloth(plain(), 50, 28, fine, fine), found(14, 1.5, 0.278),
       found(13.3, 2.3, 0.264), 0.968},
      {"sheeting, plain", true, cloth(plain(), 30, 26, sheeting, sheeting), found(8.3, 5, 0.26), found(7.4, 6.1, 0.249),
       0.963},
      {"worsted, 2/2 twill", true, cloth(stepped(4, 2, 1), 28, 25, worsted, worsted),
       found(6.6, 6.7, 0.436, {0.0071, 0.0052}), found(6, 6.4, 0.401), 0.919},
      {"satin of 5, filament", true, cloth(stepped(5, 4, 2), 34, 24, satin, satin),
       found(3.1, 3.4, 0.415, {0.0042, 0.0024}), found(3, 3.1, 0.34), 0.819},
      {"basket, 2/2", true, cloth(basket(), 30, 30, cotton(30.3, 700), cotton(30.3, 700)),
       found(6.5, 6.5, 0.383, {0.0185, 0.0182}), found(6.1, 6, 0.352), 0.920},
      {"organza, plain, filament", true, cloth(plain(), 48, 44, filament, filament), found(3.9, 3.2, 0.119),
       found(3.7, 3.4, 0.115), 0.983},
      {"honeycomb of 6", false, cloth(honeycomb(), 20, 20, cotton(40, 600), cotton(40, 600)),
       found(1.9, 1.9, 0.496, {0.0059, 0.0055}), found(1.8, 1.7, 0.352), 0.711},
      {"plain, balanced", false, cloth(plain(), 22, 22, middle, middle), found(6.3, 6.2, 0.309), found(6.3, 6.3, 0.298),
       0.964},
      {"plain, counts 2 : 1", false, cloth(plain(), 24, 20, cotton(20, 850), cotton(40, 600)), found(13.7, 0.9, 0.361),
       found(12.8, 1.3, 0.344), 0.965},
      {"plain, counts 1 : 2", false, cloth(plain(), 20, 20, cotton(50, 550), cotton(25, 760)), found(1.4, 15.4, 0.385),
       found(1.9, 14.3, 0.367), 0.965},
      {"drill, 2/1 twill", true, cloth(stepped(3, 2, 1), 34, 20, middle, middle),
       found(7, 4.2, 0.399, {0.0095, 0.0063}), found(6.6, 4.4, 0.366), 0.942},
      {"serge, 2/2 twill, wool", false, cloth(stepped(4, 2, 1), 24, 22, {44, kWool, 0.5, 480}, {44, kWool, 0.5, 480}),
       found(6.6, 6.6, 0.5, {0.0077, 0.0061}), found(6, 6.2, 0.46), 0.920},
      {"satin of 8, cotton", false, cloth(stepped(8, 7, 3), 44, 26, cotton(20, 850), cotton(20, 850)),
       found(1.9, 1.9, 0.359, {0.0055, 0.0023}), found(1.9, 1.9, 0.291), 0.810},
      {"warp rib of 2", false, cloth(rib(), 28, 24, middle, middle), found(8.7, 1.6, 0.44, {0, 0.017}),
       found(8.2, 1.9, 0.405), 0.918, false, kRib},
      {"oxford, two ends as one", false, cloth(oxford(), 43.3, 22.8, fine, cotton(29.5, 700)),
       found(10, 4.1, 0.297, {0.0077, 0}), found(9.6, 4, 0.285), 0.966, false, kRib},
      {"linen, plain", false, cloth(plain(), 14, 13, linen, linen), found(4.4, 3.6, 0.418), found(4.1, 4, 0.401),
       0.966},
      {"taffeta, plain, filament", false,
       cloth(plain(), 44, 30, {8.4, kPolyester, 0.7, 150}, {8.4, kPolyester, 0.7, 100}), found(5.1, 1.9, 0.173),
       found(4.7, 2.3, 0.166), 0.983},
  };
}

ClothMeasures inClosedForm(const RelaxedCloth& cloth, double press, double crowding) {
  Fabric fabric = fabricOf(cloth, press);
  fabric.crowding = crowding;
  return ClothGeometry(fabric, fabric.weave.ends(), fabric.weave.picks(), nullptr, true).measure();
}

std::array<double, 2> asideInClosedForm(const RelaxedCloth& cloth) {
  Fabric fabric = fabricOf(cloth, 0);
  fabric.crowding = 1;
  const Weave& weave = fabric.weave;
  const ClothGeometry geometry(fabric, weave.ends(), weave.picks(), nullptr, true);
  std::array<double, 2> aside{};
  for (const System system : {System::warp, System::weft}) {
    const bool warp = system == System::warp;
    int count = 0;
    for (int pick = 0; pick < weave.picks(); ++pick)
      for (int end = 0; end < weave.ends(); ++end) {
        const bool over = weave.at(pick, end);
        const auto isParted = [&](int by) {
          return weave.warpOver(pick + (warp ? 0 : by), end + (warp ? by : 0)) != over;
        };
        const int drawn = isParted(-1) - isParted(1);
        // The weft's frame counts against the picks.
        aside[static_cast<size_t>(system)] += (warp ? drawn : -drawn) * geometry.key(system, pick, end).here.aside_mm;
        count += drawn != 0;
      }
    if (count > 0) aside[static_cast<size_t>(system)] /= count;
  }
  return aside;
}

}  // namespace loomlight
