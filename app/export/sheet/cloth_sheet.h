#pragma once

#include <string>
#include <vector>

#include "app/export/sheet/draft_sheet.h"
#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/model/yarn_count.h"
#include "render/transport/make_medium.h"
#include "render/transport/standard_match.h"

namespace loomlight {

struct ClothSheetOptions {
  double width_cm = 150;                  ///< of the finished cloth: what yarns are reckoned for, and the ends
  CountSystem counts = CountSystem::tex;  ///< in which counts are written
  DraftCorner corner;                     ///< of the draft
  int samplesPerPixel = 16;               ///< of the pictures
  std::vector<ClothStandard> standards;   ///< that the cloth is judged by
  double tolerance_cmc = 1;               ///< the largest CMC(2:1) that passes
  double memoryLimit_bytes = defaultMemoryLimit_bytes();  ///< of explicit fibres
};

/// The A4 page that a mill can weave from, as a .pdf, or a .png to be looked at: the cloth at 1 : 1 in a light booth,
/// its draft or as much of the first repeat as is legible, setts from the reed to the wash, reed, selvedges and mass,
/// the orders of colours as tables, the yarns with count, twist, fibre and kg for 100 m, the colour of the face under
/// two lamps, alone and beside its standards, notes, and the colourways in small. What does not fit goes on a second
/// page. False, and nothing is written, when stopped. Throws InputError.
bool writeClothSheet(const std::string& file, const Fabric& fabric, const ClothSheetOptions& options, const Task& task);

/// All colourways side by side at 1 : 1 in a light booth, and the cloth as it is now, likewise.
bool writeColourwaySheet(const std::string& file, const Fabric& fabric, const ClothSheetOptions& options,
                         const Task& task);

}  // namespace loomlight
