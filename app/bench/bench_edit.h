#pragma once

#include <string>

namespace loomlight {

/// loomlight bench edit: how long the editor's workers take to answer every kind of edit on four cloths, and how long a
/// full build of the edited cloth takes.
struct EditBenchCommand {
  std::string folder;  ///< where page and tables go
  bool quick = false;  ///< small cloths, small pictures, one round: for tests
  bool json = false;   ///< the tables on stdout too
  int threads = 0;     ///< 0: as in the window, all
};

/// Exit status 0, or 130 when stopped, without a page then. Throws InputError.
int run(const EditBenchCommand& command);

}  // namespace loomlight
