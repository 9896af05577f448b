#pragma once

#include <imgui.h>

#include <string>

#include "tests/headless/editor/action_count.h"

namespace loomlight {

/// Mouse and keyboard of an editor without a window: what the window's backend would tell Dear ImGui. Key names are
/// those of X: "ctrl", "shift", "Return", "Escape", "F1", "slash", "a", "1".
class HeadlessInput {
 public:
  /// Of the context that is current.
  HeadlessInput();

  void move(ImVec2 place);
  void button(int button, bool down);
  void wheel(float clicks);  ///< positive: away from the user
  /// Throws std::invalid_argument where it knows no such key.
  void key(const std::string& name, bool down);
  void character(const std::string& utf8);  ///< of a key
  void type(const std::string& utf8);       ///< a value, letter by letter
  /// What has been done so far.
  const ActionCount& actions() const { return actions_; }

 private:
  ActionCount actions_;
};

}  // namespace loomlight
