#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// The lamps of a picture that is divided among those of the light booth: each quarter is labelled, and parted from the
/// others by the colour of the surround, as colours are judged. `min`, `max`: corners of the picture.
void boothOverlay(Ui& ui, ImVec2 min, ImVec2 max);

/// How far a point of the picture is from the middle of what is seen there: of the picture, or of its quarter.
ImVec2 fromMiddle(ImVec2 point, ImVec2 min, ImVec2 max, bool divided);

}  // namespace loomlight
