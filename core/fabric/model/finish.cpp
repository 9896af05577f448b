#include "core/fabric/model/finish.h"

#include <algorithm>

#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/yarn_count.h"

// How it works. A finish is a closed-form change of what the yarns and fibres are as spun; geometry and scattering are
// made of what it returns, and files keep the yarn as it was bought. The factors are guesses by the look of cloth: the
// trade measures singeing by the hair that is left, which is a third to a tenth. What would be more hair than a yarn
// may have is cut off: on a cloth that is hairy as spun, and brushed, milling hardly adds any.

namespace loomlight {
namespace {

struct HairFactors {
  double number = 1, length = 1;
};
constexpr HairFactors kSinged{0.35, 0.4}, kBrushed{1.8, 1.6}, kMilled{3, 1.3};

constexpr double kSwelling = 0.45;       // of the packing, what milling takes
constexpr double kMilledDisorder = 0.9;  // of what the fibres' disorder lacks to the most that a yarn may have
constexpr double kMatted = 0.75;         // of the hairs that stand, how many it lays

constexpr double kLustre = 0.6;  // of the roughness, what mercerising leaves

constexpr double kMeanReach = 0.281;                 // of an exponential that is cut off at three means, over the cut
constexpr double kClimbing = 1.09, kLooping = 1.05;  // longer than their way along the cloth, as they rise and curl

}  // namespace

double feltingOf(const Yarn& yarn, const Fabric& fabric) {
  return isSpun(yarn) ? fabric.milling : 0.0;
}

Yarn withFinish(Yarn yarn, const Fabric& fabric) {
  const double felting = feltingOf(yarn, fabric);
  const auto apply = [&yarn](const HairFactors& factors) {
    yarn.hairiness_per_mm = std::min(yarn.hairiness_per_mm * factors.number, fieldInfo(&Yarn::hairiness_per_mm).max);
    const FieldInfo length = fieldInfo(&Yarn::hairLength_mm);
    yarn.hairLength_mm = std::clamp(yarn.hairLength_mm * factors.length, length.min, length.max);
  };
  if (fabric.singed) apply(kSinged);
  if (fabric.brushed) apply(kBrushed);
  if (felting == 0) return yarn;
  apply({1 + felting * (kMilled.number - 1), 1 + felting * (kMilled.length - 1)});
  const FieldInfo packing = fieldInfo(&Yarn::packing), disorder = fieldInfo(&Yarn::fibreDisorder_deg);
  yarn.packing = std::max(packing.min, yarn.packing * (1 - kSwelling * felting));
  yarn.fibreDisorder_deg += kMilledDisorder * felting * (disorder.max - yarn.fibreDisorder_deg);
  return yarn;
}

HairLie hairLieOf(const Fabric& fabric, System system) {
  HairLie lie;
  lie.lyingShare += (1 - lie.lyingShare) * std::clamp(2 * fabric.press - 1, 0.0, 1.0);
  lie.lyingShare += (1 - lie.lyingShare) * kMatted * fabric.milling;
  lie.isRaised = fabric.brushed;
  // A pick's side u looks towards the lower picks.
  if (fabric.brushed && system == System::weft) lie.heading = -0.5 * kPi;
  return lie;
}

Fibre withFinishedSurface(Fibre fibre, const Fabric& fabric) {
  if (!fabric.mercerised || fibre.section != FibreSection::kidney) return fibre;
  fibre.section = FibreSection::round;
  const auto smoothed = [](double roughness, double least) { return std::max(least, kLustre * roughness); };
  fibre.longitudinalRoughness = smoothed(fibre.longitudinalRoughness, fieldInfo(&Fibre::longitudinalRoughness).min);
  fibre.azimuthalRoughness = smoothed(fibre.azimuthalRoughness, fieldInfo(&Fibre::azimuthalRoughness).min);
  return fibre;
}

double meanHairLength_mm(double hairLength_mm, double diameter_mm, double lyingShare) {
  const double body = 0.5 * diameter_mm, reach = kMeanReach * hairLength_mm;
  const double standing = kClimbing * 2 * (reach + 0.5 * body);
  const double lying = kClimbing * kLyingHairLength * (reach + 0.5 * body);
  const double end = (1 - lyingShare) * standing + lyingShare * lying;
  return (1 - kHairLoopShare) * end + kHairLoopShare * kLooping * (2 * body + 4 * kHairLoopReach * reach);
}

double hairinessH(const Yarn& yarn, const Fibre& fibre) {
  return yarn.hairiness_per_mm * meanHairLength_mm(yarn.hairLength_mm, yarnDiameter_mm(yarn, fibre));
}

Yarn withHairinessH(Yarn yarn, const Fibre& fibre, double hairiness) {
  const FieldInfo info = fieldInfo(&Yarn::hairiness_per_mm);
  const double each_mm = meanHairLength_mm(yarn.hairLength_mm, yarnDiameter_mm(yarn, fibre));
  yarn.hairiness_per_mm = std::clamp(hairiness / each_mm, info.min, info.max);
  return yarn;
}

}  // namespace loomlight
