#include "app/cli/commands/thumbnail_command.h"

#include "app/cli/inputs.h"
#include "app/export/draft_picture.h"
#include "render/transport/reached_colours.h"

namespace loomlight {

int run(const ThumbnailCommand& command) {
  const Fabric fabric = fabricFrom({command.input, {}});
  writePng(command.output, draftPicture(fabric, *soonReachedColours(fabric, Task{}), command.side, command.side));
  return 0;
}

}  // namespace loomlight
