#include "app/live/background_thread.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace loomlight {

void lowerPriorityOfThisThread() {
#ifdef __linux__
  // Elsewhere than on Linux this would be the priority of the whole program. Ten steps: a ninth of a busy core.
  setpriority(PRIO_PROCESS, 0, 10);
#endif
}

}  // namespace loomlight
