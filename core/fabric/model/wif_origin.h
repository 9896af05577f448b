#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/absorption.h"
#include "core/fabric/model/field_info.h"
#include "core/fabric/model/unknown_keys.h"
#include "core/fabric/model/wif_document.h"

namespace loomlight {

/// What one of the fabric's yarns was given when the file was read.
struct WifYarn {
  int colour = 0;                ///< a number of the palette, 0 for none: the designer's own colour
  Absorption absorption_per_mm;  ///< of its fibre; of a blend, of the first
  UnknownKeys unknown;
  friend bool operator==(const WifYarn&, const WifYarn&);
};

/// Where a fabric came from: a WIF draft. It holds what the fabric does not, for the day when the fabric is written
/// as a WIF draft again. Edits leave it alone.
struct WifOrigin {
  std::string program;  ///< that wrote the file
  int ends = 0;         ///< of its draft
  int picks = 0;
  /// What the fabric had when the file was read. As long as it has, the file's own sizes are handed back: a draft goes
  /// out with the sizes it came with, unless the designer has set others.
  double ends_per_cm = 0;
  double picks_per_cm = 0;
  double warpDiameter_mm = 0;  ///< mean over the threads
  double weftDiameter_mm = 0;
  /// Of each thread, repeating, in a system of which the file says something of single threads; empty in others. What
  /// it says is handed back only as long as those threads are as thick as then.
  std::vector<double> warpDiameters_mm, weftDiameters_mm;
  std::vector<double> warpSpacing, weftSpacing;  ///< as Fabric has them
  /// In the order of the fabric's yarns. A yarn that still has that colour goes out under the number it came with.
  std::vector<WifYarn> yarns;
  WifRest rest;
  UnknownKeys unknown;
  friend bool operator==(const WifOrigin&, const WifOrigin&);
};

template <>
struct FieldTable<WifYarn> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&WifYarn::colour, {label, "colour", "Colour", "", 0, kMaxWifNumber, "Number in the file; 0 for none."}},
      Field{&WifYarn::absorption_per_mm,
            {label, "absorption_per_mm", "Absorption", "/mm", 0, 10000, "What its fibre was given for that."}});
};

template <>
struct FieldTable<WifOrigin> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&WifOrigin::program, {label, "program", "Program", "", 0, 0, "What wrote the WIF draft."}},
      Field{&WifOrigin::ends, {label, "ends", "Ends", "", 0, Weave::kMaxSide, "Warp threads of the file's draft."}},
      Field{&WifOrigin::picks, {label, "picks", "Picks", "", 0, Weave::kMaxSide, "Weft threads of the file's draft."}},
      Field{&WifOrigin::ends_per_cm, {label, "ends_per_cm", "Ends", "/cm", 0, 500, "Sett of the fabric it became."}},
      Field{&WifOrigin::picks_per_cm, {label, "picks_per_cm", "Picks", "/cm", 0, 500, "Sett of the fabric it became."}},
      Field{&WifOrigin::warpDiameter_mm,
            {label, "warp_diameter_mm", "Warp", "mm", 0, 1e4, "Mean diameter of the yarns it was given."}},
      Field{&WifOrigin::weftDiameter_mm,
            {label, "weft_diameter_mm", "Weft", "mm", 0, 1e4, "Mean diameter of the yarns it was given."}});
};

}  // namespace loomlight
