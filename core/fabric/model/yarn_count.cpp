#include "core/fabric/model/yarn_count.h"

#include <cassert>
#include <cmath>

namespace loomlight {
namespace {

/// Tex per unit of a direct system, or the tex of count 1 of an indirect one.
struct Unit {
  double tex;
  bool indirect;
  const char* unit;
};

Unit describe(CountSystem system) {
  switch (system) {
    case CountSystem::tex:
      return {1.0, false, "tex"};
    case CountSystem::dtex:
      return {0.1, false, "dtex"};
    case CountSystem::denier:
      return {1.0 / 9.0, false, "den"};
    case CountSystem::metric:
      return {1000.0, true, "Nm"};
    case CountSystem::cotton:
      return {590.5, true, "Ne"};
    case CountSystem::worsted:
      return {885.8, true, "NeK"};
    case CountSystem::linen:
      return {1653.5, true, "NeL"};
  }
  assert(false);
  return {1.0, false, ""};
}

/// Of a solid cylinder, tex (g/km): um^2 * g/cm^3 = 1e-3 g/km.
double cylinder_tex(double radius_um, double density_g_cm3) {
  return 1e-3 * kPi * radius_um * radius_um * density_g_cm3;
}

}  // namespace

double texFromCount(double value, CountSystem system) {
  const Unit s = describe(system);
  return s.indirect ? s.tex / value : s.tex * value;
}

double countFromTex(double tex, CountSystem system) {
  const Unit s = describe(system);
  return s.indirect ? s.tex / tex : tex / s.tex;
}

bool isIndirect(CountSystem system) {
  return describe(system).indirect;
}

const char* countUnit(CountSystem system) {
  return describe(system).unit;
}

double fibreFineness_dtex(const Fibre& fibre) {
  return 10.0 * cylinder_tex(fibre.radius_um, fibre.density_g_cm3);
}

double fibreRadius_um(double fineness_dtex, double density_g_cm3) {
  return std::sqrt(0.1 * fineness_dtex / cylinder_tex(1.0, density_g_cm3));
}

double blendNumberShare(const Yarn& yarn, const std::vector<Fibre>& fibres) {
  if (!yarn.blendFibre) return 0;
  const double share = yarn.blendShare.value_or(0.5);
  const double first = (1 - share) / fibreFineness_dtex(fibres[yarn.fibre]);
  const double second = share / fibreFineness_dtex(fibres[*yarn.blendFibre]);
  return second / (first + second);
}

Fibre meanFibre(const Yarn& yarn, const std::vector<Fibre>& fibres) {
  Fibre mean = fibres[yarn.fibre];
  if (!yarn.blendFibre) return mean;
  const Fibre& second = fibres[*yarn.blendFibre];
  const double share = blendNumberShare(yarn, fibres);
  const double section = (1 - share) * mean.radius_um * mean.radius_um + share * second.radius_um * second.radius_um;
  const double fineness = (1 - share) * fibreFineness_dtex(mean) + share * fibreFineness_dtex(second);
  mean.radius_um = std::sqrt(section);
  mean.density_g_cm3 = 0.1 * fineness / cylinder_tex(mean.radius_um, 1.0);
  return mean;
}

double yarnCount_tex(const Yarn& yarn, const Fibre& fibre) {
  if (!yarn.fibresPerPly) return yarn.count_tex;
  return 0.1 * fibreFineness_dtex(fibre) * singlesIn(yarn) * *yarn.fibresPerPly;
}

double fibresInYarn(const Yarn& yarn, const Fibre& fibre) {
  if (yarn.fibresPerPly) return static_cast<double>(singlesIn(yarn)) * *yarn.fibresPerPly;
  return 10.0 * yarn.count_tex / fibreFineness_dtex(fibre);
}

double limitCv_percent(const Yarn& yarn, const Fibre& fibre) {
  constexpr double kCotton = 106, kHair = 112;
  return (fibre.scaleTilt_deg != 0 ? kHair : kCotton) / std::sqrt(fibresInYarn(yarn, fibre));
}

double yarnDiameter_mm(const Yarn& yarn, const Fibre& fibre) {
  const double radius_um =
      std::sqrt(yarnCount_tex(yarn, fibre) / cylinder_tex(1.0, fibre.density_g_cm3 * yarn.packing));
  return 2.0 * radius_um * kMmPerUm;
}

}  // namespace loomlight
