#include "app/export/sheet/cloth_sheet_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <span>

#include "app/export/sheet/cairo_output.h"
#include "core/base/rgb.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/weave/weave_code.h"
#include "core/fabric/weave/yarn_order.h"
#include "core/fabric/weave/yarn_sequence.h"
#include "core/fabric/yarn/cloth_states.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/yarn_name.h"
#include "core/fabric/yarn/yarn_need.h"

// How it works. Above are the cloth and its draft side by side, below them the construction and the orders of colours.
// What follows goes over the whole width, part by part and line by line: a line that the page has no room for begins
// the next page. Every text has a room and is cut off where it does not fit, so that none runs into another.

namespace loomlight {
namespace {

constexpr double kColumn_mm = 90, kGap_mm = 6, kRight_mm = kSheetMargin_mm + kColumn_mm + kGap_mm;
constexpr double kEnd_mm = kSheetWidth_mm - kSheetMargin_mm, kBottom_mm = kSheetHeight_mm - kSheetMargin_mm;
constexpr double kLine_mm = 3.6, kBetween_mm = 4.5;
constexpr double kBelowRule_mm = 0.6;  // more than between lines
constexpr Paper::Font kTitle{5.2, true}, kHeading{3.0, true}, kBody{2.6}, kQuiet{2.6, false, 0.4};

/// Ends or picks of each yarn in a repeat.
std::vector<Stripe> sumsOf(const std::vector<int>& sequence) {
  std::map<int, int> counts;
  for (const int yarn : sequence) ++counts[yarn];
  std::vector<Stripe> sums;
  for (const auto& [yarn, width] : counts) sums.push_back({yarn, width});
  return sums;
}

/// Whether the order is the same from its other end.
bool comesBack(const std::vector<Stripe>& stripes) {
  return std::equal(stripes.begin(), stripes.begin() + static_cast<ptrdiff_t>(stripes.size() / 2), stripes.rbegin());
}

std::string twistOf(const Yarn& yarn) {
  const auto turns = [](double per_m, TwistDirection way) {
    return fmt::format("{:.0f} {}", per_m, way == TwistDirection::z ? "Z" : "S");
  };
  std::string text = turns(yarn.plyTwist_per_m, yarn.plyTwistDirection);
  if (yarn.plies > 1) text += " / " + turns(yarn.yarnTwist_per_m, yarn.yarnTwistDirection);
  if (yarn.cords > 1) text += " / " + turns(yarn.cableTwist_per_m, yarn.cableTwistDirection);
  return text;
}

/// Returns the y of the line below.
double titleLine(Paper& paper, const std::string& text) {
  const double y = kSheetMargin_mm + kTitle.size_mm;
  paper.text(kSheetMargin_mm, y, text, kTitle, kEnd_mm - kSheetMargin_mm);
  paper.line(kSheetMargin_mm, y + 2, kEnd_mm, y + 2, 0.3, 0.2);
  return y + 6;
}

class SheetWriter {
 public:
  SheetWriter(Paper& paper, const Fabric& fabric, const ClothSheetOptions& options, const ClothSheetContent& content)
      : paper_(paper),
        fabric_(fabric),
        options_(options),
        content_(content),
        states_(clothStates(fabric, Crimps{content.measures.crimpWarp, content.measures.crimpWeft})) {}

  void write() {
    const double top = titleLine(paper_, fabric_.name);
    const double below = std::max(cloth(kSheetMargin_mm, top), draft(kRight_mm, top)) + kBetween_mm;
    const double belowFigures = construction(kSheetMargin_mm, below);
    orders(below, belowFigures);
    y_ = belowFigures + kBetween_mm;
    yarns();
    colours();
    standards();
    notes();
    colourways();
  }

 private:
  /// The next page, where this one has no room of that height.
  void expectRoom(double height_mm) {
    if (y_ + height_mm <= kBottom_mm) return;
    paper_.newPage();
    y_ = titleLine(paper_, fabric_.name) + kLine_mm;
  }

  double heading(double x, double y, const std::string& text) {
    paper_.text(x, y, text, kHeading, kColumn_mm);
    return y + kLine_mm + 0.6;
  }

  double row(double x, double y, const std::string& label, const std::string& value) {
    paper_.text(x, y, label, kQuiet, 27);
    paper_.text(x + 28, y, value, kBody, kColumn_mm - 28);
    return y + kLine_mm;
  }

  /// What stands above the columns of a table, and a rule below it; returns the y of the first row.
  double tableHead(double y, std::span<const double> columns, std::initializer_list<const char*> heads, double end) {
    constexpr double kHead_mm = kLine_mm + kBelowRule_mm;
    const double* column = columns.data();
    for (const char* const head : heads) paper_.text(*column++, y, head, kQuiet);
    paper_.line(columns[0], y + 1.2, end, y + 1.2, 0.15);
    return y + kHead_mm;
  }

  /// The row of a table over the whole width, from its second column on.
  void tableRow(std::span<const double> columns, std::span<const std::string> cells) {
    for (size_t k = 0; k < cells.size(); ++k)
      paper_.text(columns[k + 1], y_, cells[k], kBody,
                  (k + 2 < columns.size() ? columns[k + 2] : kEnd_mm) - columns[k + 1] - 2);
    y_ += kLine_mm;
  }

  void swatch(double x, double y, const Rgb& linear) { paper_.fill(x, y - 2.4, 5, 2.8, clippedSrgbFromLinear(linear)); }

  double cloth(double x, double y) {
    paper_.picture(x, y, kSheetCloth_mm, kSheetCloth_mm, content_.cloth);
    y += kSheetCloth_mm + 3;
    constexpr double kBar_mm = 50;  // to check that the page was not scaled in print
    paper_.line(x, y - 1, x + kBar_mm, y - 1, 0.3, 0.1);
    for (int i = 0; i <= 5; ++i) paper_.line(x + 10 * i, y - 2, x + 10 * i, y, 0.2, 0.1);
    paper_.text(x + kBar_mm + 2, y, "50 mm; cloth at 1 : 1", kQuiet, kColumn_mm - kBar_mm - 2);
    return y + kLine_mm;
  }

  double draft(double x, double y) {
    std::string said;
    paper_.draw(x, y, [&](cairo_t* canvas) {
      said = drawDraft(canvas, fabric_, content_.yarnColours, options_.corner, kColumn_mm * kPointsPerMm,
                       kSheetCloth_mm * kPointsPerMm);
    });
    paper_.text(x, y + kSheetCloth_mm + 3, said, kQuiet, kColumn_mm);
    return y + kSheetCloth_mm + 3 + kLine_mm;
  }

  double construction(double x, double y) {
    const ClothMeasures& m = content_.measures;
    const Weave& weave = fabric_.weave;
    y = setts(x, heading(x, y, "Construction"));
    const MillData& mill = fabric_.mill;
    y = row(x, y, "Reed",
            mill.reed_per_10cm > 0
                ? fmt::format("{:g} dents/10 cm, ends per dent {}", mill.reed_per_10cm, dentingText(mill.endsPerDent))
                : "not said");
    const auto reed_cm = reedWidth_cm(fabric_, states_, options_.width_cm);
    y = row(x, y, "Width",
            fmt::format("{:.0f} cm finished", options_.width_cm) +
                (reed_cm ? fmt::format(", {:.0f} cm in the reed", *reed_cm) : ""));
    y = row(x, y, "Ends", fmt::format("{:.0f}", options_.width_cm * fabric_.ends_per_cm));
    for (const auto& [label, spacing] :
         {std::pair("Ends apart", fabric_.warpSpacing), {"Picks apart", fabric_.weftSpacing}})
      if (!spacing.empty()) y = row(x, y, label, spacingText(spacing) + ", over each other, repeating");
    const std::string selvedges =
        selvedgeText(mill, mill.selvedgeYarn ? "yarn " + yarnLetters(*mill.selvedgeYarn) : "");
    if (!selvedges.empty()) y = row(x, y, "Selvedges", selvedges);
    y = row(x, y, "Weave", isoWeaveCode(weave) ? "ISO 9354  " + *isoWeaveCode(weave) : "as drawn");
    y = row(x, y, "Weave repeat", repeat(weave.ends(), weave.picks()));
    y = row(x, y, "Pattern repeat", repeat(patternEnds(fabric_), patternPicks(fabric_)));
    y = row(x, y, "Mass",
            fmt::format("{:.0f} g/m\xC2\xB2, {:.0f} g per running metre", m.arealMass_g_m2,
                        m.arealMass_g_m2 * options_.width_cm / 100));
    y = row(
        x, y, "Thickness, crimp",
        fmt::format("{:.2f} mm; warp {:.1f} %, weft {:.1f} %", m.thickness_mm, 100 * m.crimpWarp, 100 * m.crimpWeft));
    const CoverFactors cover = coverFactors(fabric_);
    y = row(x, y, "Cover factor",
            fmt::format("Peirce: {:.1f}; warp {:.1f}, weft {:.1f}", cover.cloth, cover.warp, cover.weft));
    y = row(x, y, "Area covered", fmt::format("{:.0f} %, of yarns as they lie, from straight above", 100 * m.cover));
    const Floats f = floats(weave);
    return row(x, y, "Longest float",
               fmt::format("warp {} ({:.1f} mm), weft {} ({:.1f} mm)", f.warp(),
                           floatLength_mm(fabric_, System::warp, f.warp()), f.weft(),
                           floatLength_mm(fabric_, System::weft, f.weft())));
  }

  /// The cloth from the reed to the wash.
  double setts(double x, double y) {
    const double columns[] = {x, x + 20, x + 33, x + 48};
    y = tableHead(y, columns, {"Sett", "ends/cm", "picks/cm", "known from"}, x + kColumn_mm);
    const std::pair<const char*, const ClothState*> rows[] = {
        {"in the reed", &states_.reed},
        {"loom state", &states_.loom},
        {"finished", &states_.finished},
        {"washed", &states_.washed},
    };
    for (const auto& [name, state] : rows) {
      const auto& [ends, picks] = *state;
      paper_.text(columns[0], y, name, kQuiet);
      paper_.text(columns[1], y, settText(ends), kBody, 12);
      paper_.text(columns[2], y, settText(picks), kBody, 12);
      std::string source = sourceText(ends.source);
      if (picks.source != ends.source) source += fmt::format("; {}", sourceText(picks.source));
      paper_.text(columns[3], y, source, kQuiet, kColumn_mm - 48);
      y += kLine_mm;
    }
    return y + 1;
  }

  std::string repeat(int64_t ends, int64_t picks) const {
    return fmt::format("{} x {} threads, {:.1f} x {:.1f} mm", ends, picks,
                       static_cast<double>(ends) * fabric_.warpPitch_mm(),
                       static_cast<double>(picks) * fabric_.weftPitch_mm());
  }

  void yarnSwatch(double x, double y, int yarn) { swatch(x, y, content_.yarnColours[static_cast<size_t>(yarn)]); }

  /// A table of threads in the room down to `bottom`: stripe by stripe where they all fit; else, of an order that comes
  /// back the way it went, one half of it; else the order as weavers write it, and how many threads of each yarn it
  /// has.
  void orderTable(double x, double y, double width, const char* label, const char* threads,
                  const std::vector<int>& sequence, double pitch_mm, double bottom) {
    const double columns[] = {x, x + 7, x + 15, x + 28}, end = x + width;
    const auto cm = [&](double count) { return fmt::format("{:.2f}", 0.1 * pitch_mm * count); };
    std::vector<Stripe> rows = stripesOf(sequence);
    const auto rowsIn = [&](double from) {
      return static_cast<size_t>(std::max(0.0, (bottom - kBelowRule_mm - from) / kLine_mm));
    };
    const size_t most = rowsIn(y + 2 * kLine_mm + kBelowRule_mm);
    const size_t half = rows.size() / 2 + 1;
    const bool isHalf = rows.size() > most && half < most && comesBack(rows);
    if (isHalf) {
      rows.resize(half);
    } else if (rows.size() > most) {
      rows = sumsOf(sequence);
      y = paper_.paragraph(x, y, yarnOrderText(sequence), kBody, width, 4) + 0.6;
    }
    y = tableHead(y, columns, {label, "", threads, "cm"}, end);
    const size_t room = std::max<size_t>(2, rowsIn(y));
    const size_t shown = rows.size() + 1 > room ? room - 2 : rows.size();
    for (size_t i = 0; i < shown; ++i, y += kLine_mm) {
      paper_.text(columns[0], y, yarnLetters(rows[i].yarn), kBody, 6);
      yarnSwatch(columns[1], y, rows[i].yarn);
      paper_.text(columns[2], y, fmt::format("{}", rows[i].width), kBody, 12);
      paper_.text(columns[3], y, cm(rows[i].width), kBody, end - columns[3]);
    }
    if (isHalf) {
      const auto named = [](const Stripe& stripe) {
        return fmt::format("{} {}", yarnLetters(stripe.yarn), stripe.width);
      };
      paper_.text(columns[0], y, fmt::format("back from {} to {}", named(rows[half - 2]), named(rows[0])), kQuiet,
                  width);
      y += kLine_mm;
    }
    if (shown < rows.size()) {
      paper_.text(columns[0], y, fmt::format("and {} more yarns", rows.size() - shown), kQuiet, width);
      y += kLine_mm;
    }
    paper_.line(x, y - kLine_mm + 1.2, end, y - kLine_mm + 1.2, 0.15);
    y += kBelowRule_mm;
    paper_.text(columns[0], y, "repeat", kQuiet, 14);
    paper_.text(columns[2], y, fmt::format("{}", sequence.size()), kBody, 12);
    paper_.text(columns[3], y, cm(static_cast<double>(sequence.size())), kBody, end - columns[3]);
  }

  void orders(double y, double bottom) {
    y = heading(kRight_mm, y, "Colour orders");
    constexpr double kApart_mm = 4, kTable_mm = 0.5 * (kColumn_mm - kApart_mm);
    orderTable(kRight_mm, y, kTable_mm, "Warp", "ends", fabric_.warpSequence, fabric_.warpPitch_mm(), bottom);
    orderTable(kRight_mm + kTable_mm + kApart_mm, y, kTable_mm, "Weft", "picks", fabric_.weftSequence,
               fabric_.weftPitch_mm(), bottom);
  }

  void yarns() {
    const double columns[] = {kSheetMargin_mm,      kSheetMargin_mm + 14,  kSheetMargin_mm + 66,
                              kSheetMargin_mm + 98, kSheetMargin_mm + 128, kSheetMargin_mm + 168};
    const auto head = [&] {
      y_ = heading(kSheetMargin_mm, y_, "Yarns");
      y_ = tableHead(y_, columns, {"", "Yarn", "Count", "Twist, turns/m", "Fibre", "kg / 100 m"}, kEnd_mm);
    };
    expectRoom(4 * kLine_mm);
    head();
    const auto needs =
        yarnNeed(fabric_, {100, options_.width_cm}, content_.measures.crimpWarp, content_.measures.crimpWeft);
    for (size_t i = 0; i < fabric_.yarns.size(); ++i) {
      if (y_ + kLine_mm > kBottom_mm) {
        expectRoom(2 * kLine_mm);
        head();
      }
      const Yarn& yarn = fabric_.yarns[i];
      const auto index = static_cast<int>(i);
      paper_.text(columns[0], y_, yarnLetters(index), kBody, 6);
      yarnSwatch(columns[0] + 7, y_, index);
      std::string fibre = fabric_.fibres[static_cast<size_t>(yarn.fibre)].name;
      if (yarn.blendFibre)
        fibre = fmt::format("{:.0f} % {}, {}", 100 * (1 - yarn.blendShare.value_or(0.5)), fibre,
                            fabric_.fibres[static_cast<size_t>(*yarn.blendFibre)].name);
      const std::string cells[] = {yarnName(fabric_, index, content_.coloursOfNames[i], options_.counts),
                                   writtenCount(yarn, meanFibre(yarn, fabric_.fibres), options_.counts), twistOf(yarn),
                                   fibre, fmt::format("{:.2f}", needs[i].mass_kg)};
      tableRow(columns, cells);
    }
    y_ += kBetween_mm;
  }

  /// As a spectrophotometer would read the cloth.
  void colours() {
    const double columns[] = {kSheetMargin_mm, kSheetMargin_mm + 14, kSheetMargin_mm + 66, kSheetMargin_mm + 108,
                              kSheetMargin_mm + 150};
    expectRoom((2.3 + static_cast<double>(content_.faces.size())) * kLine_mm);
    y_ = heading(kSheetMargin_mm, y_, "Colour of the face, CIELAB for 10 degrees");
    y_ = tableHead(y_, columns, {"", "Where it lies on top", "D65", "A", "moves by (CIEDE2000)"}, kEnd_mm);
    const auto text = [](const Lab& lab) {
      return fmt::format("L* {:.1f}  a* {:.1f}  b* {:.1f}", lab.L, lab.a, lab.b);
    };
    for (const FaceColour& face : content_.faces) {
      swatch(columns[0] + 7, y_, face.shown);
      const std::string cells[] = {face.name, text(face.daylight), text(face.bulb),
                                   fmt::format("{:.1f}", face.inconstancy)};
      tableRow(columns, cells);
    }
    y_ += kBetween_mm;
  }

  /// As a dyer reports it.
  void standards() {
    if (content_.matches.empty()) return;
    const double columns[] = {kSheetMargin_mm,      kSheetMargin_mm + 14,  kSheetMargin_mm + 50,
                              kSheetMargin_mm + 84, kSheetMargin_mm + 127, kSheetMargin_mm + 168};
    expectRoom(3.3 * kLine_mm);
    y_ = heading(kSheetMargin_mm, y_,
                 fmt::format("Beside its standard, tolerance {:g} CMC(2:1)", options_.tolerance_cmc));
    const std::initializer_list<const char*> heads = {
        "", "Where it lies on top", "Standard", "D65: CIEDE2000, CMC(2:1)", "A: the same", "metamerism"};
    y_ = tableHead(y_, columns, heads, kEnd_mm);
    const auto verdict = [&](const Judgement& judgement) {
      return fmt::format("{:.2f},  {:.2f}  {}", judgement.ciede2000, judgement.cmc,
                         judgement.passes(options_.tolerance_cmc) ? "pass" : "FAIL");
    };
    for (const StandardMatch& match : content_.matches) {
      expectRoom(kLine_mm);
      swatch(columns[0] + 2, y_, match.wanted);
      swatch(columns[0] + 7, y_, match.shown);
      const std::string cells[] = {match.partName, match.standard, verdict(match.daylight), verdict(match.bulb),
                                   fmt::format("{:.2f}", match.bulb.metamerism)};
      tableRow(columns, cells);
    }
    y_ += kBetween_mm;
  }

  void notes() {
    if (fabric_.description.empty()) return;
    constexpr int kMostLines = 4;
    expectRoom((1.3 + kMostLines) * kLine_mm);
    y_ = heading(kSheetMargin_mm, y_, "Notes");
    y_ = paper_.paragraph(kSheetMargin_mm, y_, fabric_.description, kBody, kEnd_mm - kSheetMargin_mm, kMostLines);
  }

  /// Along the lower edge; smaller before they need a page of their own.
  void colourways() {
    if (content_.colourways.empty()) return;
    constexpr double kBelow_mm = kLine_mm, kAbove_mm = kHeading.size_mm + 2, kSmallest_mm = 15;
    expectRoom(kAbove_mm + kSmallest_mm + kBelow_mm);
    const double side_mm = std::min(kSheetColourway_mm, kBottom_mm - kBelow_mm - kAbove_mm - y_);
    const double top = kBottom_mm - side_mm - kBelow_mm;
    heading(kSheetMargin_mm, top - 2, "Colourways");
    double x = kSheetMargin_mm;
    for (size_t i = 0; i < content_.colourways.size(); ++i, x += kSheetColourway_mm + 6) {
      paper_.picture(x, top, side_mm, side_mm, content_.colourways[i]);
      paper_.text(x, top + side_mm + 3, fabric_.colourways[i].name, kBody, kSheetColourway_mm + 4);
    }
  }

  Paper& paper_;
  const Fabric& fabric_;
  const ClothSheetOptions& options_;
  const ClothSheetContent& content_;
  const ClothStates states_;
  double y_ = 0;  ///< of the next line over the whole width
};

}  // namespace

double colourwaySide_mm(size_t pieces) {
  return pieces <= 4 ? 88 : pieces <= 6 ? 79 : 58;
}

void layOutColourways(Paper& paper, const std::string& title, const std::vector<NamedPiece>& pieces) {
  constexpr double kApart_mm = 5, kNames_mm = 6;
  const double side = colourwaySide_mm(pieces.size());
  const auto begin = [&] {
    const double y = titleLine(paper, title);
    paper.text(kSheetMargin_mm, y, "Colourways at 1 : 1", kQuiet);
    return y + kLine_mm;
  };
  double x = kSheetMargin_mm, y = begin();
  for (const NamedPiece& piece : pieces) {
    if (x + side > kEnd_mm + 0.5) {
      x = kSheetMargin_mm;
      y += side + kNames_mm;
    }
    if (y + side + kNames_mm > kBottom_mm) {
      paper.newPage();
      y = begin();
    }
    paper.picture(x, y, side, side, piece.picture);
    paper.text(x, y + side + 3.2, piece.name, kBody, side);
    x += side + kApart_mm;
  }
}

void layOutClothSheet(Paper& paper, const Fabric& fabric, const ClothSheetOptions& options,
                      const ClothSheetContent& content) {
  SheetWriter(paper, fabric, options, content).write();
}

}  // namespace loomlight
