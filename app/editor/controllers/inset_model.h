#pragma once

#include <optional>

#include "app/live/live_renderer.h"
#include "ui/viewport/inset_overlay.h"

namespace loomlight {

/// What the inset says, and what it can do about what is in its way; all but the picture. `shown` may be null.
InsetModel insetModel(const InsetStatus& status, const InsetFrame* shown, bool difference, double limit_bytes,
                      const Drape& drape);

/// A smaller piece of the same proportions, whose fibres fit into the limit where this one's take `bytes`; nothing for
/// a mesh, or where no piece worth looking at would fit.
std::optional<Drape> fittingPiece(const Drape& drape, double bytes, double limit_bytes);

}  // namespace loomlight
