#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_reader.h"

namespace loomlight {

/// A small weaving file as a careful program writes it: a 2/2 twill of two colours, with a private section.
inline std::string twillFile() {
  return R"([WIF]
Version=1.1
Date=April 20, 1997
Developers=wif@mhsoft.com
Source Program=Testweaver
Source Version=2.5

[CONTENTS]
COLOR PALETTE=true
TEXT=true
WEAVING=true
WARP=true
WEFT=true
NOTES=true
TIEUP=true
COLOR TABLE=true
THREADING=true
WARP COLORS=true
TREADLING=true
WEFT SPACING=true
PRIVATE TESTWEAVER LOOM=true

[COLOR PALETTE]
Entries=4
Range=0,255

[TEXT]
Title=Two twills
Author=A. Weaver

[WEAVING]
Shafts=4
Treadles=4
Rising Shed=true

[WARP]
Threads=8
Color=1
Units=Centimeters
Spacing=0.05
Thickness=0.04

[WEFT]
Threads=6
Color=3
Units=Inches
Spacing=.02

[NOTES]
1=first line
2=
3=third line

[TIEUP]
1=1,2
2=2,3
3=3,4
4=1,4

[COLOR TABLE]
1=255,255,255
2=17,34,200
3=0,0,0
4=120,80,3

[THREADING]
1=1
2=2
3=3
4=4
5=1
6=2
7=3
8=4

[WARP COLORS]
1=1
2=1
3=2
4=2
5=1
6=1
7=2
8=2

[TREADLING]
1=1
2=2
3=3
4=4
5=1
6=2,3

[WEFT SPACING]
2=0.04

[PRIVATE TESTWEAVER LOOM]
; which loom
Model = Big one
  a line of its own
)";
}

inline WifDocument document(std::string_view bytes) {
  WifWarnings warnings;
  return readWif(bytes, "x.wif", warnings);
}

/// The fabric of a weaving file, with the yarns of a new one.
inline Fabric imported(std::string_view bytes, WifSizeChoice sizes = WifSizeChoice::keep) {
  return fabricFromWif(bytes, "x.wif", Fabric{}, sizes).fabric;
}

inline std::vector<std::string> inLines(const std::vector<WifWarning>& warnings) {
  std::vector<std::string> lines;
  for (const WifWarning& warning : warnings) lines.push_back(inOneLine(warning));
  return lines;
}

inline std::vector<std::string> warningsOf(std::string_view bytes) {
  WifWarnings warnings;
  readWif(bytes, "x.wif", warnings);
  return inLines(warnings.list());
}

/// The message of a refusal; empty where the file is read.
inline std::string refusalOf(std::string_view bytes) {
  try {
    document(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Some of the numbers from 1 to `most`, in order.
inline std::vector<int> someNumbers(Random& random, int most, uint32_t oneIn) {
  std::vector<int> numbers;
  for (int n = 1; n <= most; ++n)
    if (random.below(oneIn) == 0) numbers.push_back(n);
  return numbers;
}

/// A document of anything that WIF can say, as the reader makes it.
inline WifDocument randomDocument(Random& random) {
  WifDocument d;
  const int ends = 1 + static_cast<int>(random.below(20)), picks = 1 + static_cast<int>(random.below(20));
  d.draft.shafts = 1 + static_cast<int>(random.below(9));
  d.draft.treadles = static_cast<int>(random.below(10));
  d.draft.risingShed = random.below(2) == 0;
  for (int e = 0; e < ends; ++e) {
    std::vector<int> shafts;
    if (random.below(8) > 0)
      shafts.push_back(1 + static_cast<int>(random.below(static_cast<uint32_t>(d.draft.shafts))));
    if (random.below(20) == 0) shafts = someNumbers(random, d.draft.shafts, 2);
    d.draft.threading.push_back(shafts);
  }
  const bool lifted = random.below(3) == 0;
  if (lifted)
    for (int p = 0; p < picks; ++p) d.draft.liftplan.push_back(someNumbers(random, d.draft.shafts, 2));
  if (!lifted || random.below(4) == 0) {
    for (int t = 0; t < d.draft.treadles; ++t) d.draft.tieUp.push_back(someNumbers(random, d.draft.shafts, 3));
    for (int p = 0; p < picks; ++p) d.draft.treadling.push_back(someNumbers(random, d.draft.treadles, 4));
  }
  const int ranges[][2] = {{0, 255}, {0, 999}, {0, 65535}, {20, 1200}, {-5, 5}};
  const auto& range = ranges[random.below(5)];
  WifPalette& palette = d.rest.palette;
  const int colours = static_cast<int>(random.below(12));
  if (colours > 0) {
    palette.low = range[0];
    palette.high = range[1];
  }
  for (int c = 1; c <= colours; ++c)
    for (int i = 0; i < 3; ++i)
      palette.colours[3 * c - 2][i] =
          range[0] + static_cast<int>(random.below(static_cast<uint32_t>(range[1] - range[0] + 1)));
  const auto colourOfThread = [&] {
    return colours == 0 || random.below(10) == 0
               ? 0
               : 3 * (1 + static_cast<int>(random.below(static_cast<uint32_t>(colours)))) - 2;
  };
  const bool plain = random.below(3) == 0;
  const int common = colourOfThread();
  for (int e = 0; e < ends; ++e) d.warpColours.push_back(plain ? common : colourOfThread());
  for (int p = 0; p < picks; ++p) d.weftColours.push_back(colourOfThread());
  const auto sizes = [&](WifSizes& of, int threads) {
    const auto length = [&] { return (1 + random.below(2'000'000)) / 1e6; };
    of.unit = static_cast<WifUnit>(random.below(3));
    if (random.below(2) == 0) of.spacing = length();
    if (random.below(2) == 0) of.thickness = length();
    for (int thread = 1; thread <= threads; ++thread) {
      if (random.below(5) == 0) of.spacings[thread] = length();
      if (random.below(5) == 0) of.thicknesses[thread] = length();
    }
    // Without a length in [WARP] the unit must still be there: it is, unless all is as if nothing were said.
  };
  sizes(d.rest.warp, ends);
  sizes(d.rest.weft, picks);
  const char* const titles[] = {"", "Plain", " blank ends ", "\"quoted\"", "'", "Tücher für Österreich", "a=b;c]"};
  d.title = titles[random.below(7)];
  for (uint32_t n = random.below(4); n > 0; --n)
    d.notes.push_back(n == 2 ? "" : "note; " + std::to_string(n) + " = [x");
  if (random.below(2) == 0) d.rest.kept.push_back({"WIF", {"Serial=7", "; a comment"}});
  if (random.below(2) == 0) d.rest.kept.push_back({"TEXT", {"Author=Ann \"A\" Weaver", "EMail=a@example.org"}});
  if (random.below(2) == 0) d.rest.kept.push_back({"WEAVING", {"Profile=false"}});
  if (random.below(2) == 0) d.rest.kept.push_back({"WARP SYMBOLS", {"1='X'"}});
  if (random.below(2) == 0) d.rest.kept.push_back({"PRIVATE Prog Thing", {"  a = 1 ;no comment", "", "; one", "junk"}});
  if (random.below(2) == 0) d.rest.kept.push_back({"TW Empty", {}});
  return d;
}

}  // namespace loomlight
