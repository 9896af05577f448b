#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

namespace loomlight {

/// The order in which Tab goes from one number to the next: that in which they are drawn, within one panel or dialog.
/// Texts have a place in it, so that Tab goes on from them, but are not gone to: whoever types numbers does not rename
/// the cloth.
class TabOrder {
 public:
  /// A field says where it is, each time that it is drawn; `panel`: what Tab does not leave.
  void pass(ImGuiID field, ImGuiID panel, bool isNumber);
  /// Goes on to the next number (step 1) or the one before (-1), round at the ends; from the field that was typed into
  /// last, or from the beginning of the panel. It opens when it is drawn next.
  void go(int step, std::optional<ImGuiID> panel);
  /// That field is where Tab goes on from; `byKeys`: it was left by Enter, so that it is to be seen where one stands.
  void standOn(ImGuiID field, bool byKeys) {
    standing_ = field;
    isSeen_ = byKeys;
  }
  bool isSeenOn(ImGuiID field) const { return isSeen_ && field == standing_; }
  /// The mouse has taken over.
  void hide() { isSeen_ = false; }
  bool isGoing() const { return wanted_ != 0; }
  /// What was typed was refused: one stays.
  void stay() { wanted_ = 0; }
  /// Whether the field is the one that is gone to; it is told once.
  bool arrive(ImGuiID field);

 private:
  struct Stop {
    ImGuiID field = 0, panel = 0;
    bool isNumber = false;
  };
  std::vector<Stop> drawn_, drawing_;  ///< of the last whole frame, and of the present one
  int frame_ = -1, wantedIn_ = -1;     ///< in which a field was drawn last, and in which one was gone to
  ImGuiID standing_ = 0, wanted_ = 0;
  bool isSeen_ = false;
};

}  // namespace loomlight
