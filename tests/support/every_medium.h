#pragma once

#include <memory>
#include <ostream>
#include <vector>

#include "render/bvdf/bake/bvdf_baker.h"
#include "render/media/report_medium.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight::test {

/// One way in which light can be traced through a cloth: what settings can ask for, one of each kind.
struct MediumKind {
  const char* name;
  Method method = Method::volume;
  Estimator estimator = Estimator::none;
  EventLaw eventLaw = EventLaw::projected;
  FibreLayout layout = FibreLayout::packed;
  FibreExtent extent = FibreExtent::wholePiece;
  bool fromNear = false;  ///< an eye for whom a fibre is about as wide as a pixel: of its paths some go among fibres

  void askFor(Fabric& fabric) const {
    fabric.render.method = method;
    fabric.render.estimator = estimator;
    fabric.render.eventLaw = eventLaw;
    for (Yarn& yarn : fabric.yarns) yarn.layout = layout;
  }

  /// The medium of a scene whose fabric asks for it. The report's has the visibility that is expected before any is
  /// baked, which takes no time and leaves the user's cache alone.
  std::unique_ptr<const Medium> make(const Scene& scene, int threads = 0) const {
    constexpr double kLimit_bytes = 4e9;
    if (method == Method::volume && estimator == Estimator::report)
      return std::make_unique<const ReportMedium>(scene.cloth, expectedBvdf(scene, BvdfResolution{}));
    return makeMedium(scene, {kLimit_bytes, extent}, Task{{}, {}, threads});
  }

  friend std::ostream& operator<<(std::ostream& out, const MediumKind& kind) { return out << kind.name; }
};

inline constexpr MediumKind kPlain{.name = "plain"};
inline constexpr MediumKind kReportsLaw{.name = "reportsLaw", .eventLaw = EventLaw::report};
inline constexpr MediumKind kReport{.name = "report", .estimator = Estimator::report};
inline constexpr MediumKind kLoomlight{.name = "loomlight", .estimator = Estimator::loomlight};
inline constexpr MediumKind kLoomlightAtRandom{
    .name = "loomlightAtRandom", .estimator = Estimator::loomlight, .layout = FibreLayout::random};
inline constexpr MediumKind kCloseUp{.name = "closeUp", .estimator = Estimator::loomlight, .fromNear = true};
inline constexpr MediumKind kFibres{.name = "fibres", .method = Method::fibres};
inline constexpr MediumKind kFibresAtRandom{
    .name = "fibresAtRandom", .method = Method::fibres, .layout = FibreLayout::random};
inline constexpr MediumKind kFibresOfOneRepeat{
    .name = "fibresOfOneRepeat", .method = Method::fibres, .extent = FibreExtent::oneRepeat};

inline constexpr MediumKind kFibresInBricks{
    .name = "fibresInBricks", .method = Method::fibres, .extent = FibreExtent::bricks};

}  // namespace loomlight::test
