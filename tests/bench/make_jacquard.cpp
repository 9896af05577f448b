// Weaves samples/jacquard.json anew, or the fabric named on the command line: its yarns and sett stay as they are.
#include <iostream>

#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/weave/jacquard.h"

int main(int argc, char** argv) try {
  const char* file = argc > 1 ? argv[1] : LOOMLIGHT_SAMPLES "/jacquard.json";
  loomlight::Fabric fabric = loomlight::readFabric(file);
  fabric.weave = loomlight::damaskJacquard(640, 640);
  loomlight::writeFabric(fabric, file);
} catch (const loomlight::InputError& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
