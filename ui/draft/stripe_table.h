#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/weave/yarn_sequence.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// The stripes of an order as they are worked on: neighbours of one yarn stay two rows for as long as they make up the
/// order, so that no row goes while its colour is chosen.
struct StripeRows {
  std::vector<Stripe> stripes;
  int dragged = -1;   ///< the edge after that stripe is dragged; -1: none
  float perYarn = 0;  ///< pixels of the bar, while an edge is dragged

  /// Those that the order has, where it is another one than these make up.
  void follow(const std::vector<int>& sequence);
};

/// The ends or picks whose stripes are shown.
struct StripedSystem {
  const std::vector<ImVec4>& yarnColours;  ///< for the display
  const std::vector<std::string>& yarnNames;
  double pitch_mm = 1;                  ///< between ends or picks
  const char *one = "", *several = "";  ///< what they are called behind a number
};

// Both return the order after an edit; `rows` are up to date.

/// One repeat, as wide as the panel, whose edges can be dragged: one between two stripes gives ends of the one to
/// the other, the last one makes the last stripe wider or narrower.
std::optional<std::vector<int>> stripeBar(Ui& ui, const StripedSystem& system, StripeRows& rows);
/// A line for each stripe: its colour, its ends or picks and its width, any of which can be set, and buttons to add
/// another one after it and to take it away.
std::optional<std::vector<int>> stripeTable(Ui& ui, const StripedSystem& system, StripeRows& rows);

}  // namespace loomlight
