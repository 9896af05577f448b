#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/live/mailbox.h"
#include "core/fabric/yarn/derived.h"
#include "ui/inspector/yarn_section.h"
#include "ui/viewport/camera_moves.h"

namespace loomlight {

/// What is worth knowing about a fabric beside its picture.
struct Insight {
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

/// Computes insights on a thread of its own, newest request first: a float search in a large jacquard, or the fibres of
/// a coarse yarn, take longer than a frame.
class InsightWorker {
 public:
  explicit InsightWorker(std::function<void()> wake);
  void request(std::shared_ptr<const Fabric> fabric, int yarn);
  std::shared_ptr<const Insight> newest() const;  ///< null before the first

 private:
  struct Request {
    std::shared_ptr<const Fabric> fabric;
    int yarn = 0;
  };
  void loop(std::stop_token stop);
  std::optional<MeshExtent> extentOf(const Drape& drape);

  std::function<void()> wake_;
  Mailbox<Request> requests_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Insight> newest_;
  Drape measured_;  // the loop's alone: the mesh it has read last, and its extent
  std::optional<MeshExtent> measuredExtent_;
  std::jthread thread_;  // last: it stops before what it uses is gone
};

}  // namespace loomlight
