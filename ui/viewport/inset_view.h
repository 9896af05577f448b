#pragma once

#include <imgui.h>

namespace loomlight {

/// Pixels of the viewport, from its top left.
struct InsetRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const InsetRect&) const = default;
};

/// The reference inset (the truth lens, in the words of the window) as the mouse handles it. Pure: what is drawn and
/// what is traced in it are others' affairs.
struct InsetView {
  static constexpr int kNarrowest = 96, kLowest = 64;  ///< pixels
  enum class Grip { none, place, move, left, right, top, bottom, topLeft, topRight, bottomLeft, bottomRight };

  bool on = false;      ///< chosen; without a place the next drag gives it one
  bool placed = false;  ///< `rect` is where it is
  bool showsDifference = false;
  InsetRect rect;
  Grip grip = Grip::none;  ///< what the mouse holds
  ImVec2 grabbedAt{0, 0};  ///< where it took hold, in the viewport
  InsetRect grabbed;       ///< and the rectangle then

  void toggle();
  void close();
  /// Takes hold at a point of the viewport. `grip` as gripAt() says, or move by the bar.
  void grab(Grip taken, ImVec2 at);
  /// The mouse is there now. The inset stays within the viewport and never gets too small to be used.
  void drag(ImVec2 to, int viewportWidth, int viewportHeight);
  /// A click instead of a drag places an inset of usual size around the point.
  void letGo(int viewportWidth, int viewportHeight);
  /// Back into a viewport that has become smaller.
  void keepWithin(int viewportWidth, int viewportHeight);
  /// The edge or corner within `reach` pixels of a point; place while it has no place; none elsewhere.
  Grip gripAt(ImVec2 at, float reach) const;
};

/// The mouse cursor that says what a grip does.
ImGuiMouseCursor cursorOf(InsetView::Grip grip);

/// Where a box of this size goes beside the inset: above its top left corner, or inside where there is no room.
ImVec2 besideInset(const InsetRect& rect, ImVec2 size, float gap, int viewportWidth);

}  // namespace loomlight
