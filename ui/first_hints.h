#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// Three things to try for somebody who is here for the first time. Each is ticked off once it has been done.
struct FirstHints {
  bool wanted = false;
  bool drew = false;    ///< in the draft
  bool turned = false;  ///< the cloth
  bool set = false;     ///< a value of yarn, fibre or cloth
};

/// A quiet card in the lower right corner of an area, while it is wanted: until all is done, or it is sent away.
void firstHints(Ui& ui, ImVec2 min, ImVec2 size, FirstHints& hints);

}  // namespace loomlight
