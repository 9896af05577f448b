#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/fabric/model/fabric.h"
#include "render/transport/path_length_tally.h"
#include "ui/dialogs/colour_difference_dialog.h"

namespace loomlight {

/// Traces light through the cloth where two of its yarns lie on top, and judges one by the other under the lamps of a
/// light booth, as `loomlight colour` does. On a worker; no call waits.
class ColourDifferenceService {
 public:
  explicit ColourDifferenceService(std::function<void()> wake);

  /// In every frame in which it is looked at: asks for what is not known.
  void follow(const std::shared_ptr<const Fabric>& fabric, const ColourPair& pair);
  /// Into the model: what is known of the pair that was asked for, or why nothing is. The yarns have to be named.
  void tell(ColourDifferenceModel& model) const;

 private:
  struct Request {
    std::shared_ptr<const Fabric> fabric;
    ColourPair pair;
    friend bool operator==(const Request&, const Request&) = default;
  };
  struct Answer {
    Request of;
    std::vector<ColourDifferenceModel::UnderLamp> lamps;
    double error = 0;
    std::optional<int> hidden;  ///< a yarn that the face does not show
    std::string problem;
  };
  using Judging = Worker<Request, Answer>;
  std::optional<Answer> judge(const Request& asked, Judging::Job& job);
  const PathLengthTally* pathsTo(int yarn, const Fabric& fabric, Judging::Job& job);

  // The thread's own:
  std::shared_ptr<const Fabric> traced_;  ///< through whose cloth the paths are
  std::map<int, PathLengthTally> paths_;  ///< to its yarns

  Request asked_;
  Judging worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
