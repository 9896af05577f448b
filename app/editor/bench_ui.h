#pragma once

namespace loomlight {

/// loomlight bench ui: how long the window's thread is kept from drawing while the heaviest rebuild runs.
struct UiBenchOptions {
  bool quick = false;  ///< a small jacquard and few frames: for tests
  bool json = false;   ///< JSON instead of a table
  int threads = 0;     ///< of the workers; 0: all
};

/// Opens the window on a jacquard of 4000 x 4000, makes one edit after another that rebuilds all of it, and draws frame
/// after frame meanwhile; prints what frames took besides drawing. Returns the exit status. Throws InputError when
/// there is no display.
int runUiBench(const UiBenchOptions& options);

}  // namespace loomlight
