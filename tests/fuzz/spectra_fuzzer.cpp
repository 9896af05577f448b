#include "render/colour/illuminants.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/fuzz/input_file.h"

namespace loomlight::fuzz {

void fuzzSpectra(std::string_view bytes) {
  static const InputFile input(".txt");
  const std::string& name = input.holding(bytes);
  isRead(name, [&] {
    const Illuminant lamp = illuminantCalled(name);
    for (const double power : lamp.power) expect(power >= 0 && power < 100.001, fmt::format("a power is {}", power));
  });
}

}  // namespace loomlight::fuzz
