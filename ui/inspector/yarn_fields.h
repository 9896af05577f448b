#pragma once

#include "ui/inspector/inspector.h"

namespace loomlight {

// Rows of the yarn's page that speak the spinner's language. Each is true when the yarn changed.

/// Count, in the system that is chosen, with plies and cords where it has them ("30/2", "20/2/3"); or the number of
/// fibres. A count typed with its filaments ("167 dtex f48") says how fine each is, as `filament_dtex`.
bool countRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn, std::optional<double>& filament_dtex);
/// Plies and cords, and the twist of each level in turns per metre or as a multiplier.
bool twistRows(Ui& ui, const Fibre& fibre, TradeUnits& units, Yarn& yarn);
/// Strands that an edit has put together, and that no twist holds yet, take back 65 % of the twist that each has: that
/// makes a yarn that does not kink.
void twistNewStrands(const Yarn& before, Yarn& yarn);
/// Packing, and the diameter that goes with it: either can be set, and the other follows.
bool bulkRows(Ui& ui, const Fibre& fibre, Yarn& yarn);
/// Its loose and its wrapper fibres. The hairiness can be set by the number of hairs, or by H.
bool hairRows(Ui& ui, const Fibre& fibre, Yarn& yarn);
/// How evenly it is spun, and its slubs.
bool evennessRows(Ui& ui, Yarn& yarn);
/// What it is spun of, one fibre or a blend of two; a new one can be added to the list for that.
bool fibreRows(Ui& ui, std::vector<Fibre>& fibres, Yarn& yarn);

}  // namespace loomlight
