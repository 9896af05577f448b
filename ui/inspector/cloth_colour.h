#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/spectrum.h"

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

/// A colour that the cloth is to have, as it was picked or as it was measured.
struct WantedColour {
  Rgb colour{0};                     ///< linear; in daylight
  std::optional<Spectrum> measured;  ///< its reflectance in bands, 1 is a perfect diffuser
  std::string name;                  ///< of what was measured
};

/// Which colours were asked for.
struct ClothColourView {
  std::map<int, WantedColour> wanted;  ///< by fibre
  uint64_t wish = 0;                   ///< counts up when a colour is asked for
};

/// The colour that the designer wants the cloth to have, beside the one it has.
void clothColourRows(Ui& ui, int fibre, const ClothColourModel& model, ClothColourView& view);

}  // namespace loomlight
