#pragma once

#include <array>
#include <optional>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The lamps that a light booth switches through: daylight, the tube of a shop (TL84), the bulb at home, a white diode.
inline constexpr std::array kBoothLamps{StandardIlluminant::d65, StandardIlluminant::f11, StandardIlluminant::a,
                                        StandardIlluminant::ledB3};

/// The same light from another lamp. The temperature is a black body's, or a tint that no lamp of a name has.
inline Light underLamp(Light light, StandardIlluminant lamp) {
  light.illuminant = lamp;
  if (lamp != StandardIlluminant::blackBody) light.temperature_K = Light{}.temperature_K;
  return light;
}

/// By which lamp of the booth to judge after `judged`, of a cloth whose own lamp is `own`: round the booth, from its
/// own and back to it. Null: by the cloth's own.
std::optional<StandardIlluminant> nextLamp(StandardIlluminant own, std::optional<StandardIlluminant> judged);

}  // namespace loomlight
