#pragma once

#include <string>

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/yarn_need.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// In what a designer counts yarns and twists, and the piece that is usually woven; kept between sessions.
struct TradeUnits {
  CountSystem count = CountSystem::tex;
  bool twistAsMultiplier = false;  ///< else turns per metre
  PieceSize piece;                 ///< whose yarn is reckoned
};

/// As it is shown: "19.7 tex", "30.0 Ne".
std::string countText(double tex, CountSystem system);

// Rows to change them. Tests know them by prefix.count_system and the like.
void countSystemRow(Ui& ui, const std::string& prefix, CountSystem& system);
void twistUnitRow(Ui& ui, const std::string& prefix, bool& asMultiplier);
void pieceSizeRows(Ui& ui, const std::string& prefix, PieceSize& piece);

}  // namespace loomlight
