#include "ui/viewport/inset_view.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

constexpr int kUsualWidth = 280, kUsualHeight = 200;
constexpr float kClickReach = 4;  // a shorter drag is a click

bool pullsLeft(InsetView::Grip grip) {
  using Grip = InsetView::Grip;
  return grip == Grip::left || grip == Grip::topLeft || grip == Grip::bottomLeft;
}
bool pullsRight(InsetView::Grip grip) {
  using Grip = InsetView::Grip;
  return grip == Grip::right || grip == Grip::topRight || grip == Grip::bottomRight;
}
bool pullsTop(InsetView::Grip grip) {
  using Grip = InsetView::Grip;
  return grip == Grip::top || grip == Grip::topLeft || grip == Grip::topRight;
}
bool pullsBottom(InsetView::Grip grip) {
  using Grip = InsetView::Grip;
  return grip == Grip::bottom || grip == Grip::bottomLeft || grip == Grip::bottomRight;
}

/// One side of a rectangle along one axis: [begin, end) within [0, room), at least `least` long.
struct Span {
  int begin, end;
};

Span pulled(Span span, bool atBegin, bool atEnd, int by, int least, int room) {
  if (atBegin) span.begin = std::clamp(span.begin + by, 0, std::max(0, span.end - least));
  if (atEnd) span.end = std::clamp(span.end + by, std::min(room, span.begin + least), room);
  return span;
}

/// From one point to another, made long enough away from the first where there is room.
Span spanned(int from, int to, int least, int room) {
  from = std::clamp(from, 0, room);
  to = std::clamp(to, 0, room);
  Span span{std::min(from, to), std::max(from, to)};
  if (span.end - span.begin >= least) return span;
  if (to >= from) {
    span.end = std::min(room, span.begin + least);
    span.begin = std::max(0, span.end - least);
  } else {
    span.begin = std::max(0, span.end - least);
    span.end = std::min(room, span.begin + least);
  }
  return span;
}

}  // namespace

void InsetView::toggle() {
  if (on) {
    close();
  } else {
    on = true;
  }
}

void InsetView::close() {
  const bool difference = showsDifference;
  *this = InsetView();
  showsDifference = difference;
}

void InsetView::grab(Grip taken, ImVec2 at) {
  grip = taken;
  grabbedAt = at;
  grabbed = rect;
}

void InsetView::drag(ImVec2 to, int viewportWidth, int viewportHeight) {
  if (grip == Grip::none) return;
  const int dx = static_cast<int>(std::lround(to.x - grabbedAt.x)),
            dy = static_cast<int>(std::lround(to.y - grabbedAt.y));
  Span across{grabbed.x, grabbed.x + grabbed.width}, down{grabbed.y, grabbed.y + grabbed.height};
  if (grip == Grip::place) {
    if (std::abs(dx) < kClickReach && std::abs(dy) < kClickReach) return;
    const int x = static_cast<int>(grabbedAt.x), y = static_cast<int>(grabbedAt.y);
    across = spanned(x, x + dx, kNarrowest, viewportWidth);
    down = spanned(y, y + dy, kLowest, viewportHeight);
    placed = true;
  } else if (grip == Grip::move) {
    const int x = std::clamp(grabbed.x + dx, 0, std::max(0, viewportWidth - grabbed.width));
    const int y = std::clamp(grabbed.y + dy, 0, std::max(0, viewportHeight - grabbed.height));
    across = {x, x + grabbed.width};
    down = {y, y + grabbed.height};
  } else {
    across = pulled(across, pullsLeft(grip), pullsRight(grip), dx, kNarrowest, viewportWidth);
    down = pulled(down, pullsTop(grip), pullsBottom(grip), dy, kLowest, viewportHeight);
  }
  rect = {across.begin, down.begin, across.end - across.begin, down.end - down.begin};
}

void InsetView::letGo(int viewportWidth, int viewportHeight) {
  if (grip == Grip::place && !placed) {
    rect = {static_cast<int>(grabbedAt.x) - kUsualWidth / 2, static_cast<int>(grabbedAt.y) - kUsualHeight / 2,
            kUsualWidth, kUsualHeight};
    placed = true;
    keepWithin(viewportWidth, viewportHeight);
  }
  grip = Grip::none;
}

void InsetView::keepWithin(int viewportWidth, int viewportHeight) {
  rect.width = std::min(rect.width, viewportWidth);
  rect.height = std::min(rect.height, viewportHeight);
  rect.x = std::clamp(rect.x, 0, viewportWidth - rect.width);
  rect.y = std::clamp(rect.y, 0, viewportHeight - rect.height);
}

InsetView::Grip InsetView::gripAt(ImVec2 at, float reach) const {
  if (!on) return Grip::none;
  if (!placed) return Grip::place;
  const auto left = static_cast<float>(rect.x), top = static_cast<float>(rect.y);
  const float right = left + static_cast<float>(rect.width), bottom = top + static_cast<float>(rect.height);
  if (at.x < left - reach || at.x > right + reach || at.y < top - reach || at.y > bottom + reach) return Grip::none;
  const bool l = std::abs(at.x - left) <= reach, r = std::abs(at.x - right) <= reach;
  const bool t = std::abs(at.y - top) <= reach, b = std::abs(at.y - bottom) <= reach;
  if (t) return l ? Grip::topLeft : r ? Grip::topRight : Grip::top;
  if (b) return l ? Grip::bottomLeft : r ? Grip::bottomRight : Grip::bottom;
  return l ? Grip::left : r ? Grip::right : Grip::none;
}

ImGuiMouseCursor cursorOf(InsetView::Grip grip) {
  using Grip = InsetView::Grip;
  switch (grip) {
    case Grip::none:
      return ImGuiMouseCursor_Arrow;
    case Grip::place:
      return ImGuiMouseCursor_Hand;
    case Grip::move:
      return ImGuiMouseCursor_ResizeAll;
    case Grip::left:
    case Grip::right:
      return ImGuiMouseCursor_ResizeEW;
    case Grip::top:
    case Grip::bottom:
      return ImGuiMouseCursor_ResizeNS;
    case Grip::topLeft:
    case Grip::bottomRight:
      return ImGuiMouseCursor_ResizeNWSE;
    case Grip::topRight:
    case Grip::bottomLeft:
      return ImGuiMouseCursor_ResizeNESW;
  }
  return ImGuiMouseCursor_Arrow;
}

ImVec2 besideInset(const InsetRect& rect, ImVec2 size, float gap, int viewportWidth) {
  const float above = static_cast<float>(rect.y) - gap - size.y;
  const float x =
      std::clamp(static_cast<float>(rect.x), 0.0f, std::max(0.0f, static_cast<float>(viewportWidth) - size.x));
  return {x, above >= 0 ? above : static_cast<float>(rect.y) + gap};
}

}  // namespace loomlight
