#pragma once

#include <cstdint>
#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// One line of figures. Each has its place, so that a number that changes moves no other.
struct StatusModel {
  double arealMass_g_m2 = 0;
  double coverPercent = 0;
  int unboundYarns = 0;  ///< that float without end
  int longestFloat = 0;  ///< crossings, of those that are bound
  double longestFloat_mm = 0;
  int64_t longFloats = 0;   ///< how many are longer than
  double longFloat_mm = 0;  ///< the limit that is set for them
  double thickness_mm = 0;
  std::string warning;  ///< the most important one about the cloth; empty when all is well
  int moreWarnings = 0;
  /// The warning is of what is not safe: figures give way to it where there is no room for both.
  bool isUrgent = false;
  int samples = 0;
  double seconds = 0;
  std::string work;        ///< what the workers do: "refining", "building 40 %", "converged"
  std::string background;  ///< what is done beside that: "visibility 40 %"; empty: nothing
  std::string lamp;        ///< whose spectrum white light has, where it is not daylight's; empty: it is
  bool figuresKnown = false;
};

void statusBar(Ui& ui, const StatusModel& model);

}  // namespace loomlight
