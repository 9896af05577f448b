#pragma once

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
      : frame(columnsOf<Lanes>(count, [&](size_t i) { return met(i).tangent; })),
        wo(frame.toLocal(-columnsOf<Lanes>(count, [&](size_t i) { return met(i).incoming; }))),
        offset(columnOf<Lanes>(count, [&](size_t i) { return met(i).offset; })) {}
};

}  // namespace loomlight
