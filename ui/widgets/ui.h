#pragma once

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/units.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/tab_order.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_probe.h"

namespace loomlight {

/// What fields remember between frames: the text being typed, the fraction being scrubbed, what the mouse rests on.
struct FieldMemory {
  ImGuiID typing = 0;  ///< the field whose text is open; 0: none
  std::string text, openedAs;
  bool justOpened = false;
  int typedAt = 0;     ///< the frame in which that text was drawn last
  int unheard = 0;     ///< frames since then in which no key could reach it
  ImGuiID failed = 0;  ///< the field whose text was refused, and why
  std::string failure;
  double failedAt = 0;
  ImGuiID scrubbing = 0;
  double scrubValue = 0;  ///< unrounded
  bool scrubMoved = false;
  bool keysAreTaken = false;  ///< Escape and Enter are not for the dialog in this frame
  TabOrder tabOrder;
  ImVec2 screen{0, 0};   ///< in which dialogs have found their places
  int dialogOpened = 0;  ///< the frame in which the last one was
  ImGuiID restingOn = 0;
  double restingSince = 0;
};

/// What every panel is handed to draw with. Lives for a frame; what it points to lives as long as the window.
struct Ui {
  const Theme& theme;
  const Fonts& fonts;
  WidgetProbe& probe;
  FieldMemory& memory;
  float scale = 1;
  double time = 0;      ///< seconds
  double wakeIn = 1e9;  ///< the window draws again after so long even when nothing happens
  /// Of the display that the window is on, as the system says; else as most are.
  double pixels_per_mm = 96 / kMmPerInch;
  /// Where tooltips of what is drawn now open, if not at the mouse: beside what they would hide.
  std::optional<ImVec2> tooltipCorner{};

  float px(float atScale1) const { return atScale1 * scale; }
  void wakeWithin(double seconds) { wakeIn = std::min(wakeIn, seconds); }
};

}  // namespace loomlight
