#pragma once

#include <string>
#include <vector>

namespace loomlight {

/// loomlight bench clear: how fast what the editor shows comes near the picture that it converges to, after every kind
/// of edit, through the editor's own builder, tracer and display policy.
struct ClearBenchCommand {
  enum class Sharing { on, off, both };
  /// Sides of pictures, pixels: nine windows find room in the least, and a window on a screen in the most.
  static constexpr int kLeastSide = 48, kMostSide = 4096;
  std::string folder;               ///< where page and tables go, and the converged pictures, for the next time
  bool quick = false;               ///< one setting, a small picture, seconds: for tests
  bool pictures = false;            ///< also writes what was shown at some times
  std::vector<std::string> only{};  ///< names of cloths, drapes, lights and edits; see ClearChoice
  Sharing sharing = Sharing::both;  ///< whether light is shared between repeats
  int width = 0, height = 0;        ///< of the pictures, pixels; 0: as the extent has it
  double seconds = 0;               ///< that each edit is looked at; 0: as the extent has it
  int referenceSamples = 0;         ///< of the converged pictures; 0: as the extent has it
  int threads = 0;                  ///< 0: as in the window, all
};

/// Exit status 0, or 130 when stopped, without a page then. Throws InputError.
int run(const ClearBenchCommand& command);

}  // namespace loomlight
