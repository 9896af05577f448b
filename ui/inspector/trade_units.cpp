#include "ui/inspector/trade_units.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "ui/widgets/fields.h"

namespace loomlight {

std::string countText(double tex, CountSystem system) {
  return fmt::format("{:.1f} {}", countFromTex(tex, system), countUnit(system));
}

void countSystemRow(Ui& ui, const std::string& prefix, CountSystem& system) {
  static constexpr std::array kSystems = {CountSystem::tex,    CountSystem::dtex,   CountSystem::denier,
                                          CountSystem::metric, CountSystem::cotton, CountSystem::worsted,
                                          CountSystem::linen};
  static constexpr const char* kNames[] = {"tex (g per km)", "dtex (g per 10 km)", "den (g per 9 km)",
                                           "Nm (km per kg)", "Ne (cotton count)",  "NeK (worsted count)",
                                           "NeL (linen lea)"};
  int chosen = static_cast<int>(std::find(kSystems.begin(), kSystems.end(), system) - kSystems.begin());
  if (choiceField(ui,
                  {prefix + ".count_system", "Counted in",
                   "The system of the trade in which the count is shown. Typed counts may be in any of them."},
                  kNames, chosen))
    system = kSystems[static_cast<size_t>(chosen)];
}

void twistUnitRow(Ui& ui, const std::string& prefix, bool& asMultiplier) {
  static constexpr const char* kUnits[] = {"turns/m", "TM"};
  int unit = asMultiplier ? 1 : 0;
  segmentField(ui,
               {prefix + ".twist_unit", "Twist in",
                "Turns on a metre, or the twist multiplier TM: turns per inch over the square root of the cotton "
                "count. Warp yarns have 3.8 to 4.5, soft knitting yarns 3.2 to 3.8."},
               kUnits, unit);
  asMultiplier = unit == 1;
}

void pieceSizeRows(Ui& ui, const std::string& prefix, PieceSize& piece) {
  NumberStyle length;
  length.unit = "m";
  length.min = kPieceLength_m[0];
  length.max = kPieceLength_m[1];
  length.logarithmic = true;
  numberField(ui, {prefix + ".piece_length", "Length", "Of the piece, along the warp"}, length, piece.length_m);
  NumberStyle width;
  width.unit = "cm";
  width.min = kPieceWidth_cm[0];
  width.max = kPieceWidth_cm[1];
  width.logarithmic = true;
  width.decimals = 1;
  numberField(ui, {prefix + ".piece_width", "Width", "Of the piece, along the weft"}, width, piece.width_cm);
}

}  // namespace loomlight
