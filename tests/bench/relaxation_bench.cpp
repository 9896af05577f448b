#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/geometry/cloth_geometry.h"
#include "tests/bench/relaxation_cloths.h"

// Crimp and thickness of cloth that nothing presses: ours in closed form, beside yarns of hard strands that were
// relaxed, without any tension and with the loom's. bench_relaxation [POWER [NAME]]: the power of a yarn's count that
// its stiffness goes by (2), and only the constructions of such a name.
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

void printTable(double stiffnessPower, const std::string& name) {
  fmt::print("Stiffness goes by the count to the power of {:g}. Crimp in %, warp / weft; thickness in mm.\n\n",
             stiffnessPower);
  fmt::print("| construction | fitted | ours | slack | off by | under tension | off by | overlap, drift |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::array<int, 2> within{};
  int all = 0;
  for (const Construction& of : constructions()) {
    if (std::string(of.name).find(name) == std::string::npos) continue;
    const Fabric fabric = fabricOf(of.cloth);
    const ClothMeasures ours =
        ClothGeometry(fabric, fabric.weave.ends(), fabric.weave.picks(), nullptr, true).measure();
    fmt::print("| {} | {} | {:.1f} / {:.1f}, {:.3f} ", of.name, of.wasFitted ? "yes" : "no", 100 * ours.crimpWarp,
               100 * ours.crimpWeft, ours.thickness_mm);
    double overlap = 0, drift = 0;
    for (const bool slack : {true, false}) {
      Relaxation how;
      how.stiffnessPower = stiffnessPower;
      if (!slack) how.washedTension_cN_tex = how.tension_cN_tex;
      const RelaxedMeasures relaxed = relax(of.cloth, how);
      const Gap gap = gapOf(ours, relaxed);
      fmt::print("| {:.1f} / {:.1f}, {:.3f} | {:.1f}, {:.0f} % ", 100 * relaxed.crimpWarp, 100 * relaxed.crimpWeft,
                 relaxed.thickness_mm, gap.crimp, gap.thickness);
      within[slack ? 0 : 1] += gap.isWithin();
      overlap = std::max(overlap, relaxed.overlap);
      drift = std::max(drift, relaxed.drift);
    }
    fmt::print("| {:.2f}, {:.1f} |\n", overlap, 100 * drift);
    std::fflush(stdout);  // the whole takes minutes
    ++all;
  }
  fmt::print("\nWithin 2 points of crimp and 15 % of thickness: {} of {} slack, {} under tension.\n", within[0], all,
             within[1]);
}

}  // namespace
}  // namespace loomlight

int main(int count, char** words) {
  loomlight::printTable(count > 1 ? std::atof(words[1]) : 2.0, count > 2 ? words[2] : "");
  return 0;
}
