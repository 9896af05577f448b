#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/spectrum.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/yarn/cloth_part.h"
#include "ui/inspector/colour_book.h"
#include "ui/widgets/fields.h"

namespace loomlight {

/// What is known of the colour that the cloth shows where a part of it lies on top.
struct ClothColourModel {
  enum class State { measuring, known, hidden, failed };
  State state = State::measuring;
  Rgb colour{0};           ///< linear; of the cloth, where it is known
  bool isCurrent = false;  ///< it is the colour of the cloth as it is now, not as it was before an edit
  double difference = 0;   ///< CIEDE2000 from what is wanted, where something is: as `present` has it
  double error = 0;        ///< standard error of the colour, CIEDE2000
  bool tooLight = false, tooDark = false;

  /// Beside what is wanted, under one lamp.
  struct Judged {
    StandardIlluminant lamp = StandardIlluminant::d65;
    double cmc = 0, ciede2000 = 0;  ///< CMC(2:1) is what passes or fails
    double metamerism = 0;          ///< special index, for the change from daylight to this lamp
  };
  std::optional<Judged> present;  ///< under the lamp of the cloth; a picked colour has no spectrum, and only daylight
  std::optional<Judged> worst;    ///< the worst of the booth's other lamps; none of a picked colour
};

inline constexpr double kTolerance_cmc[] = {0.05, 20};  ///< from, to

/// A colour that the cloth is to have, as it was picked or as it was measured.
struct WantedColour {
  Rgb colour{0};                     ///< linear; in daylight
  std::optional<Spectrum> measured;  ///< its reflectance in bands, 1 is a perfect diffuser
  std::string name;                  ///< of what was measured
};

/// Which colours were asked for, and how.
struct ClothColourView {
  ClothPart::Kind dyes = ClothPart::Kind::fibre;  ///< what takes the dye
  std::map<ClothPart, WantedColour> wanted;
  uint64_t wish = 0;                       ///< counts up when a colour is asked for
  std::string code;                        ///< as it stands in its field
  std::optional<std::string> entered;      ///< a code to be understood by whoever knows how
  std::string refusal;                     ///< why the last one was not
  std::shared_ptr<const ColourBook> book;  ///< null while there is none
  std::string search;                      ///< in the book
  double tolerance_cmc = 1;                ///< the largest CMC(2:1) that passes
  BookShelf books;

  /// What takes the dye where this yarn and this fibre are looked at.
  ClothPart dyed(int yarn, int fibre) const {
    return dyes == ClothPart::Kind::piece  ? wholePiece()
           : dyes == ClothPart::Kind::yarn ? partOfYarn(yarn)
                                           : partOfFibre(fibre);
  }
  /// The part is to have this colour.
  void want(const ClothPart& part, WantedColour colour) {
    wanted[part] = std::move(colour);
    refusal.clear();
    ++wish;
  }
  /// The colour that the part has is the one that is wanted from now on.
  void takeNearest(const ClothPart& part, const Rgb& reached) {
    wanted[part] = {reached, {}, ""};
    code.clear();
  }
};

/// The colour that the designer wants the cloth to have, beside the one it has: rows of a fixed height, whatever is
/// known. `part`: that takes the dye.
void clothColourRows(Ui& ui, const ClothPart& part, const ClothColourModel& model, ClothColourView& view);

}  // namespace loomlight
