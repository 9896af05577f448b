#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/fabric/yarn/derived.h"
#include "ui/inspector/yarn_section.h"
#include "ui/viewport/camera_moves.h"

namespace loomlight {

/// What is worth knowing about a fabric beside its picture.
struct FabricStats {
  std::shared_ptr<const Fabric> fabric;  ///< of which it speaks
  int yarn = 0;                          ///< whose section it is
  YarnSection section;
  Floats floats;
  CoverFactors cover;
  Binding binding;
  std::vector<std::string> warnings;
  std::optional<MeshExtent> mesh;  ///< of a mesh drape that could be read
};

/// The section of one yarn of the fabric, as it lies in plain cloth of this sett.
YarnSection yarnSection(const Fabric& fabric, int yarn);

/// Computes insights on a thread of its own, of the newest request: a float search in a large jacquard, or the fibres
/// of a coarse yarn, take longer than a frame.
class FabricStatsWorker {
 public:
  /// What is worth knowing of a fabric, but for its mesh. May throw.
  using Compute = std::function<FabricStats(const Fabric&, int yarn)>;
  explicit FabricStatsWorker(std::function<void()> wake, Compute compute = insightOf);

  void request(std::shared_ptr<const Fabric> fabric, int yarn);
  std::shared_ptr<const FabricStats> newest() const;  ///< null before the first
  std::string problem() const;                        ///< why there is none of the newest request; else empty

 private:
  struct Request {
    std::shared_ptr<const Fabric> fabric;
    int yarn = 0;
  };
  struct Result {
    std::shared_ptr<const FabricStats> stats;  ///< the last that could be computed
    std::string problem;
  };
  static FabricStats insightOf(const Fabric& fabric, int yarn);
  Result tell(const Request& request);
  std::optional<MeshExtent> extentOf(const Drape& drape);

  // The thread's own:
  Compute compute_;
  std::shared_ptr<const FabricStats> last_;
  Drape measured_;  ///< the mesh that was read last, and its extent
  std::optional<MeshExtent> measuredExtent_;

  Worker<Request, Result> worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
