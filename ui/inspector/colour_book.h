#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/spectrum.h"
#include "core/fabric/palette/palette.h"
#include "ui/widgets/fields.h"

namespace loomlight {

struct BookColour {
  std::string name;                  ///< as it is bought; not empty
  Rgb linear{0};                     ///< in daylight
  std::optional<Spectrum> measured;  ///< its reflectance in bands, 1 is a perfect diffuser
  WhiteLab lab;                      ///< in daylight, D65; for 10 degrees where that is known
};

/// Colours to choose from, of a file of the designer's own.
struct ColourBook {
  std::string name;
  std::vector<BookColour> colours;  ///< at least one

  /// The one whose name is this, in capitals or not; null where there is none.
  const BookColour* named(std::string_view name) const;
};

/// As many as a list holds.
inline constexpr size_t kMostBooks = 12;

/// The colour books that were used, and what is asked of them in a frame.
struct BookShelf {
  std::vector<std::string> files;     ///< the last used first
  int open = -1;                      ///< whose colours are shown; -1: of none
  std::optional<int> wanted, remove;  ///< to be opened (-1: none), or forgotten

  /// `file` becomes the one that is open, and the first; the last one goes when there are too many.
  void take(const std::string& file);
  void forget(int index);
};

/// Which book is open: a list of those that were used, with a way to forget the open one.
void bookRow(Ui& ui, BookShelf& shelf);

/// A field to search by name, and below it the colours as chips; `search` is what stands in the field. The colour that
/// was clicked.
const BookColour* colourBookRows(Ui& ui, const ColourBook& book, std::string& search);

}  // namespace loomlight
