#pragma once

#include <span>

#include "ui/widgets/ui.h"

namespace loomlight {

/// How wide a toggleButton() of this name is, in pixels.
float toggleWidth(const Ui& ui, const char* name);
/// A button that is on or off, as wide as its name needs. True when it changed.
bool toggleButton(Ui& ui, const char* id, const char* name, const char* tooltip, bool& on);

/// Pages below a line, each name centred on its share of the width. True when another was opened.
bool pageTabs(Ui& ui, std::span<const char* const> names, std::span<const char* const> ids, int& open);

/// How far a page can be scrolled, from frame to frame.
struct PageScroll {
  bool isNeeded = false;
  float height = 0;  ///< of what is seen of it, in pixels
};

/// A page below tabs, whose scroll bar stands in the panel's margin. A height of 0: all there is.
void beginPage(Ui& ui, const char* id, float height, PageScroll& scroll);
/// Rows that have gone leave their room at the end until the page is scrolled up: it does not move under the mouse
/// because an edit has made it shorter.
void endPage(PageScroll& scroll);

}  // namespace loomlight
