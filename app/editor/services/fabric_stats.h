#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/long_floats.h"
#include "render/scene/scene.h"
#include "ui/inspector/yarn_section.h"
#include "ui/viewport/camera_moves.h"

namespace loomlight {

/// What is worth knowing about a fabric beside its picture.
struct FabricStats {
  std::shared_ptr<const Fabric> fabric;  ///< of which it speaks
  int yarn = 0;                          ///< whose section it is
  std::optional<YarnSection> section;    ///< of the newest cloth that is built; none before the first
  Floats floats;
  LongFloats longFloats;
  Binding binding;
  std::vector<std::string> warnings;
  std::optional<MeshExtent> mesh;  ///< of a mesh drape that could be read
};

/// The section of one yarn of the fabric in its built cloth; of a yarn that the cloth does not use, as it would lie in
/// plain cloth of this sett.
YarnSection yarnSection(const ClothGeometry& cloth, const Fabric& fabric, int yarn);

/// Finds out what is worth knowing of the newest fabric on a thread of its own: a float search in a large jacquard
/// takes longer than a frame. The section is that of the very fibres that the cloth was built of, so it comes with
/// that.
class FabricStatsWorker {
 public:
  /// What is worth knowing of a fabric, but for its mesh, its long floats, what is warned of and the section. May
  /// throw.
  using Compute = std::function<FabricStats(const Fabric&)>;
  explicit FabricStatsWorker(std::function<void()> wake, Compute compute = statsOf);

  /// `built`: the cloth of this fabric, from whichever side and on whatever drape; null while there is none.
  /// `longFloat_mm`: beyond which floats are listed.
  void request(std::shared_ptr<const Fabric> fabric, int yarn, std::shared_ptr<const Scene> built,
               double longFloat_mm = kUsualFloatLimit_mm);
  std::shared_ptr<const FabricStats> newest() const;  ///< null before the first
  std::string problem() const;                        ///< why there is none of the newest request; else empty

 private:
  struct Request {
    std::shared_ptr<const Fabric> fabric;
    int yarn = 0;
    std::shared_ptr<const Scene> built;
    double longFloat_mm = kUsualFloatLimit_mm;
  };
  struct Result {
    std::shared_ptr<const FabricStats> stats;  ///< the last that could be computed
    std::string problem;
  };
  static FabricStats statsOf(const Fabric& fabric);
  Result tell(const Request& request);

  // The thread's own:
  Compute compute_;
  std::shared_ptr<const FabricStats> last_;

  Worker<Request, Result> worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
