#include "ui/inspector/mill_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/yarn/cloth_states.h"
#include "ui/inspector/list_field.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/cloth_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

constexpr double kCmPerInch = 2.54;

/// A number that may be left unsaid, with `none` in its place then; shown to the inch where that is wanted.
bool figureField(Ui& ui, const RowText& text, const FieldInfo& info, const char* unit, double perUnit, const char* none,
                 double& value) {
  NumberStyle style;
  style.unit = unit;
  style.min = info.min * perUnit;
  style.max = info.max * perUnit;
  style.decimals = 1;
  style.perPixel = 0.1;
  style.none = none;
  double shown = value * perUnit;
  if (!numberField(ui, text, style, shown)) return false;
  value = std::clamp(shown / perUnit, info.min, info.max);
  return true;
}

bool dentingField(Ui& ui, std::vector<int>& endsPerDent) {
  const std::string expected = fmt::format(words::mill::dentingExpected, MillData::kMostInDent);
  bool changed = false;
  listField(ui, {"mill.ends_per_dent", words::endsPerDent}, dentingText(endsPerDent), "", expected,
            [&](const std::string& typed) {
              const auto dents = dentingFromText(typed);
              if (!dents) return false;
              changed = *dents != endsPerDent;
              endsPerDent = *dents;
              return true;
            });
  return changed;
}

bool selvedgeRows(Ui& ui, const std::vector<std::string>& yarnNames, MillData& mill) {
  bool changed = memberField(ui, "mill", mill, &MillData::selvedgeEnds);
  if (mill.selvedgeEnds == 0) return changed;
  changed |= memberField(ui, "mill", mill, &MillData::selvedgeEndsPerDent);
  std::vector<std::string> yarns{words::mill::asWarp};
  yarns.insert(yarns.end(), yarnNames.begin(), yarnNames.end());
  const std::vector<const char*> names = choicesOf(yarns);
  int chosen = mill.selvedgeYarn ? *mill.selvedgeYarn + 1 : 0;
  if (choiceField(ui, {"mill.selvedge_yarn", words::mill::selvedgeYarn}, names, chosen)) {
    mill.selvedgeYarn = chosen == 0 ? std::nullopt : std::optional(chosen - 1);
    changed = true;
  }
  return textField(ui, rowText("mill", &MillData::selvedgeWeave), mill.selvedgeWeave, words::mill::asCloth) || changed;
}

/// A row of the table of setts: a name, and what is drawn for ends and for picks.
template <class Ends, class Picks>
void stateRow(Ui& ui, const char* id, const Word& word, Ends&& ends, Picks&& picks) {
  const RowText text{id, word};
  const FieldRow row = beginRow(ui, text);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float gap = ui.px(6), half = std::floor(0.5f * (row.width - gap));
  const auto cell = [&](const char* name, auto&& draw) {
    ImGui::BeginChild((std::string(id) + name).c_str(), ImVec2(half, row.height));
    draw();
    ImGui::EndChild();
  };
  cell(" ends", ends);
  ImGui::SameLine(0, gap);
  cell(" picks", picks);
  endRow(ui, text, min, ImVec2(min.x + row.width, min.y + row.height), row.cut);
}

/// What the columns are of.
void columnNames(Ui& ui, const char* unit) {
  const auto name = [&](const char* what) {
    const std::string whole = fmt::format("{} {}", what, unit);
    const float room = ImGui::GetContentRegionAvail().x - ui.px(8);
    const std::string text = ImGui::CalcTextSize(whole.c_str()).x <= room ? whole : what;
    ImGui::SetCursorPosX(room - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text.c_str());
  };
  stateRow(ui, "cloth.states", {""}, [&] { name(words::mill::ends); }, [&] { name(words::mill::picks); });
}

/// The cells of a state that is reckoned or known otherwise.
void shownState(Ui& ui, const std::string& id, const Word& word, const ClothState& state, double perUnit) {
  const auto cell = [&](const char* what, const KnownSett& sett) {
    const std::string tooltip = fmt::format("{}: {}. {}", word.label, sourceText(sett.source), word.help);
    readout(ui, {id + what, "", tooltip.c_str(), true}, settText({sett.per_cm * perUnit, sett.source}));
  };
  stateRow(ui, id.c_str(), word, [&] { cell("_ends", state.ends); }, [&] { cell("_picks", state.picks); });
}

/// Those of a state that the mill counts; what is known without it stands there until then.
bool countedState(Ui& ui, const char* id, const Word& word, const ClothState& known, double perUnit, MillData& mill,
                  double MillData::* ends, double MillData::* picks) {
  bool changed = false;
  const auto cell = [&](const KnownSett& sett, double MillData::* member) {
    const FieldInfo info = fieldInfo(member);
    const std::string otherwise = settText({sett.per_cm * perUnit, sett.source});
    changed |= figureField(ui, {std::string("mill.") + info.key, "", info.help, true}, info, "", perUnit,
                           otherwise.c_str(), mill.*member);
  };
  stateRow(ui, id, word, [&] { cell(known.ends, ends); }, [&] { cell(known.picks, picks); });
  return changed;
}

void shrinkageRow(Ui& ui, const char* id, const Word& word, const ClothState& before, const ClothState& after) {
  const auto text = [](const std::optional<double>& percent) {
    return percent ? fmt::format("{:.1f} %", *percent) : words::panels::none;
  };
  const std::optional<double> width = shrinkage_percent(before.ends, after.ends);
  const std::optional<double> length = shrinkage_percent(before.picks, after.picks);
  if (width || length) readout(ui, {id, word}, fmt::format("{} \xC3\x97 {}", text(width), text(length)));
}

bool stateRows(Ui& ui, const Fabric& fabric, const InspectorModel& model, MillData& mill) {
  const double perUnit = model.inches ? kCmPerInch : 1;
  const auto crimps = model.measured ? std::optional(Crimps{model.crimpWarp, model.crimpWeft}) : std::nullopt;
  const ClothStates states = clothStates(fabric, crimps);
  heading(ui, words::mill::setts);
  columnNames(ui, model.inches ? "/in" : "/cm");
  shownState(ui, "cloth.reed_state", words::reedState, states.reed, perUnit);
  bool changed = countedState(ui, "cloth.loom_state", words::loomState, states.loom, perUnit, mill,
                              &MillData::loomEnds_per_cm, &MillData::loomPicks_per_cm);
  shownState(ui, "cloth.finished_state", words::finishedState, states.finished, perUnit);
  changed |= countedState(ui, "cloth.washed_state", words::washedState, states.washed, perUnit, mill,
                          &MillData::washedEnds_per_cm, &MillData::washedPicks_per_cm);
  shrinkageRow(ui, "cloth.contraction", words::mill::contraction, states.reed, states.finished);
  shrinkageRow(ui, "cloth.washing_shrinkage", words::mill::washingShrinkage, states.finished, states.washed);
  return changed;
}

}  // namespace

bool millRows(Ui& ui, Fabric& fabric, const InspectorModel& model) {
  const FieldInfo reed = fieldInfo(&MillData::reed_per_10cm);
  heading(ui, words::mill::reedAndSelvedges);
  bool changed = figureField(ui, rowText("mill", &MillData::reed_per_10cm), reed,
                             model.inches ? words::mill::dentsPerInch : reed.unit, model.inches ? 0.1 * kCmPerInch : 1,
                             words::panels::none, fabric.mill.reed_per_10cm);
  changed |= dentingField(ui, fabric.mill.endsPerDent);
  changed |= selvedgeRows(ui, model.yarns.names, fabric.mill);
  return stateRows(ui, fabric, model, fabric.mill) || changed;
}

}  // namespace loomlight
