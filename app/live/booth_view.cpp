#include "app/live/booth_view.h"

#include <array>

#include "render/display/recolour.h"

namespace loomlight {

void BoothView::follow(const Refinement& picture, int threads) {
  const Refinement::Paths paths = picture.paths();
  if (!paths.film) return;
  const bool isAsFine = paths.film->width() == changes_.width && paths.film->height() == changes_.height;
  if (!isAsFine || 2 * paths.records->bytes() >= 3 * bytes_) learn(picture, threads);
}

void BoothView::learn(const Refinement& picture, const Fabric& wanted, const Recolouring* shown, int threads) {
  const Refinement::Paths paths = picture.paths();
  if (!paths.film) return forget();
  std::array<Recolouring, kBoothLamps.size()> lamps;
  for (size_t i = 0; i < lamps.size(); ++i) {
    Fabric lit = wanted;
    lit.light = underLamp(wanted.light, kBoothLamps[i]);
    lamps[i] = recolouringTo(lit, picture.scene().fabric->light);
  }
  changes_ = boothChanges(*paths.film, *paths.records, shown, lamps, threads);
  bytes_ = paths.records->bytes();
}

std::vector<glm::vec4> BoothView::divided(const Frame& frame) const {
  return changes_.width > 0 ? boothPicture(frame, changes_) : std::vector<glm::vec4>();
}

}  // namespace loomlight
