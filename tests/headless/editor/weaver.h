#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/fabric/json/fabric_json.h"
#include "tests/headless/editor/headless_editor.h"

namespace loomlight {

/// Of a weave as weavers draw it: a string for each pick, the first pick last, '#' where the warp lies over.
using Rows = std::vector<std::string>;

inline Rows rowsOf(const Weave& weave) {
  Rows rows;
  for (int pick = weave.picks() - 1; pick >= 0; --pick) {
    rows.emplace_back();
    for (int end = 0; end < weave.ends(); ++end) rows.back() += weave.at(pick, end) ? '#' : '.';
  }
  return rows;
}

/// Each row as `change` makes it.
template <class Change>
Rows eachRow(const Rows& rows, const Change& change) {
  Rows changed;
  for (const std::string& row : rows) changed.push_back(change(row));
  return changed;
}

inline std::string turnedOver(std::string row) {
  for (char& cell : row) cell = cell == '#' ? '.' : '#';
  return row;
}

/// A weaver at the draft of an editor: clicks its cells by number, and reads what is saved.
class Weaver {
 public:
  explicit Weaver(HeadlessEditor& editor) : editor_(editor) {}

  Rows rows() { return rowsOf(editor_.saved().weave); }

  /// Where the crossing is, from 0 each. In the draft's own place, the first thread at the bottom left.
  ImVec2 crossing(int pick, int end) const { return cell("draft.cell_0_0", end, pick); }
  ImVec2 threading(int end, int shaft) const { return cell("draft.threading_0_1", end, shaft - 1); }
  ImVec2 tieUp(int treadle, int shaft) const { return cell("draft.tieup_0_1", treadle, shaft - 1); }
  ImVec2 treadling(int pick, int treadle) const { return cell("draft.treadling_0_1", treadle - 1, pick); }

  /// From crossing to crossing, pick and end each, with Ctrl held.
  void select(int firstPick, int firstEnd, int lastPick, int lastEnd) {
    editor_.hold("ctrl");
    editor_.drag(crossing(firstPick, firstEnd), crossing(lastPick, lastEnd));
    editor_.let("ctrl");
  }
  void showsDraft(const std::string& kind, const std::string& shafts = {}) {
    editor_.until("the draft is shown as " + kind + " on " + (shafts.empty() ? "any" : shafts) + " shafts", [&] {
      return editor_.fact("draft.kind") == kind && (shafts.empty() || editor_.fact("draft.shafts") == shafts);
    });
  }
  /// From the page of structures, which may have to be scrolled.
  void takes(const std::string& structure) {
    const std::string id = "structure/" + structure;
    const HeadlessEditor::Rect tab = editor_.rect("draft.tab_structures");
    const ImVec2 page(tab.x1, tab.y1 + 60);
    while (editor_.rect(id).y1 > editor_.screen().y - 110) editor_.wheelAt(page, -1);
    while (editor_.rect(id).y0 < tab.y1 + 8) editor_.wheelAt(page, 1);
    editor_.edits(structure + " replaces the weave", [&] { editor_.click(id); });
  }
  void undo() {
    editor_.edits("undo", [this] { editor_.key("ctrl+z"); });
  }

 private:
  /// So many cells to the right of a widget that is one, and upwards.
  ImVec2 cell(const std::string& first, int right, int up) const {
    const HeadlessEditor::Rect r = editor_.rect(first);
    return ImVec2(0.5f * (r.x0 + r.x1) + static_cast<float>(right) * (r.x1 - r.x0),
                  0.5f * (r.y0 + r.y1) - static_cast<float>(up) * (r.y1 - r.y0));
  }

  HeadlessEditor& editor_;
};

/// A 2/2 twill that a slow machine keeps up with: a small flat piece, few voxels, and as much of the yarns in a tenth
/// as many fibres.
inline Fabric smallTwill() {
  Fabric fabric = readFabric(LOOMLIGHT_SAMPLES "/blue_cloth.json");
  fabric.weave = Weave(std::vector<Weave::Row>{{1, 0, 0, 1}, {1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}});
  for (Fibre& fibre : fabric.fibres) fibre.radius_um = 20;
  for (Yarn& yarn : fabric.yarns) yarn.fibresPerPly = 17;
  fabric.drape = {};
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.light = {};
  fabric.light.kind = LightKind::dome;
  fabric.camera = {};
  fabric.camera.distance_mm = 64;  // hardly any of the picture, so that tracing it takes no time
  fabric.render = {};
  fabric.render.resolution = 1;
  return fabric;
}

}  // namespace loomlight
