#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/option_values.h"
#include "core/fabric/model/fabric.h"

namespace loomlight {

/// What a command line wants otherwise than the fabric's file says.
struct FabricOptions {
  std::optional<PictureSize> size;
  std::optional<int> samplesPerPixel;
  std::optional<uint64_t> seed;
  std::optional<int> resolution;
  std::optional<int> maxDepth;
  std::optional<Method> method;
  std::optional<Estimator> estimator;
  std::optional<EventLaw> eventLaw;  ///< without an estimator: means Estimator::none, whose law it is
  std::optional<DrapeChoice> drape;
  std::optional<double> grain_deg;
  std::optional<double> uvScale_mm;
  std::optional<ViewChoice> view;
  std::optional<LightChoice> light;
  std::optional<double> temperature_K;  ///< of the light
  std::optional<IlluminantChoice> illuminant;
  std::optional<Observer> observer;
  std::string colourway;  ///< its name; empty: the colours that the fabric has now
};

/// The fabric with these options. Another drape without a view keeps the camera's angle, and moves the camera to see
/// all of the piece. Throws InputError where a mesh that is to be seen cannot be used, or there is no such colourway in
/// the fabric of `source`.
Fabric withOptions(Fabric fabric, const FabricOptions& options, const std::string& source);

}  // namespace loomlight
