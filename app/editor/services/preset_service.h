#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/display/thumbnails.h"
#include "app/editor/presets/preset.h"
#include "app/editor/presets/preset_library.h"
#include "app/live/worker.h"

namespace loomlight {

/// What lies behind the browser of presets: a thread of its own reads and writes them, one file after the other, and
/// changes go between. What is asked for is done even where the program ends; only reading stops then.
class PresetService {
 public:
  /// `wake` is called from that thread when there is something to take().
  PresetService(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake);
  ~PresetService() { lookAway(); }

  /// What has been read by now, with pictures, which are rendered for as long as they are asked for. Reads on until
  /// lookAway().
  std::vector<PresetCard> cards(PresetKind kind, float scale);
  void lookAway() { ++wanted_; }
  // At the end of a frame, so that cards keep their places until then.
  void take();  ///< what has been read and changed
  void follow() { thumbnails_.follow(); }

  /// The fabric with that preset in it.
  Fabric used(size_t card, const Fabric& now, int yarn, int fibre) const;

  // Changes of what is kept; each can be taken back. What came of it is told by takeOutcome().
  void keep(PresetKind kind, const Fabric& now, int yarn, int fibre);
  void duplicate(size_t card);
  void rename(size_t card, const std::string& name);
  void remove(size_t card);
  void tag(size_t card, const std::string& tags);
  void undo();

  struct Outcome {
    std::string kept;     ///< the name of what was kept, if that was it
    std::string renamed;  ///< the name that a preset got instead of its own, if that was it
    std::string problem;  ///< why nothing was changed, or not the tags; empty when all went well
  };
  /// Of the oldest change of which nothing has been told; once.
  std::optional<Outcome> takeOutcome();

  const std::string& lastChange() const { return state_.lastChange; }     ///< empty: there is none
  const std::string& problem() const { return state_.problem; }           ///< what was kept and cannot be read
  const std::vector<std::string>& names() const { return state_.names; }  ///< of the designer's own cloths
  std::string fileOf(const std::string& name) const;                      ///< of the cloth of this name

 private:
  using Presets = std::vector<Preset>;
  struct State {
    std::vector<std::string> names;
    std::string lastChange, problem;
  };
  /// What the thread has brought.
  struct Brought {
    State state;
    std::optional<Presets> presets;
    uint64_t number = 0;  ///< of the look that they are from
    std::optional<Outcome> outcome;
  };
  using Job = std::function<std::optional<Brought>(PresetLibrary&)>;
  void look();
  void change(std::function<Outcome(PresetLibrary&)> edit);
  // On the thread.
  static State stateOf(const PresetLibrary& cabinet);
  std::optional<Brought> done(const Job& job);
  std::optional<Brought> readOn(PresetLibrary& cabinet, PresetKind kind, uint64_t number);

  const std::filesystem::path folder_;
  PresetKind kind_ = PresetKind::fabrics;  ///< that is looked at
  float scale_ = 0;
  uint64_t looked_ = 0;  ///< the look that counts
  Presets presets_;
  State state_;
  Thumbnails thumbnails_;
  std::atomic<uint64_t> wanted_ = 0;
  std::deque<Outcome> outcomes_;            ///< that nobody has been told
  std::unique_ptr<PresetLibrary> cabinet_;  ///< the thread's
  Worker<Job, Brought> disk_;               // last: it ends before what it uses is gone
};

}  // namespace loomlight
