#pragma once

#include <optional>
#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "render/colour/tone.h"
#include "render/transport/half_dome.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// loomlight brdf FABRIC -o OUT: how a flat patch of the fabric reflects, seen by cameras on a half-dome (Fig. 15 of
/// the report).
struct BrdfCommand {
  FabricSource input;
  std::string output;  ///< of OUT.exr, OUT.png and OUT.csv; one of these endings may be there and is left away
  FabricOptions options;
  HalfDomeGrid grid;
  /// Of parallel light, from the normal; beyond 90 it comes from behind the cloth. 0 where neither this nor a light is
  /// given.
  std::optional<double> lightAngle_deg;
  Tone tone;
  int threads = 0;  ///< 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();
  FibreExtent fibreExtent = FibreExtent::automatic;
  static constexpr int kSamples = 4096;  ///< paths for each camera where `options` do not say
};

/// Measures, and writes the three files. Exit status 0, or 130 when stopped, with nothing written. Throws InputError
/// and UsageError.
int run(const BrdfCommand& command);

}  // namespace loomlight
