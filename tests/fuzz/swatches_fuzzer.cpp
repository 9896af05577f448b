#include "core/fabric/swatch/measured_swatch.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"

namespace loomlight::fuzz {

void fuzzSwatches(std::string_view bytes) {
  isRead("a.txt", [&] {
    const SwatchFile file = swatchesFrom(bytes, "a.txt");
    expect(!file.swatches.empty(), "a file without swatches");
    for (const MeasuredSwatch& swatch : file.swatches) {
      expect(!swatch.name.empty(), "a swatch without a name");
      for (const float band : bandReflectance(swatch)) expect(band >= 0 && band <= 1, "a reflectance is none");
    }
  });
}

}  // namespace loomlight::fuzz
