#include "ui/inspector/trade_units.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "ui/widgets/fields.h"
#include "ui/words/trade_words.h"

namespace loomlight {

std::string countText(double tex, CountSystem system) {
  return fmt::format("{:.1f} {}", countFromTex(tex, system), countUnit(system));
}

void countSystemRow(Ui& ui, const std::string& prefix, CountSystem& system) {
  static constexpr std::array kSystems = {CountSystem::tex,    CountSystem::dtex,   CountSystem::denier,
                                          CountSystem::metric, CountSystem::cotton, CountSystem::worsted,
                                          CountSystem::linen};
  int chosen = static_cast<int>(std::find(kSystems.begin(), kSystems.end(), system) - kSystems.begin());
  if (choiceField(ui, {prefix + ".count_system", words::trade::countedIn}, words::trade::countSystems, chosen))
    system = kSystems[static_cast<size_t>(chosen)];
}

void twistUnitRow(Ui& ui, const std::string& prefix, bool& asMultiplier) {
  segmentField(ui, {prefix + ".twist_unit", words::trade::twistIn}, words::trade::twistUnits, asMultiplier);
}

void pieceSizeRows(Ui& ui, const std::string& prefix, PieceSize& piece) {
  NumberStyle length;
  length.unit = "m";
  length.min = kPieceLength_m[0];
  length.max = kPieceLength_m[1];
  length.logarithmic = true;
  numberField(ui, {prefix + ".piece_length", words::trade::pieceLength}, length, piece.length_m);
  NumberStyle width;
  width.unit = "cm";
  width.min = kPieceWidth_cm[0];
  width.max = kPieceWidth_cm[1];
  width.logarithmic = true;
  width.decimals = 1;
  numberField(ui, {prefix + ".piece_width", words::trade::pieceWidth}, width, piece.width_cm);
}

}  // namespace loomlight
