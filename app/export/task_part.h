#pragma once

#include "core/base/task.h"

namespace loomlight {

/// A step of long work, which takes its progress from one fraction to another. `whole` must outlive it.
inline Task partOf(const Task& whole, double from, double to) {
  Task part = whole;
  part.progress = [&whole, from, to](double fraction) { whole.report(from + (to - from) * fraction); };
  return part;
}

}  // namespace loomlight
