#pragma once

#include <memory>

#include "render/media/loomlight_medium.h"
#include "render/scene/fibre_bricks.h"

namespace loomlight {

/// Fibres where the eye looks, statistics where light wanders: the cloth as LoomlightMedium has it, but that an eye so
/// near that it could tell fibres apart meets the first one itself. The nearer, the more of a pixel's samples do, so
/// that zooming in has no seam; from afar none does, and every picture is the volume's to the bit.
class CloseUpMedium final : public Medium {
 public:
  explicit CloseUpMedium(std::shared_ptr<const TraceData> cloth);

  /// With what chance an eye meets the fibre itself where its ray is so wide: 0 as far as two fibres lie beside each
  /// other in a pixel, 1 from where a fibre is three quarters of one.
  float chanceAt(float width_mm) const;

  std::unique_ptr<MediumPath> path() const override { return volume_.path(); }
  std::unique_ptr<MediumBatch> batch(size_t paths) const override;

 private:
  LoomlightMedium volume_;
  float diameter_mm_;  ///< of the thinnest fibres
};

}  // namespace loomlight
