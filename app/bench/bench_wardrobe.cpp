#include "app/bench/bench_wardrobe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/bench/studies/report_page.h"
#include "app/bench/studies/wardrobe_study.h"
#include "core/base/quantile.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

using Row = std::vector<std::string>;

std::string inPercent(double share) {
  return fmt::format("{:+.0f} %", 100 * share);
}

const Row kHeader = {"cloth",        "g/m2, trade", "ours",     "off",          "mm, trade", "ours",         "off",
                     "cover, round", "as pressed",  "crimp, %", "sett, per cm", "tex",       "why it is off"};

Row rowOf(const ClothComparison& of) {
  const TradeFigures& trade = of.cloth->trade;
  const Fabric& fabric = of.fabric;
  const bool isOff = std::abs(of.thicknessOff()) > kThicknessAllowance.share;
  return {of.cloth->name,
          fmt::format("{:g}", trade.mass_g_m2),
          fmt::format("{:.1f}", of.ours.arealMass_g_m2),
          inPercent(of.massOff()),
          fmt::format("{:.2f}", trade.thickness_mm),
          fmt::format("{:.2f}", of.ours.thickness_mm),
          inPercent(of.thicknessOff()),
          fmt::format("{:.2f}", of.round.fraction),
          fmt::format("{:.2f}", of.ours.cover),
          fmt::format("{:.1f} x {:.1f}", 100 * of.ours.crimpWarp, 100 * of.ours.crimpWeft),
          fmt::format("{:g} x {:g}", fabric.ends_per_cm, fabric.picks_per_cm),
          fmt::format("{:.1f} x {:.1f}", meanCount_tex(fabric, System::warp), meanCount_tex(fabric, System::weft)),
          isOff ? trade.thickness.reason : ""};
}

/// Which way the whole table leans, as single rows within their bounds do not show.
std::string leaningOf(const std::vector<ClothComparison>& cloths) {
  std::vector<double> off;
  for (const ClothComparison& of : cloths) off.push_back(of.thicknessOff());
  const double median = quantile(off, 0.5);
  return fmt::format("In the median our cloths are {:.0f} % {} than the trade's, and {} of {} are thinner.",
                     100 * std::abs(median), median < 0 ? "thinner" : "thicker",
                     std::ranges::count_if(off, [](double share) { return share < 0; }), off.size());
}

constexpr const char* kChosenAfterwards =
    "Not all of ours is independent of these figures. Counts and setts are those of the trade's constructions, so that "
    "a mass tests little more than the crimp. No mill quotes how readily its yarns flatten or how hard its cloth is "
    "pressed: `flattening` and `press` were chosen by hand for each cloth. After a comparison with these figures, when "
    "the law of crossings had changed, these were chosen anew: the flattening of charmeuse, crepe de chine, lining "
    "twill, taffeta, linen and damask, and the picks of voile (23.0 per cm, before 22.8); the press of linen, damask "
    "and voile was changed, too, and set back, and the reason that is said for georgette was added. The gabardine's "
    "figures were set down after ours were looked at, as its first construction was heavier than what is sold. The "
    "milling of flannel, tweed and blanket was chosen by eye with these figures known, and the flannel's once more so "
    "that its thickness is within the bound (0.65, before 0.6): a part of that is the nap, which is not modelled. Of "
    "all else it is not on record whether it was chosen before a comparison or after one. A thickness that agrees is "
    "therefore no prediction.";

}  // namespace

int run(const ClothsBenchCommand& command) {
  ReportPage page(command.folder, "cloths", "Cloths: what the trade says of them, and what they turn out as");
  page.paragraph(fmt::format(
      "Finished cloths of samples/cloths as their geometry has them, beside figures that are not ours. Mass is to be "
      "within {:.0f} % of the trade's and thickness within {:.0f} %, or the reason is said. Both covers are shares "
      "of the plane, and ours: the first is a formula, of round yarns (Peirce's cover factor over 28), the second is "
      "that of the geometry, whose yarns are wider than round. The trade quotes none.",
      100 * kMassAllowance.share, 100 * kThicknessAllowance.share));
  std::vector<Row> rows, sources;
  std::vector<ClothComparison> cloths;
  for (const WardrobeCloth& cloth : wardrobe()) {
    cloths.push_back(compareWithTrade(cloth));
    rows.push_back(rowOf(cloths.back()));
    sources.push_back({cloth.name, cloth.trade.construction, cloth.trade.source});
  }
  page.paragraph(leaningOf(cloths));
  page.paragraph(kChosenAfterwards);
  page.table("cloths", kHeader, rows);
  page.heading("Where the trade's figures are from");
  page.paragraph(
      "Recalled: known to the trade and its handbooks, and not looked up; of a range, the middle is compared with. "
      "Else it was read, at the time of writing, where it says.");
  page.table("cloths_sources", {"cloth", "construction", "source"}, sources);
  fmt::print("{}{}\n", markdownTable(kHeader, rows), page.finish());
  return 0;
}

}  // namespace loomlight
