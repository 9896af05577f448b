#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands/cloth_dye.h"
#include "app/cli/inputs.h"
#include "app/cli/option_values.h"
#include "core/fabric/weave/structure_library.h"

namespace loomlight {

/// loomlight convert IN OUT
struct ConvertCommand {
  FabricSource input;       ///< .json, .loomlight, .wif, .png (weave bitmap) or .exr (a picture of ours)
  std::string output;       ///< .json, .loomlight, .wif, .pdf (the draft for print), .png, or for looms .tif and .bmp
  bool drawsDraft = false;  ///< a .png is the draft for print as well; else the weave, a pixel a crossing
  std::string like;         ///< a fabric that gives all but the weave; empty: none
  std::optional<MadeStructure> structure;  ///< in place of the weave
  /// Not empty: IN is a picture (.png), and these stand in the place of its colours, from dark to light.
  std::vector<MadeStructure> colours;
  std::optional<PictureSize> repeat;      ///< ends and picks of the picture; its pixels where not given
  std::vector<ClothColour> clothColours;  ///< what the cloth is to look like, of some of its fibres
  std::optional<std::string> illuminant;  ///< under which a measured one that cannot be had is nearest; D65
};

/// Says on stderr what is in the output otherwise than in the input. Exit status 0, or that of an
/// interrupt while colours are found. Throws InputError.
int run(const ConvertCommand& command);

}  // namespace loomlight
