#include "core/fabric/palette/palette.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"

namespace loomlight::fuzz {
namespace {

void read(std::string_view bytes, const std::string& name) {
  const Palette palette = paletteFrom(bytes, name);
  expect(!palette.colours.empty(), "a palette without colours");
  for (const NamedColour& colour : palette.colours) {
    for (int c = 0; c < 3; ++c) expect(colour.linear[c] >= 0 && colour.linear[c] <= 1, "a colour is none");
    if (colour.lab) expect(colour.lab->L >= 0 && colour.lab->L <= 100, "a lightness is none");
    if (!colour.reflectance) continue;
    for (const float band : *colour.reflectance) expect(band >= 0 && band <= 1, "a reflectance is none");
  }
}

}  // namespace

void fuzzPalettes(std::string_view bytes) {
  // Photoshop's have no mark of their own: its reader is the one that comes by the name.
  for (const char* const name : {"a.csv", "a.aco"}) isRead(name, [&] { read(bytes, name); });
}

}  // namespace loomlight::fuzz
