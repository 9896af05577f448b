// Apart from what makes media: a command line names this limit before anything is made.
#include "core/base/memory.h"
#include "render/transport/make_medium.h"

namespace loomlight {

double defaultMemoryLimit_bytes() {
  return 0.75 * static_cast<double>(physicalMemory_bytes());
}

}  // namespace loomlight
