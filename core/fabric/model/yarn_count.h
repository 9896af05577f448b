#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The systems in which weavers say how fine a yarn is. Direct ones weigh a length (tex: g/km), indirect ones count
/// lengths to a weight (Ne: hanks of 840 yards to the pound).
enum class CountSystem { tex, dtex, denier, metric, cotton, worsted, linen };

/// Linear density in tex, from any system and back; an involution for the indirect systems. `value` > 0. Constants:
/// 590.5 tex = Ne 1, 885.8 = NeK 1 (worsted), 1653.5 = NeL 1 (linen), 1000 = Nm 1.
double texFromCount(double value, CountSystem system);
double countFromTex(double tex, CountSystem system);
/// Whether it counts lengths to a weight, so that thicker yarns have smaller numbers.
bool isIndirect(CountSystem system);
/// "tex", "Nm", "Ne"...
const char* countUnit(CountSystem system);

/// Linear density of one fibre, dtex (g per 10 km): rho pi r^2.
double fibreFineness_dtex(const Fibre& fibre);
/// Radius of a round fibre of that fineness, um.
double fibreRadius_um(double fineness_dtex, double density_g_cm3);

/// What the fibres of a yarn are like on average, for count, number and section: the fibre itself, or of a blend the
/// radius and the density with which as many fibres have the same volume and mass. Optics and name are the first's.
Fibre meanFibre(const Yarn& yarn, const std::vector<Fibre>& fibres);
/// How many of a yarn's fibres are of the second kind, 0..1: by number, where blendShare is by mass.
double blendNumberShare(const Yarn& yarn, const std::vector<Fibre>& fibres);

/// Singles in the section of the whole yarn: the plies of all its cords.
constexpr int singlesIn(const Yarn& yarn) {
  return yarn.cords * yarn.plies;
}

/// Of one thick fibre a ply: drawn, not spun, so it is rigid, compact and even.
constexpr bool isMonofilament(const Yarn& yarn) {
  return yarn.fibresPerPly == 1;
}

/// Whether it is of staple fibre, which shows in hairs, wrapper fibres or fibres that wander: filament has none of
/// them.
constexpr bool isSpun(const Yarn& yarn) {
  return !isMonofilament(yarn) && (yarn.hairiness_per_mm > 0 || yarn.wrappers_per_cm > 0 || yarn.migration > 0);
}

/// Linear density of the finished yarn, tex: its count, or singles * fibresPerPly * fibre where that is given. Take-up
/// by twist is not in it: the geometry finds that, and scales its fibres so that a given count is met exactly.
double yarnCount_tex(const Yarn& yarn, const Fibre& fibre);
/// Fibres in the section of the whole yarn, not rounded.
double fibresInYarn(const Yarn& yarn, const Fibre& fibre);
/// The least CVm of a spun yarn, %: that of so many fibres in its section, of all plies, whose ends lie at random
/// (Martindale). 106 / sqrt(n), as cotton's fibres vary in thickness; of hair, which has scales, 112 / sqrt(n).
double limitCv_percent(const Yarn& yarn, const Fibre& fibre);
/// Diameter of a round yarn of that count and packing, mm: 0.03568 sqrt(T / (rho phi)).
double yarnDiameter_mm(const Yarn& yarn, const Fibre& fibre);

}  // namespace loomlight
