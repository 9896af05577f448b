#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/spectrum.h"
#include "ui/inspector/colour_book.h"
#include "ui/widgets/fields.h"

namespace loomlight {

/// What is known of the colour that the cloth shows where a fibre lies on top, or all of its face.
struct ClothColourModel {
  enum class State { measuring, known, hidden, failed };
  State state = State::measuring;
  Rgb colour{0};          ///< linear; of the cloth as it is, where it is known
  double difference = 0;  ///< CIEDE2000 from what is wanted, where something is
  bool tooLight = false, tooDark = false;
};

/// A colour that the cloth is to have, as it was picked or as it was measured.
struct WantedColour {
  Rgb colour{0};                     ///< linear; in daylight
  std::optional<Spectrum> measured;  ///< its reflectance in bands, 1 is a perfect diffuser
  std::string name;                  ///< of what was measured
};

/// Stands for all fibres of a fabric, which are dyed alike when the cloth is dyed after it was woven.
inline constexpr int kPiece = -1;

/// Which colours were asked for, and how.
struct ClothColourView {
  bool piece = false;                      ///< the piece is dyed, not the fibre looked at
  std::map<int, WantedColour> wanted;      ///< by fibre; kPiece: of the piece
  uint64_t wish = 0;                       ///< counts up when a colour is asked for
  std::string code;                        ///< as it stands in its field
  std::optional<std::string> entered;      ///< a code to be understood by whoever knows how
  std::string refusal;                     ///< why the last one was not
  std::shared_ptr<const ColourBook> book;  ///< null while there is none
  std::string search;                      ///< in the book

  /// What takes the dye: the fibre looked at, of so many, or kPiece.
  int dyed(int fibre, size_t fibres) const { return piece && fibres > 1 ? kPiece : fibre; }
  /// `what` is to have this colour: a fibre, or kPiece.
  void want(int what, WantedColour colour) {
    wanted[what] = std::move(colour);
    ++wish;
  }
};

/// The colour that the designer wants the cloth to have, beside the one it has. `fibre`: that is looked at, of
/// `fibres`.
void clothColourRows(Ui& ui, int fibre, size_t fibres, const ClothColourModel& model, ClothColourView& view);

}  // namespace loomlight
