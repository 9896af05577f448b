#pragma once

#include <memory>

#include "render/bvdf/bvdf_set.h"
#include "render/media/loomlight_medium.h"

namespace loomlight {

/// The volume as the report has it, to the letter, for comparison: components are chosen by density alone (Eq. 12),
/// their tangents are not weighted, and direct light at the first fibre of a path is seen with the probability
/// (1 - p(wi, wo)) of the BVDF within the cell around it, times the volume's transmittance from the cell's far side on
/// (section 8.2). All else is the plain volume. It does not keep the furnace: light that comes straight is counted by
/// one law, light that goes on by another.
class ReportMedium final : public Medium {
 public:
  ReportMedium(std::shared_ptr<const TraceData> cloth, std::shared_ptr<const BvdfSet> bvdf);

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;
  bool seesDirectLightApart() const override { return true; }

 private:
  class Batch;

  std::shared_ptr<const TraceData> cloth_;
  LoomlightMedium volume_;
  std::shared_ptr<const BvdfSet> bvdf_;
};

}  // namespace loomlight
