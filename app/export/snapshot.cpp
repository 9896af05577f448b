#include "app/export/snapshot.h"

#include "app/export/picture.h"
#include "app/export/whole_picture.h"
#include "core/base/text.h"
#include "render/transport/make_medium.h"

namespace loomlight {

bool writeSnapshot(const std::shared_ptr<const Fabric>& fabric, const std::string& file, const Tone& tone,
                   const SnapshotPrint& print, const Task& task) {
  checkPictureName(file);
  const auto picture = renderWhole(fabric, defaultMemoryLimit_bytes(), task);
  if (!picture) return false;
  const Film& film = picture->film;
  if (lowerExtension(file) == ".png")
    writePng(file, print.finish ? print.finish(toPixels(film, tone)) : toPixels(film, tone), pngTexts(*fabric),
             print.dpi);
  else
    writePicture(file, film, *fabric, tone, print.dpi);
  return true;
}

}  // namespace loomlight
