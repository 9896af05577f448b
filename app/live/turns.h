#pragma once

namespace loomlight {

/// One of the two pictures that share the tracer's threads.
struct Contender {
  bool wants = false;  ///< there is something left to trace
  int divider = 0;     ///< of its last pass; 0: nothing to be seen yet
  double spent_s = 0;  ///< tracing it, since both have been there
};

enum class Turn { none, picture, lens };

/// Whose pass is next: first what cannot be seen yet, then what is coarse, then what has had less time. Pure.
Turn nextTurn(const Contender& picture, const Contender& lens);

}  // namespace loomlight
