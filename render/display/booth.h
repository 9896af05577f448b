#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fabric/model/booth_lamps.h"
#include "render/display/frame.h"
#include "render/display/recolour.h"
#include "render/transport/path_records.h"

namespace loomlight {

// A light booth beside itself: a picture is divided into quarters, and each shows its middle under another lamp. All
// four have the same threads at the same scale, so what differs between them is the lamp's doing; a strip of the whole
// for each lamp would set threads side by side that differ anyway.

/// How the light of a pixel changes under each of kBoothLamps, beside what is shown of it.
using LampChanges = std::array<LightChange, kBoothLamps.size()>;

/// The part of a picture that every quarter shows, or all but a pixel of it: half of each side, in the middle.
PixelRect boothPiece(int width, int height);

/// What a pixel of a divided picture shows.
struct BoothPixel {
  size_t lamp = 0;   ///< of kBoothLamps, from the top left, row by row
  int x = 0, y = 0;  ///< of the whole picture
};
BoothPixel boothPixel(int x, int y, int width, int height);

/// The changes of a picture's middle.
struct BoothChanges {
  int width = 0, height = 0;        ///< pixels of the picture; 0: nothing is known
  std::vector<LampChanges> pixels;  ///< of its boothPiece(), row by row

  /// At a pixel of a picture of the same view, of any size.
  const LampChanges& at(int x, int y, int ofWidth, int ofHeight) const;
};

/// From the paths on record of a film: how their light under a lamp differs from that as it is shown, of the pixels
/// around on the same yarn, so that it has little noise (changeOfLight() in recolour.h). `lamps`: the colours of the
/// cloth under each of kBoothLamps; `shown`: those that it is shown in, null where these are the ones that it was
/// traced in.
BoothChanges boothChanges(const Film& film, const PathRecords& records, const Recolouring* shown,
                          std::span<const Recolouring, kBoothLamps.size()> lamps, int threads);

/// What a frame shows, divided. The changes are of the same view.
std::vector<glm::vec4> boothPicture(const Frame& frame, const BoothChanges& changes);
/// The crossings of a frame, divided likewise.
std::vector<Film::Hit> boothHits(const Frame& frame);

}  // namespace loomlight
