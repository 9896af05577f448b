#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "core/base/memory.h"
#include "core/fabric/model/fabric.h"

namespace loomlight {

/// In which panel an edit was made: undo goes back there.
struct EditPlace {
  enum class Panel { none, draft, inspector };
  Panel panel = Panel::none;
  float cell = 0, originX = 0, originY = 0;  ///< how the draft was looked at (DraftView)
  int page = 0, yarn = 0;                    ///< of the inspector
  friend bool operator==(const EditPlace&, const EditPlace&) = default;
};

/// The fabric that is edited, how it came to be, and the file it lives in. Undo keeps the old values, which share what
/// did not change: hundreds of thousands of small steps, or as many as memory is set aside for.
class Document {
 public:
  /// Of a machine with so much memory: an eighth, and a gigabyte at most.
  static size_t memoryForUndo_bytes(uint64_t physical_bytes);

  /// `mostBytes`: of old values; beyond that the oldest go.
  explicit Document(Fabric fabric, std::string file = {},
                    size_t mostBytes = memoryForUndo_bytes(physicalMemory_bytes()));
  /// Work that is in no file: there is nothing before it that undo could return to, and it is dirty until it is saved.
  static Document unsaved(Fabric fabric);

  /// As it is looked at: under the lamp that it is judged by.
  const std::shared_ptr<const Fabric>& fabric() const { return seen_; }
  /// As it is kept: under its own lamp.
  const std::shared_ptr<const Fabric>& cloth() const { return steps_[now_].fabric; }
  const std::string& file() const { return file_; }  ///< empty while it has none
  bool isDirty() const { return state() != savedState_; }
  /// Counts up with every edit and every undo; looking around is none.
  uint64_t revision() const { return revision_; }

  /// All edits of one gesture (a drag, a text being typed) are one step of undo. A cloth that is judged keeps its own
  /// lamp; where a third is wanted that is the cloth's, and judging ends.
  void edit(Fabric fabric, uint64_t gesture, const EditPlace& place = {});
  /// Looking around: no step of undo, no reason to ask at the end.
  void lookFrom(const Camera& camera);
  /// The cloth is judged by another lamp, as in a light booth; null: its own shines. Likewise no edit.
  void judgeUnder(std::optional<StandardIlluminant> lamp);
  std::optional<StandardIlluminant> judgedUnder() const { return judgedUnder_; }
  /// How large pictures of it are to be, and how fine: no edit of the cloth either.
  void renderAs(const RenderSettings& settings);
  bool canUndo() const { return now_ > 0; }
  bool canRedo() const { return now_ + 1 < steps_.size(); }
  /// Return where the edit was made that is taken back, or made again.
  EditPlace undo();
  EditPlace redo();

  /// Which of its states this is; none has the number of another.
  uint64_t state() const { return steps_[now_].id; }
  /// That state of it is in the file now, and the file is its own.
  void savedAs(const std::string& file, uint64_t state);

 private:
  struct Step {
    std::shared_ptr<const Fabric> fabric;
    uint64_t id = 0;
    EditPlace place;   ///< of the edit that led to it
    size_t bytes = 0;  ///< about, that it does not share with the one before
  };
  void push(Step step);
  void keepAsLookedAt(std::shared_ptr<const Fabric> fabric);
  void look();
  void go(size_t step);

  std::deque<Step> steps_;
  size_t now_ = 0;
  std::optional<StandardIlluminant> judgedUnder_;
  std::shared_ptr<const Fabric> seen_;
  size_t bytes_ = 0, mostBytes_;  ///< of all steps
  std::string file_;
  uint64_t nextId_ = 1, savedState_ = 0, revision_ = 0, gesture_ = 0;
};

}  // namespace loomlight
