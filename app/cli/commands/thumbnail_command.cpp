#include "app/cli/commands/thumbnail_command.h"

#include "app/cli/inputs.h"
#include "app/export/draft_picture.h"

namespace loomlight {

int run(const ThumbnailCommand& command) {
  writePng(command.output, draftPicture(fabricFromFile(command.input), command.side));
  return 0;
}

}  // namespace loomlight
