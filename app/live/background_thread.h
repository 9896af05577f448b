#pragma once

namespace loomlight {

/// Lets every other thread of the program go first, from here on: for work that nobody waits for.
void lowerPriorityOfThisThread();

}  // namespace loomlight
