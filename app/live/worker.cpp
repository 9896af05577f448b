#include "app/live/worker.h"

#include <exception>
#include <new>

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

std::string problemCaught() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "It needs more memory than there is.";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "It failed, and does not say why.";
  }
}

}  // namespace loomlight
