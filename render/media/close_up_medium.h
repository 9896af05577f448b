#pragma once

#include <memory>

#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"

namespace loomlight {

/// With what chance a path goes among the fibres where its eye's ray is so wide as it comes to the cloth: 0 as far as
/// two fibres lie beside each other in a pixel, 1 from where a fibre is three quarters of one. 0 everywhere where there
/// are no fibres (TraceData::fibres), or where the volume is another's than LoomlightMedium's.
float closeUpChance(const TraceData& cloth, float width_mm);

/// The cloth as LoomlightMedium has it from afar, and fibre by fibre for an eye so near that it could tell them apart:
/// voxels would blur them. The nearer, the more of a pixel's paths go among the fibres, so that zooming in has no seam;
/// a path keeps to one of both, each of which is true to itself. Far away every picture is the volume's to the bit.
///
/// To meet the first fibre itself and then go on in the volume costs less, and is wrong by some 10 %: the surface of a
/// yarn lies in the middle of the voxels that it is blurred over, where half of them shades what leaves it.
class CloseUpMedium final : public Medium {
 public:
  explicit CloseUpMedium(std::shared_ptr<const TraceData> cloth);

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;
  const Medium& fromAfar() const override { return volume_; }

 private:
  LoomlightMedium volume_;
  std::unique_ptr<const FibreMedium> fibres_;  ///< null where TraceData::fibres is
};

}  // namespace loomlight
