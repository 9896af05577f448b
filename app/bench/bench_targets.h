#pragma once

#include <string>
#include <vector>

namespace loomlight {

class ReportPage;

/// A figure that the program must reach, beside what was reached before it. Ratios and rates are to be large,
/// differences in percent and in FLIP, counts, times and steps back small.
struct Target {
  enum class Kind { ratio, perSecond, percent, count, milliseconds, flip, stepBack };
  std::string what;
  std::string report, prototype;  ///< as they are written; empty where nothing is known
  Kind kind = Kind::percent;
  double atLeast = 0, aim = 0;
  double ours = 0;           ///< NaN where it was not measured: reaches nothing
  double standardError = 0;  ///< of ours; 0: not known, or of no account

  /// A NaN reaches nothing.
  bool reaches(double goal) const {
    return kind == Kind::ratio || kind == Kind::perSecond ? ours >= goal : ours <= goal;
  }
};

/// "57.3 : 1"; "-" where there is none.
std::string ratioText(double ratio);

/// The last part of a page: every target, and whether it is met.
void addTargets(ReportPage& page, const std::string& csv, const std::vector<Target>& targets);

}  // namespace loomlight
