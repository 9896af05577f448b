#pragma once

#include "ui/inspector.h"

namespace loomlight {

// Rows of the yarn's page that speak the spinner's language. Each is true when the yarn changed.

/// Count, in the system that is chosen, with plies and cords where it has them ("30/2", "20/2/3"); or the number of
/// fibres.
bool countRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn);
/// Plies and cords, and the twist of each level in turns per metre or as a multiplier.
bool twistRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn);
/// Packing, and the diameter that goes with it: either can be set, and the other follows.
bool bulkRows(Ui& ui, const Fibre& fibre, Yarn& yarn);
/// What it is spun of, one fibre or a blend of two; a new one can be added to the list for that.
bool fibreRows(Ui& ui, std::vector<Fibre>& fibres, Yarn& yarn);

}  // namespace loomlight
