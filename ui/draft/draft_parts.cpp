#include "ui/draft/draft_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "core/base/modulo.h"
#include "ui/widgets/fields.h"
#include "ui/words/draft_words.h"

namespace loomlight {
namespace {

/// One of the tables beside the drawdown.
struct Table {
  DraftPart part;
  DraftView::Stroke stroke;
  const char* id;
  Box box;
  int lines;         ///< ends, picks or treadles; those of threading and treadling repeat
  int numbers;       ///< shafts or treadles
  bool linesAcross;  ///< lines are columns, numbers count upwards; else lines are rows
  bool oneNumber;    ///< a click moves the line's number, rather than adding another
};

int picksOf(const Draft& draft) {
  return static_cast<int>(draft.liftplan.empty() ? draft.treadling.size() : draft.liftplan.size());
}

std::vector<Table> tablesOf(const Draft& draft, const DraftLayout& layout) {
  const Table threading{DraftPart::threading,
                        DraftView::Stroke::threading,
                        "draft.threading",
                        layout.threading,
                        static_cast<int>(draft.threading.size()),
                        draft.shafts,
                        true,
                        true};
  if (!draft.liftplan.empty()) {
    const Table liftplan{DraftPart::liftplan,
                         DraftView::Stroke::treadling,
                         "draft.treadling",
                         layout.treadling,
                         picksOf(draft),
                         draft.shafts,
                         false,
                         false};
    return {threading, liftplan};
  }
  const Table tieUp{DraftPart::tieUp,
                    DraftView::Stroke::tieUp,
                    "draft.tieup",
                    layout.tieUp,
                    draft.treadles,
                    draft.shafts,
                    true,
                    false};
  const Table treadling{DraftPart::treadling,
                        DraftView::Stroke::treadling,
                        "draft.treadling",
                        layout.treadling,
                        picksOf(draft),
                        draft.treadles,
                        false,
                        true};
  return {threading, tieUp, treadling};
}

/// Rectangle of a number of a line; lines of threading and treadling run along the cloth.
Box placeOf(const Table& table, const DraftFrame& frame, float lift, int line, int number) {
  const auto along = [lift](int i) { return std::round(lift * static_cast<float>(i)); };
  Box place;
  if (table.part == DraftPart::tieUp) {
    place.min.x = table.box.min.x + along(line), place.max.x = table.box.min.x + along(line + 1);
  } else {
    const Box cells = frame.cells(line, line);
    place = cells;
  }
  if (table.linesAcross) {
    place.min.y = table.box.max.y - along(number), place.max.y = table.box.max.y - along(number - 1);
  } else {
    place.min.x = table.box.min.x + along(number - 1), place.max.x = table.box.min.x + along(number);
  }
  return place;
}

/// The line (as `end`) and number (as `pick`) at a point, whether or not there are such.
CrossingIndex cellAt(const Table& table, const DraftFrame& frame, float lift, ImVec2 p) {
  const auto number = [lift](float along) { return 1 + static_cast<int>(std::floor(along / lift)); };
  if (table.part == DraftPart::tieUp)
    return {number(table.box.max.y - p.y), static_cast<int>(std::floor((p.x - table.box.min.x) / lift))};
  const CrossingIndex crossing = frame.at(p);
  if (table.linesAcross) return {number(table.box.max.y - p.y), crossing.end};
  return {number(p.x - table.box.min.x), crossing.pick};
}

/// One thread's numbers, or one treadle's. Where they lie too close for gaps, neighbours are drawn as one: there are
/// never more rectangles than pixels.
void drawLine(ImDrawList& draw, const Table& table, std::span<const int> numbers, float gap, ImU32 colour,
              const std::function<Box(int)>& place) {
  const auto drawn = [&](int number) {
    Box box = place(number);
    box.max.x = std::max(box.max.x, box.min.x + 1), box.max.y = std::max(box.max.y, box.min.y + 1);
    return box;
  };
  const auto touch = [](const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
  };
  std::optional<Box> run;
  const auto flush = [&] {
    if (run)
      draw.AddRectFilled(ImVec2(run->min.x + gap, run->min.y + gap), ImVec2(run->max.x - gap, run->max.y - gap),
                         colour);
  };
  for (const int number : numbers) {
    if (number < 1 || number > table.numbers) continue;
    const Box box = drawn(number);
    if (run && gap == 0 && touch(*run, box)) {
      run->min = ImVec2(std::min(run->min.x, box.min.x), std::min(run->min.y, box.min.y));
      run->max = ImVec2(std::max(run->max.x, box.max.x), std::max(run->max.y, box.max.y));
      continue;
    }
    flush();
    run = box;
  }
  flush();
}

/// Rules between numbers and between lines, as far as they stand apart.
void drawRules(Ui& ui, const Table& table, const DraftFrame& frame, float lift, int first, int last) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float fade = std::clamp((lift / ui.scale - 3.0f) / 5.0f, 0.0f, 1.0f);
  if (fade <= 0) return;
  const auto rule = [&](Box box, bool strong) {
    draw.AddRectFilled(box.min, box.max, packed(ui.theme.ink, fade * (strong ? 0.32f : 0.14f)));
  };
  for (int number = 0; number <= table.numbers; ++number) {
    const float at = std::round(lift * static_cast<float>(number));
    const float x = table.box.min.x + at, y = table.box.max.y - at;
    if (table.linesAcross)
      rule({ImVec2(table.box.min.x, y - 1), ImVec2(table.box.max.x, y)}, number % 4 == 0);
    else
      rule({ImVec2(x, table.box.min.y), ImVec2(x + 1, table.box.max.y)}, number % 4 == 0);
  }
  const bool repeats = table.part != DraftPart::tieUp;
  const float cell = table.linesAcross ? frame.cell : frame.cellHeight();
  if (repeats && cell < 6 * ui.scale) return;
  for (int line = first; line <= last + 1; ++line) {
    const Box place = placeOf(table, frame, lift, line, 1);
    const float x = !repeats || !frame.fromRight ? place.min.x : place.max.x;
    const float y = frame.fromTop ? place.min.y : place.max.y;
    if (table.linesAcross)
      rule({ImVec2(x, table.box.min.y), ImVec2(x + 1, table.box.max.y)}, wrap(line, 4) == 0);
    else
      rule({ImVec2(table.box.min.x, y), ImVec2(table.box.max.x, y + 1)}, wrap(line, 4) == 0);
  }
}

void drawTable(Ui& ui, const Draft& draft, const Table& table, const DraftFrame& frame, float lift) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(table.box.min, table.box.max, true);
  draw.AddRectFilled(table.box.min, table.box.max, packed(ui.theme.paper));
  const bool repeats = table.part != DraftPart::tieUp;
  int first = 0, last = table.lines - 1;
  if (repeats) {
    first = table.linesAcross ? frame.firstEnd() : frame.firstPick();
    last = table.linesAcross ? frame.lastEnd() : frame.lastPick();
  }
  const float cell = table.linesAcross ? frame.cell : frame.cellHeight();
  const float along = repeats ? std::min(cell, lift) : lift;
  const int step = std::max(1, static_cast<int>(std::ceil(1.0f / (repeats ? cell : lift))));
  const ImU32 ink = packed(ui.theme.ink), faded = packed(ui.theme.ink, 0.4f);
  const float gap = along >= 5 * ui.scale ? ui.scale : 0.0f;
  for (int line = first; line <= last; line += step) {
    const int inRepeat = wrap(line, table.lines);
    drawLine(draw, table, numbersOf(draft, table.part, inRepeat), gap, line == inRepeat ? ink : faded,
             [&](int number) { return placeOf(table, frame, lift, line, number); });
  }
  drawRules(ui, table, frame, lift, first, last);
  draw.PopClipRect();
}

/// Sets the cells between two of a table. Nothing where that changes nothing.
std::optional<Draft> painted(const Draft& draft, const Table& table, CrossingIndex from, CrossingIndex to, bool value,
                             bool alone) {
  std::optional<Draft> edited;
  const int steps = std::max(std::abs(to.pick - from.pick), std::abs(to.end - from.end));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 1 : static_cast<double>(i) / steps;
    const int number = from.pick + static_cast<int>(std::lround(t * (to.pick - from.pick)));
    int line = from.end + static_cast<int>(std::lround(t * (to.end - from.end)));
    if (number < 1 || number > table.numbers) continue;
    if (table.part == DraftPart::tieUp && (line < 0 || line >= table.lines)) continue;
    line = wrap(line, table.lines);
    if (hasNumber(edited ? *edited : draft, table.part, line, number) == value) continue;
    Draft now = edited ? std::move(*edited) : Draft(draft);
    edited = value && alone ? withOnlyNumber(std::move(now), table.part, line, number)
                            : withNumber(std::move(now), table.part, line, number, value);
  }
  return edited;
}

std::optional<Draft> strokeOn(Ui& ui, const Draft& draft, const Table& table, DraftView& view, const DraftFrame& frame,
                              float lift) {
  ImGui::SetCursorScreenPos(table.box.min);
  ImGui::InvisibleButton(table.id, ImVec2(table.box.width(), table.box.height()),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.probe.recordItem(table.id);
  if (!ImGui::IsItemActive()) {
    if (view.stroke == table.stroke) view.stroke = DraftView::Stroke::none;
    return std::nullopt;
  }
  const CrossingIndex under = cellAt(table, frame, lift, ImGui::GetIO().MousePos);
  if (view.stroke != table.stroke) {
    view.stroke = table.stroke;
    view.strokeValue = ImGui::IsMouseDown(ImGuiMouseButton_Left) &&
                       !hasNumber(draft, table.part, wrap(under.end, table.lines), under.pick);
    view.strokeLast = under;
  }
  const bool alone = table.oneNumber && !ImGui::GetIO().KeyCtrl;
  const auto edited = painted(draft, table, view.strokeLast, under, view.strokeValue, alone);
  view.strokeLast = under;
  return edited;
}

}  // namespace

std::optional<Draft> draftParts(Ui& ui, const Draft& draft, DraftView& view, const DraftFrame& frame,
                                const DraftLayout& layout) {
  std::optional<Draft> edited;
  for (const Table& table : tablesOf(draft, layout)) {
    if (table.lines == 0 || table.numbers == 0) continue;
    if (auto stroked = strokeOn(ui, draft, table, view, frame, layout.lift)) edited = std::move(stroked);
  }
  const Draft& shown = edited ? *edited : draft;
  for (const Table& table : tablesOf(shown, layout)) {
    if (table.lines == 0 || table.numbers == 0) continue;
    drawTable(ui, shown, table, frame, layout.lift);
    const Box first = placeOf(table, frame, layout.lift, 0, 1);
    ui.probe.record(std::string(table.id) + "_0_1", first.min, first.max);
  }
  return edited;
}

std::string partUnderMouse(const Draft& draft, const DraftFrame& frame, const DraftLayout& layout) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (const Table& table : tablesOf(draft, layout)) {
    if (table.lines == 0 || !ImGui::IsMouseHoveringRect(table.box.min, table.box.max)) continue;
    const CrossingIndex cell = cellAt(table, frame, layout.lift, mouse);
    if (cell.pick < 1 || cell.pick > table.numbers) return {};
    switch (table.part) {
      case DraftPart::threading:
        return fmt::format(words::draft::threading, wrap(cell.end, table.lines) + 1, cell.pick);
      case DraftPart::tieUp:
        return cell.end < 0 || cell.end >= table.lines ? "" : fmt::format(words::draft::tieUp, cell.end + 1, cell.pick);
      case DraftPart::treadling:
        return fmt::format(words::draft::treadling, wrap(cell.end, table.lines) + 1, cell.pick);
      case DraftPart::liftplan:
        return fmt::format(words::draft::liftplan, wrap(cell.end, table.lines) + 1, cell.pick);
    }
  }
  return {};
}

}  // namespace loomlight
