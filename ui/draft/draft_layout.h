#pragma once

#include "ui/draft/draft_view.h"

namespace loomlight {

/// Where the parts of a draft are: threading above the drawdown, treadling (or liftplan) at its right, the tie-up in
/// the corner between them; shaft 1 and treadle 1 lie next to the cloth. Bars show the yarn of each end and pick.
struct DraftLayout {
  Box cloth, warpBar, weftBar, threading, tieUp, treadling;
  Box endRuler, pickRuler;  ///< empty without rulers
  float lift = 0;           ///< pixels of a shaft and of a treadle
};

/// `shafts`, `columns`: rows above and columns beside the drawdown; 0 for a jacquard. All of them are seen, however
/// many: they get narrower, and leave the drawdown most of the room.
DraftLayout layOutDraft(ImVec2 corner, ImVec2 size, int shafts, int columns, bool rulers, float scale);

}  // namespace loomlight
