#pragma once

#include <algorithm>
#include <cassert>
#include <span>

#include "core/base/columns.h"
#include "render/media/medium.h"
#include "render/optics/bcsdf.h"
#include "render/optics/fibre_frame.h"

namespace loomlight {

/// Fibres of one material, as up to eight paths have come to them, side by side: what FibreBcsdf takes. Lanes that are
/// not in use are like the last that is.
struct EventLanes {
  using Lanes = FibreBcsdf::Lanes;
  static constexpr size_t kMost = static_cast<size_t>(kLanes<Lanes>);

  FibreFrameOf<Vec3Of<Lanes>> frame;
  Vec3Of<Lanes> wo;  ///< in the fibre's frame
  Lanes offset;      ///< h

  /// `met(i)` is the i-th of so many collisions.
  template <class Met>
  EventLanes(size_t count, Met&& met)
      : frame(columns(count, [&](size_t i) { return met(i).tangent; })),
        wo(frame.toLocal(-columns(count, [&](size_t i) { return met(i).incoming; }))),
        offset(column(count, [&](size_t i) { return met(i).offset; })) {}

  template <class Number>
  static Lanes column(size_t count, Number&& number) {
    assert(0 < count && count <= kMost);
    return columnOf<Lanes>(count, number);
  }
  template <class Vector>
  static Vec3Of<Lanes> columns(size_t count, Vector&& vector) {
    assert(0 < count && count <= kMost);
    return columnsOf<Lanes>(count, vector);
  }
};

}  // namespace loomlight
