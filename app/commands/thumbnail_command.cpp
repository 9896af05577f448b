#include "app/commands/thumbnail_command.h"

#include "app/commands/inputs.h"
#include "app/workers/draft_picture.h"

namespace loomlight {

int run(const ThumbnailCommand& command) {
  writePng(command.output, draftPicture(fabricFromFile(command.input), command.side));
  return 0;
}

}  // namespace loomlight
