// What --version says is made with all of the program, which the fuzzers do without.
#include "app/cli/version_text.h"

namespace loomlight {

std::string versionText() {
  return "fuzzed";
}

}  // namespace loomlight
