#pragma once

#include <memory>

#include "render/media/loomlight_medium.h"

namespace loomlight {

/// The cloth as a statistical volume and nothing more (Estimator::none): LoomlightMedium without all that it knows of
/// fibres.
class VolumeMedium final : public Medium {
 public:
  VolumeMedium(std::shared_ptr<const TraceData> cloth, EventLaw law)
      : volume_(std::move(cloth), LoomlightMedium::plain(law)) {}
  /// With the event law that the scene asks for.
  explicit VolumeMedium(const std::shared_ptr<const TraceData>& cloth) : VolumeMedium(cloth, cloth->eventLaw) {}

  std::unique_ptr<MediumBatch> batch(size_t paths) const override { return volume_.batch(paths); }

 private:
  LoomlightMedium volume_;
};

}  // namespace loomlight
