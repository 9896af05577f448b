#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// Switches the denoised preview on and off; so wide, as high as a field.
void denoiseButton(Ui& ui, bool& on, float width);

}  // namespace loomlight
