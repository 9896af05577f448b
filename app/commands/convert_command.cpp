#include "app/commands/convert_command.h"

#include <fmt/format.h>

#include "app/commands/draft_sheet.h"
#include "app/commands/inputs.h"
#include "app/commands/weave_bitmap.h"
#include "app/workers/file_name.h"
#include "core/base/error.h"
#include "core/fabric/fabric_json.h"
#include "core/fabric/structure_edit.h"
#include "core/fabric/wif_fabric.h"

namespace loomlight {

int run(const ConvertCommand& command) {
  Fabric fabric = fabricFromFile(command.input, command.wifSizes);
  if (!command.like.empty()) {
    Fabric like = fabricFromFile(command.like);
    like.name = fabric.name;
    like.weave = fabric.weave;
    like.draft = fabric.draft;
    like.wif = fabric.wif;
    fabric = std::move(like);
  }
  if (command.structure) fabric = withStructure(fabric, {}, *command.structure, {}).fabric;
  const std::string extension = lowerExtension(command.output);
  if (extension == ".json") {
    writeFabric(fabric, command.output);
  } else if (extension == ".wif") {
    for (const std::string& remark : writeWifFabric(fabric, command.output))
      fmt::print(stderr, "{}: {}\n", command.output, remark);
  } else if (extension == ".pdf" || (extension == ".png" && command.drawsDraft)) {
    writeDraftSheet(command.output, fabric, {});
  } else if (extension == ".png") {
    writeWeaveBitmap(command.output, fabric.weave);
  } else {
    throw InputError(fmt::format(
        "{}: expected the name of a fabric (.json), a draft (.wif, for print .pdf) or a weave bitmap (.png)",
        command.output));
  }
  fmt::print("{}: {} ends, {} picks\n", command.output, fabric.weave.ends(), fabric.weave.picks());
  return 0;
}

}  // namespace loomlight
