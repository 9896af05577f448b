#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/bench/relaxation_cloths.h"

// Crimp and thickness of cloth: ours in closed form, beside yarns of hard strands that were relaxed; then how these lie
// at their crossings, which the law's rows are read off, and how far threads that float together are drawn aside.
// bench_relaxation [POWER [TENSION [PRESS [NAME]]]]: the power of a yarn's count that its stiffness goes by (2), the
// tension that is kept in the cloth (0.5 cN/tex), Fabric::press (0), and only the constructions of such a name. Pressed
// cloth lies between plates, which close by as much as pressing makes ours thinner, so that its thickness proves
// nothing. The whole takes minutes of the processor.
namespace loomlight {
namespace {

/// How far ours is from the relaxed: the worse of both crimps in points, and the thickness in percent.
struct Gap {
  double crimp, thickness;
  bool isWithin() const { return crimp <= 2 && thickness <= 15; }
};
Gap gapOf(const ClothMeasures& ours, const RelaxedMeasures& relaxed) {
  return {100 * std::max(std::abs(ours.crimpWarp - relaxed.crimpWarp), std::abs(ours.crimpWeft - relaxed.crimpWeft)),
          100 * std::abs(ours.thickness_mm / relaxed.thickness_mm - 1)};
}

std::string asideText(const Construction& of, const RelaxedMeasures& relaxed) {
  const auto ours = asideInClosedForm(of.cloth);
  std::string text;
  for (size_t system = 0; system < 2; ++system) {
    const double radius_mm = freeRadius_mm(system == 0 ? of.cloth.warp : of.cloth.weft);
    text += fmt::format("| {} | {} | {:.3f} | {:.3f} |\n", of.name, system == 0 ? "warp" : "weft",
                        ours[system] / radius_mm, relaxed.drawnAside_mm[system] / radius_mm);
  }
  return text;
}

std::string crossingsText(const Construction& of, const RelaxedMeasures& relaxed) {
  std::string text;
  for (size_t system = 0; system < 2; ++system) {
    const RelaxedYarn& yarn = system == 0 ? of.cloth.warp : of.cloth.weft;
    const double radius_mm = freeRadius_mm(yarn);
    for (size_t state = 0; state < 3; ++state) {
      const RelaxedCrossings& mean = relaxed.crossings[system][state];
      if (mean.count == 0) continue;
      text +=
          fmt::format("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", of.name, system == 0 ? "warp" : "weft", state,
                      mean.height_mm / radius_mm, mean.halfUp_mm / radius_mm, mean.halfAcross_mm / radius_mm);
    }
  }
  return text;
}

void printTables(Relaxation how, double press, const std::string& name) {
  fmt::print(
      "Stiffness goes by the count to the power of {:g}, {:g} cN/tex are kept, press {:g}. Crimp in %, warp / weft; "
      "thickness in mm.\n\n",
      how.stiffnessPower, how.keptTension_cN_tex, press);
  fmt::print("| construction | fitted | ours | relaxed | off by | overlap, drift, plates |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- |\n");
  int within = 0, all = 0;
  std::string crossings, aside;
  for (const Construction& of : constructions()) {
    if (std::string(of.name).find(name) == std::string::npos) continue;
    const ClothMeasures ours = inClosedForm(of.cloth, press);
    how.plates = ours.thickness_mm / inClosedForm(of.cloth, 0).thickness_mm;
    const RelaxedMeasures relaxed = relax(of.cloth, how);
    const Gap gap = gapOf(ours, relaxed);
    fmt::print(
        "| {} | {} | {:.1f} / {:.1f}, {:.3f} | {:.1f} / {:.1f}, {:.3f} | {:.1f}, {:.0f} % | {:.2f}, {:.1f}, {:.3f} |\n",
        of.name, of.wasFitted ? "yes" : "no", 100 * ours.crimpWarp, 100 * ours.crimpWeft, ours.thickness_mm,
        100 * relaxed.crimpWarp, 100 * relaxed.crimpWeft, relaxed.thickness_mm, gap.crimp, gap.thickness,
        relaxed.overlap, 100 * relaxed.drift, how.plates);
    std::fflush(stdout);
    within += gap.isWithin();
    ++all;
    crossings += crossingsText(of, relaxed);
    aside += asideText(of, relaxed);
  }
  fmt::print("\nWithin 2 points of crimp and 15 % of thickness: {} of {}.\n", within, all);
  fmt::print("\nAt crossings, over the free radius; state: neighbours along the yarn on the same side.\n\n");
  fmt::print(
      "| construction | yarn | state | height | half up | half across |\n| --- | --- | --- | --- | --- | --- |\n");
  fmt::print("{}", crossings);
  fmt::print(
      "\nDrawn aside by a thread that parts a yarn from one neighbour, over the free radius; ours is washed.\n\n");
  fmt::print("| construction | yarn | ours | relaxed |\n| --- | --- | --- | --- |\n{}", aside);
}

}  // namespace
}  // namespace loomlight

int main(int count, char** words) {
  loomlight::Relaxation how;
  if (count > 1) how.stiffnessPower = std::atof(words[1]);
  if (count > 2) how.keptTension_cN_tex = std::atof(words[2]);
  const double press = count > 3 ? std::atof(words[3]) : 0;
  loomlight::printTables(how, press, count > 4 ? words[4] : "");
  return 0;
}
