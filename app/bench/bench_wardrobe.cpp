#include "app/bench/bench_wardrobe.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "app/bench/studies/report_page.h"
#include "app/bench/studies/wardrobe_study.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

using Row = std::vector<std::string>;

std::string inPercent(double share) {
  return fmt::format("{:+.0f} %", 100 * share);
}

const Row kHeader = {"cloth",        "g/m2, trade", "ours",     "off",          "mm, trade", "ours",         "off",
                     "cover, trade", "ours",        "crimp, %", "sett, per cm", "tex",       "why it is off"};

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
          fmt::format("{:.2f}", trade.cover),
          fmt::format("{:.2f}", of.cover),
          fmt::format("{:.1f} x {:.1f}", 100 * of.ours.crimpWarp, 100 * of.ours.crimpWeft),
          fmt::format("{:g} x {:g}", fabric.ends_per_cm, fabric.picks_per_cm),
          fmt::format("{:.1f} x {:.1f}", meanCount_tex(fabric, System::warp), meanCount_tex(fabric, System::weft)),
          isOff ? trade.thickness.reason : ""};
}

}  // namespace

int run(const ClothsBenchCommand& command) {
  ReportPage page(command.folder, "cloths", "Cloths: what the trade says of them, and what they turn out as");
  page.paragraph(fmt::format(
      "Finished cloths of samples/cloths as their geometry has them, beside figures that are not ours. Mass is to be "
      "within {:.0f} % of the trade's and thickness within {:.0f} %, or the reason is said. The trade's cover is that "
      "of round threads (Peirce) in the construction that it quotes, ours that of yarns as they are pressed.",
      100 * kMassAllowance.share, 100 * kThicknessAllowance.share));
  std::vector<Row> rows, sources;
  for (const WardrobeCloth& cloth : wardrobe()) {
    rows.push_back(rowOf(compareWithTrade(cloth)));
    sources.push_back({cloth.name, cloth.trade.construction, cloth.trade.source});
  }
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
