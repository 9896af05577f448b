// Writes samples/folded_cloth.obj, or the file named on the command line. The motion is chaotic in its last bits, so
// another compiler makes another cloth, as good as this one: look at it before committing it.
#include <fstream>
#include <iostream>

#include "tests/bench/cloth_drop.h"

int main(int argc, char** argv) {
  const char* file = argc > 1 ? argv[1] : LOOMLIGHT_SAMPLES "/folded_cloth.obj";
  std::ofstream stream(file);
  stream << loomlight::toObj(loomlight::dropCloth({}));
  if (!stream.flush()) {
    std::cerr << file << ": cannot be written\n";
    return 1;
  }
}
