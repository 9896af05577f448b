#pragma once

#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/yarn/discs.h"

namespace loomlight {

/// How fibres stray from the helix that twist would lay them on: harmonics of their own, after they have been parted.
struct FibreDisorder {
  double slope = 0;         ///< RMS, along either axis of the section; 0: none
  double pattern_mm = 0;    ///< length of yarn after which their ways repeat
  double plyRadius_mm = 0;  ///< waves are two to nine of these long, so that they stray by about a tenth of it
};

/// After what the ways of a ply's fibres repeat: a whole number of migrations, and of turns of the ply.
struct FibrePattern {
  int migrations = 1;  ///< >= 1
  int turns = 0;       ///< signed, as the yarn's axis sees them
};

/// The fibres of a ply on their way between core and surface, as the section that turns with the ply shows them, at
/// equal stages of a pattern, over and over.
class Migration {
 public:
  static constexpr int kStages = 24;  ///< of one migration

  /// No migration: they stay in their places.
  explicit Migration(const DiscCentres& section);
  /// Each fibre goes from its place to 1 - `amount` of the way out to it and back, out of step with the others (Zhao et
  /// al. 2016, Eq. 3). Packed ones go round one another, in the pressed section that they turn in; unfinished when the
  /// task is stopped. Disorder comes last: as in spun yarn, fibres that stray do touch, and a few stand out as loops.
  Migration(const DiscCentres& section, FibreLayout layout, double amount, const HelicalFibres& fibres, uint64_t seed,
            const Task& task = oneThread(), const FibreDisorder& disorder = {}, const FibrePattern& pattern = {});

  int fibres() const { return fibres_; }
  bool moves() const { return stages_ > 1; }
  int stages() const { return stages_; }
  double reach_mm() const;  ///< of the fibres, from the ply's axis
  /// How fast they move, and how sharply they turn, at most: first and second derivative by the patterns made, mm.
  double slope_mm() const;
  double bend_mm() const;

  /// Where between stages: weights of four of them, the first of which is `first`. A cubic through the stages, so
  /// fibres have no kinks.
  struct Moment {
    int first = 0;
    float weights[4] = {0, 1, 0, 0};
  };
  Moment at(double patterns) const { return at(patterns, stages_); }
  static Moment at(double patterns, int stages);
  /// x up, y across, mm.
  glm::vec2 place(int fibre) const { return places_[static_cast<size_t>(fibre) * stride()]; }
  glm::vec2 place(int fibre, const Moment& moment) const {
    const glm::vec2* const p = &places_[static_cast<size_t>(fibre) * stride() + moment.first];
    return moment.weights[0] * p[0] + moment.weights[1] * p[1] + moment.weights[2] * p[2] + moment.weights[3] * p[3];
  }

 private:
  /// The last stage comes first, and the first two once more at the end: four in a row are there for any moment.
  size_t stride() const { return moves() ? static_cast<size_t>(stages_) + 3 : 1; }
  void keep(const std::vector<DiscCentres>& stages);
  /// The largest visit(four stages in a row).
  template <class Visit>
  double largest(const Visit& visit) const;

  int fibres_ = 0, stages_ = 1;
  std::vector<glm::vec2> places_;  ///< fibre by fibre
};

}  // namespace loomlight
