#pragma once

#include <functional>
#include <vector>

namespace loomlight {

/// Threads whose cells may be alike: of one geometry class, and as far from where an even sett would have them.
struct ThreadKind {
  int geometryClass = 0;
  float displaced_mm = 0;  ///< positive towards the next thread
  bool operator==(const ThreadKind&) const = default;
};

/// Of the ends or the picks of a cloth.
struct ThreadKinds {
  std::vector<ThreadKind> kinds;  ///< where the sett is even, kind i is geometry class i
  std::vector<int> sequence;      ///< kind of each thread, in their shortest repeat
  /// How much of the wanted displacements they have, 0..1: less than 1 where yarns would lie in one another,
  /// or beyond kMostDisplaced.
  double share = 1;

  double farthest_mm() const;  ///< that any is displaced
  bool operator==(const ThreadKinds&) const = default;
};

/// Most kinds of ends, and of picks: as many as a shape code tells apart (cell_codes.h).
inline constexpr int kMaxThreadKinds = 512;
/// Farthest that a thread may be displaced, in pitches: else its fibres could reach beyond the cells beside its own.
inline constexpr double kMostDisplaced = 0.3;

/// How close two threads of these geometry classes may come, mm between their axes.
using LeastDistance = std::function<double(int geometryClass, int next)>;

/// `classes`: of each thread, repeating. `spacing`: Fabric::warpSpacing or weftSpacing. Where the threads have no room
/// for it all are displaced less, in proportion. Of a cloth with more kinds than kMaxThreadKinds none is displaced.
ThreadKinds threadKinds(const std::vector<int>& classes, const std::vector<double>& spacing, double pitch_mm,
                        const LeastDistance& least_mm);

}  // namespace loomlight
