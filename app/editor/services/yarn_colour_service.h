#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "app/live/worker.h"
#include "core/fabric/model/fabric.h"
#include "render/transport/reached_colours.h"

namespace loomlight {

/// The one place that knows which colour the cloth reaches where each of its yarns lies on top, under its own lamps
/// (reachedColours()): for chips, bars of colour, drafts and names. They are found on a worker; no call waits.
class YarnColourService {
 public:
  explicit YarnColourService(std::function<void()> wake);

  /// At the end of a frame: asks for the colours of this fabric and of its colourways.
  void follow(const std::shared_ptr<const Fabric>& fabric);
  /// Linear, one for each yarn of a fabric that is the one followed or near it. Until it is known what its cloth
  /// reaches, a yarn keeps the colour that it had, or that a yarn like it has; one that nothing is known of has that of
  /// its dye in a thick mass.
  std::vector<Rgb> of(const Fabric& fabric) const { return shown(fabric, &Known::now); }
  /// Those by which its yarns are called (coloursForNames()).
  std::vector<Rgb> forNames(const Fabric& fabric) const { return shown(fabric, &Known::named); }
  /// The same in one of the fabric's colourways.
  std::vector<Rgb> ofColourway(const Fabric& fabric, size_t colourway) const;
  /// Whether what of() says is of this very fabric.
  bool knows(const Fabric& fabric) const;
  /// What is known so far says nothing of the next cloth.
  void forget() {
    worker_.forget();
    asked_.reset();
  }

 private:
  struct Known {
    std::shared_ptr<const Fabric> fabric;
    std::vector<Rgb> now, named;
    std::vector<std::vector<Rgb>> colourways;
  };
  struct Traced {
    std::shared_ptr<const Fabric> fabric;
    std::vector<PathLengthTally> paths;
  };
  using Request = std::shared_ptr<const Fabric>;
  using Answer = std::shared_ptr<const Known>;
  using Finding = Worker<Request, Answer>;
  std::optional<Answer> find(Request fabric, Finding::Job& job);
  const std::vector<PathLengthTally>* pathsFor(Request& fabric, Finding::Job& job);
  std::vector<Rgb> shown(const Fabric& fabric, std::vector<Rgb> Known::* which) const;
  Answer known() const;  ///< null while nothing is known of this cloth

  // The thread's own:
  std::deque<Traced> traced_;           ///< the constructions that were looked at last, the newest first
  std::shared_ptr<const Scene> scene_;  ///< the last, whose parts the next may share

  Request asked_;
  Finding worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
