#include "app/cli/commands/convert_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/cli/commands/woven_picture.h"
#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/export/file_name.h"
#include "app/export/sheet/draft_sheet.h"
#include "app/export/weave_bitmap.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/weave/structure_edit.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/yarn/presets.h"

namespace loomlight {

namespace {

/// Says which colour became what.
Fabric fabricFromPicture(const ConvertCommand& command) {
  std::vector<Weave> structures;
  for (const MadeStructure& structure : command.colours) structures.push_back(structure.weave);
  const WovenPicture woven = readWovenPicture(command.input.file, structures, command.repeat);
  for (size_t i = 0; i < structures.size(); ++i) {
    const Rgb8& colour = woven.picture.palette[i];
    fmt::print("#{:02x}{:02x}{:02x}, {:.1f} %: {}\n", colour[0], colour[1], colour[2], 100 * woven.picture.shares[i],
               command.colours[i].name);
  }
  Fabric fabric = plainCotton();
  fabric.name = std::filesystem::path(command.input.file).stem().string();
  return rewoven(fabric, woven.weave, {}).fabric;
}

}  // namespace

int run(const ConvertCommand& command) {
  Fabric fabric = command.colours.empty() ? fabricFrom(command.input) : fabricFromPicture(command);
  if (!command.like.empty()) {
    Fabric like = fabricFrom({command.like, {}});
    like.name = fabric.name;
    like.weave = fabric.weave;
    like.draft = fabric.draft;
    like.wif = fabric.wif;
    fabric = std::move(like);
  }
  if (command.structure) fabric = withStructure(fabric, {}, *command.structure, {}).fabric;
  if (!command.clothColours.empty()) {
    expectWritable(command.output);
    auto inColour =
        dyed(std::move(fabric), command.clothColours, command.illuminant.value_or("D65"), command.input.file);
    if (!inColour) return Interrupt::kExitStatus;
    fabric = std::move(*inColour);
  }
  const std::string extension = lowerExtension(command.output);
  if (isFabricFile(command.output)) {
    writeFabric(fabric, command.output);
  } else if (extension == ".wif") {
    for (const std::string& remark : writeWifFabric(fabric, command.output))
      fmt::print(stderr, "{}: {}\n", command.output, remark);
  } else if (extension == ".pdf" || (extension == ".png" && command.drawsDraft)) {
    const Interrupt interrupt;
    if (!writeDraftSheet(command.output, fabric, {}, interrupt.task(0))) return Interrupt::kExitStatus;
  } else if (extension == ".png" || extension == ".bmp" || extension == ".tif" || extension == ".tiff") {
    writeWeaveBitmap(command.output, fabric);
  } else {
    throw InputError(
        fmt::format("{}: expected the name of a fabric (.json, .loomlight), a draft (.wif, for print .pdf) or a weave "
                    "bitmap (.png, for looms .tif or .bmp)",
                    command.output));
  }
  fmt::print("{}: {} ends, {} picks\n", command.output, fabric.weave.ends(), fabric.weave.picks());
  return 0;
}

}  // namespace loomlight
