#pragma once

#include <map>
#include <optional>

#include "ui/widgets/fields.h"

namespace loomlight {

/// What is known of the colour that the cloth shows where a fibre lies on top.
struct ClothColourModel {
  enum class State { measuring, known, hidden, failed };
  State state = State::measuring;
  Rgb colour{0};          ///< linear; of the cloth as it is, where it is known
  double difference = 0;  ///< CIEDE2000 from what is wanted, where something is
  bool tooLight = false, tooDark = false;
};

/// Which colours were asked for.
struct ClothColourView {
  std::map<int, Rgb> wanted;  ///< by fibre
  uint64_t wish = 0;          ///< counts up when a colour is asked for
};

/// The colour that the designer wants the cloth to have, beside the one it has.
void clothColourRows(Ui& ui, int fibre, const ClothColourModel& model, ClothColourView& view);

}  // namespace loomlight
