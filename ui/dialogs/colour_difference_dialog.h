#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A yarn of the cloth in one of its colourways.
struct ColouredYarn {
  int yarn = 0;
  int colourway = 0;  ///< 0: as the cloth is now, then the fabric's colourways from 1
  friend bool operator==(const ColouredYarn&, const ColouredYarn&) = default;
};

/// What is set beside each other.
struct ColourPair {
  ColouredYarn standard, sample;
  friend bool operator==(const ColourPair&, const ColourPair&) = default;
};

/// How far two colours of a cloth are apart, for the observer of 10 degrees.
struct ColourDifferenceModel {
  struct Side {
    double L = 0, a = 0, b = 0;
    ImVec4 colour;  ///< for the display
  };
  struct UnderLamp {
    StandardIlluminant lamp = StandardIlluminant::d65;
    Side standard, sample;
    double ciede2000 = 0, cmc = 0;  ///< CMC(2:1) is what passes or fails
    double metamerism = 0;          ///< special index, for the change from daylight to this lamp
  };
  std::vector<std::string> yarns, colourways;  ///< what can be chosen: their names
  std::vector<UnderLamp> lamps;                ///< of the booth, daylight first; empty while nothing is known
  double error = 0;                            ///< standard error of a colour, CIEDE2000
  std::string remark;                          ///< why nothing is known
};

/// Two yarns of the cloth, in the same colourway or in two, under the lamps of a light booth: as dyers report it.
class ColourDifferenceDialog {
 public:
  /// The first two yarns, unless others were chosen before.
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// What is compared, within what the fabric has; to be asked before each draw().
  const ColourPair& pairOf(const Fabric& fabric);
  /// `tolerance_cmc` may be edited.
  void draw(Ui& ui, const ColourDifferenceModel& model, double& tolerance_cmc);

 private:
  bool open_ = false, opening_ = false;
  ColourPair pair_{{0, 0}, {1, 0}};
};

}  // namespace loomlight
