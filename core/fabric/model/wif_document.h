#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/model/weave.h"

namespace loomlight {

/// The colours of a draft, by the numbers its threads name them with, from 1; some numbers may have none.
struct WifPalette {
  int low = 0;  ///< a channel's value for no light, and for full light: 0 to 255, 0 to 999, 0 to 65535...
  int high = 255;
  std::map<int, glm::ivec3> colours;  ///< red, green, blue, each from low to high

  Rgb srgb(const glm::ivec3& colour) const;   ///< 0..1
  glm::ivec3 nearest(const Rgb& srgb) const;  ///< of a colour in 0..1
  friend bool operator==(const WifPalette&, const WifPalette&) = default;
};

enum class WifUnit { decipoints, inches, centimeters };
/// Decipoints are tenths of a printer's point, 1/720 inch.
double millimetres(double value, WifUnit unit);

/// How far the threads of one system lie apart, and how thick they are, as the file says it: often no more than the
/// defaults of the program that wrote it.
struct WifSizes {
  WifUnit unit = WifUnit::centimeters;
  std::optional<double> spacing;    ///< of every thread that has none of its own: the room it takes, > 0
  std::optional<double> thickness;  ///< likewise, of the yarn
  std::map<int, double> spacings;   ///< of single threads, by number from 1
  std::map<int, double> thicknesses;

  /// Mean over `threads` threads, mm; nothing where the file does not give it for all of them.
  std::optional<double> meanSpacing_mm(int threads) const;
  std::optional<double> spacing_mm(int thread) const;  ///< of one thread, from 1
  std::optional<double> thickness_mm(int thread) const;
  /// Whether it says anything of single threads.
  bool hasSingle() const { return !spacings.empty() || !thicknesses.empty(); }
  friend bool operator==(const WifSizes&, const WifSizes&) = default;
};

/// Lines of one section, without its heading.
struct WifLines {
  std::string section;
  std::vector<std::string> lines;
  friend bool operator==(const WifLines&, const WifLines&) = default;
};

/// What a weaving file says beyond what a fabric holds. The fabric carries it along, through its own files too, and it
/// is handed back when the fabric is written as a weaving file again.
struct WifRest {
  WifPalette palette;  ///< with the colours that no thread uses
  WifSizes warp, weft;
  /// Private sections line by line; of WIF's own sections the keys that mean nothing here (authors, symbols, obsolete
  /// ones) as key=value; and, under "WIF", all comments.
  std::vector<WifLines> kept;
  friend bool operator==(const WifRest&, const WifRest&) = default;
};

/// How far the lines of a draft go where the file states more threads than they name; 0 where they name the last.
struct WifNamed {
  int ends = 0, picks = 0;
  friend bool operator==(const WifNamed&, const WifNamed&) = default;
};

/// A weaving file: WIF 1.1, the interchange format of weaving programs. Threads, shafts, treadles and colours count
/// from 1, 0 is none.
struct WifDocument {
  std::string title;
  std::vector<std::string> notes;  ///< lines
  std::string program;             ///< that wrote the file, with its version
  /// Threading for every end; a treadling or a liftplan, or both, for every pick. Sorted, without repetitions and 0.
  Draft draft;
  std::vector<int> warpColours;  ///< of each end, a number of the palette or 0
  std::vector<int> weftColours;
  WifNamed named;
  WifRest rest;
  friend bool operator==(const WifDocument&, const WifDocument&) = default;

  int ends() const { return static_cast<int>(warpColours.size()); }
  int picks() const { return static_cast<int>(weftColours.size()); }
};

/// Largest number of a colour or of a note that is read.
inline constexpr int kMaxWifNumber = 65536;
/// The number for one more: behind all that are taken, from 1, or where those go up to the last, the largest that is
/// free. Nothing where none is.
std::optional<int> freeWifNumber(const std::set<int>& taken);

}  // namespace loomlight
