#include "app/export/sheet/draft_sheet.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <new>

#include "app/export/sheet/cairo_output.h"
#include "app/export/sheet/pdf_profile.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/base/text.h"
#include "core/fabric/weave/draft_edit.h"
#include "core/fabric/yarn/derived.h"
#include "render/transport/reached_colours.h"

namespace loomlight {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Canvas = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr const char* kWhat = "the draft";  ///< is drawn: for messages

/// Lengths in the unit of the surface: points of a page, or pixels.
struct SheetSize {
  double width = 0, height = 0, margin = 0;
  double cell = 0;   ///< of a shaft and a treadle, and the shorter side of a crossing
  double title = 0;  ///< height of the line above, font included
  double hairline = 0;
};

/// A part of the repeat: what one page shows.
struct Window {
  int firstEnd = 0, ends = 0, firstPick = 0, picks = 0;
};

/// The draft and how it is laid out on any page: bars of colour, threading and treadling beside the drawdown.
class Sheet {
 public:
  Sheet(const Fabric& fabric, std::span<const Rgb> yarnColours, const DraftCorner& corner)
      : fabric_(fabric), yarnColours_(yarnColours), corner_(corner), shape_(crossingShape(fabric)) {
    // What nobody could thread is drawn without a threading.
    constexpr LoomLimits kLoom{64, 64};
    draft_ = fabric.draft ? fabric.draft : deriveDraft(fabric.weave, kLoom).draft;
    if (draft_ && draft_->shafts > kMostShafts) draft_.reset();
  }

  /// Cells above and beside the drawdown: threading and treadling with a gap, and a bar of colours.
  double above() const { return 2 + (draft_ ? draft_->shafts + 1 : 0); }
  double beside() const { return 2 + columns() + (columns() > 0 ? 1 : 0); }
  /// Cells that so many ends or picks take with what stands beside them.
  double across(int ends) const { return beside() + ends * shape_.width; }
  double down(int picks) const { return above() + picks * shape_.height; }
  /// How many ends or picks such a length of cells has room for.
  int endsWithin(double cells) const { return static_cast<int>((cells - beside()) / shape_.width); }
  int picksWithin(double cells) const { return static_cast<int>((cells - above()) / shape_.height); }

  /// Cells of so many pixels: all crossings get alike.
  void roundToPixels(double cell) {
    shape_.width = std::round(shape_.width * cell) / cell;
    shape_.height = std::round(shape_.height * cell) / cell;
  }

  /// What it is, in numbers.
  std::string figures(const Window& window) const {
    const Weave& weave = fabric_.weave;
    std::string text = fmt::format("{} ends x {} picks", weave.ends(), weave.picks());
    if (draft_)
      text += draft_->liftplan.empty() ? fmt::format(", {} shafts, {} treadles", draft_->shafts, draft_->treadles)
                                       : fmt::format(", {} shafts, liftplan", draft_->shafts);
    text += fmt::format(", {:.4g} x {:.4g} per cm", fabric_.ends_per_cm, fabric_.picks_per_cm);
    if (window.ends < weave.ends() || window.picks < weave.picks())
      text += fmt::format("   ends {} to {}, picks {} to {}", window.firstEnd + 1, window.firstEnd + window.ends,
                          window.firstPick + 1, window.firstPick + window.picks);
    return text;
  }

  void draw(cairo_t* canvas, const SheetSize& size, const Window& window) const {
    cairo_set_source_rgb(canvas, 1, 1, 1);
    cairo_paint(canvas);
    cairo_set_source_rgb(canvas, 0, 0, 0);
    cairo_select_font_face(canvas, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(canvas, 0.5 * size.title);
    cairo_move_to(canvas, size.margin, size.margin + 0.5 * size.title);
    cairo_show_text(canvas, (fabric_.name + "   " + figures(window)).c_str());
    cairo_translate(canvas, size.margin, size.margin + size.title);
    cairo_scale(canvas, size.cell, size.cell);
    drawParts(canvas, size, window);
  }

  /// With lengths in cells.
  void drawParts(cairo_t* canvas, const SheetSize& size, const Window& w) const {
    for (int end = w.firstEnd; end < w.firstEnd + w.ends; ++end) {
      setYarn(canvas, fabric_.warpYarn(end));
      fillCells(canvas, [&] { cairo_rectangle(canvas, xOf(w, end), 0, shape_.width, 1); });
    }
    for (int pick = w.firstPick; pick < w.firstPick + w.picks; ++pick) {
      setYarn(canvas, fabric_.weftYarn(pick));
      fillCells(canvas, [&] { cairo_rectangle(canvas, 0, yOf(w, pick), 1, shape_.height); });
    }
    drawCrossings(canvas, w);
    constexpr int kMostLines = 2000;  // beyond, they would be all that is seen
    const bool ruled = w.ends + w.picks <= kMostLines;
    if (ruled) drawGrid(canvas, size, {2, above(), w.ends, w.picks, shape_});
    if (draft_) drawDraft(canvas, size, w, *draft_);
  }

 private:
  static constexpr int kMostShafts = 128;
  static constexpr double kInk = 0.1;

  int columns() const { return !draft_ ? 0 : draft_->liftplan.empty() ? draft_->treadles : draft_->shafts; }

  double xOf(const Window& w, int end) const {
    const int i = end - w.firstEnd;
    return 2 + (corner_.right ? w.ends - 1 - i : i) * shape_.width;
  }
  double yOf(const Window& w, int pick) const {
    const int i = pick - w.firstPick;
    return above() + (corner_.top ? i : w.picks - 1 - i) * shape_.height;
  }

  void setYarn(cairo_t* canvas, int yarn) const {
    const Rgb display = clippedSrgbFromLinear(yarnColours_[static_cast<size_t>(yarn)]);
    cairo_set_source_rgb(canvas, display.x, display.y, display.z);
  }

  /// All cells of one colour in one path: pages of thousands of crossings stay small.
  void fillCells(cairo_t* canvas, const std::function<void()>& addCells) const {
    addCells();
    cairo_fill(canvas);
  }

  struct Grid {
    double x = 0, y = 0;
    int across = 0, down = 0;
    CrossingShape square;
  };
  void drawGrid(cairo_t* canvas, const SheetSize& size, const Grid& grid) const {
    const double right = grid.x + grid.across * grid.square.width, below = grid.y + grid.down * grid.square.height;
    const auto lineWidth = [&](int i) { return std::max(i % 4 == 0 ? 0.08 : 0.03, size.hairline / size.cell); };
    const auto setGrey = [canvas](int i) {
      const double grey = i % 4 == 0 ? 0.45 : 0.75;
      cairo_set_source_rgb(canvas, grey, grey, grey);
    };
    for (int i = 0; i <= grid.across; ++i) {
      setGrey(i);
      cairo_set_line_width(canvas, lineWidth(i));
      cairo_move_to(canvas, grid.x + i * grid.square.width, grid.y);
      cairo_line_to(canvas, grid.x + i * grid.square.width, below);
      cairo_stroke(canvas);
    }
    for (int i = 0; i <= grid.down; ++i) {
      setGrey(i);
      cairo_set_line_width(canvas, lineWidth(i));
      cairo_move_to(canvas, grid.x, grid.y + i * grid.square.height);
      cairo_line_to(canvas, right, grid.y + i * grid.square.height);
      cairo_stroke(canvas);
    }
  }

  /// Squares that print sharply; of a large jacquard a picture, which takes a thousandth of their room.
  void drawCrossings(cairo_t* canvas, const Window& w) const {
    constexpr int64_t kMostSquares = 200'000;
    if (int64_t{w.ends} * w.picks > kMostSquares) return drawCrossingsAsPicture(canvas, w);
    cairo_set_source_rgb(canvas, kInk, kInk, kInk);
    fillCells(canvas, [&] {
      for (int pick = w.firstPick; pick < w.firstPick + w.picks; ++pick)
        for (int end = w.firstEnd; end < w.firstEnd + w.ends; ++end)
          if (fabric_.weave.at(pick, end))
            cairo_rectangle(canvas, xOf(w, end), yOf(w, pick), shape_.width, shape_.height);
    });
  }

  void drawCrossingsAsPicture(cairo_t* canvas, const Window& w) const {
    const Surface picture(cairo_image_surface_create(CAIRO_FORMAT_A8, w.ends, w.picks), cairo_surface_destroy);
    if (cairo_surface_status(picture.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
    unsigned char* const pixels = cairo_image_surface_get_data(picture.get());
    const int stride = cairo_image_surface_get_stride(picture.get());
    for (int pick = w.firstPick; pick < w.firstPick + w.picks; ++pick)
      for (int end = w.firstEnd; end < w.firstEnd + w.ends; ++end) {
        const auto x = std::lround((xOf(w, end) - 2) / shape_.width);
        const auto y = std::lround((yOf(w, pick) - above()) / shape_.height);
        pixels[static_cast<ptrdiff_t>(y) * stride + x] = fabric_.weave.at(pick, end) ? 255 : 0;
      }
    cairo_surface_mark_dirty(picture.get());
    cairo_set_source_rgb(canvas, kInk, kInk, kInk);
    cairo_save(canvas);
    cairo_translate(canvas, 2, above());
    cairo_scale(canvas, shape_.width, shape_.height);
    cairo_mask_surface(canvas, picture.get(), 0, 0);
    cairo_restore(canvas);
  }

  void drawDraft(cairo_t* canvas, const SheetSize& size, const Window& w, const Draft& draft) const {
    const double top = 2, right = 2 + w.ends * shape_.width + 1;
    const double shafts = draft.shafts;
    cairo_set_source_rgb(canvas, kInk, kInk, kInk);
    fillCells(canvas, [&] {
      for (int end = w.firstEnd; end < w.firstEnd + w.ends; ++end)
        for (const int shaft : draft.threading[static_cast<size_t>(end)])
          if (shaft >= 1) cairo_rectangle(canvas, xOf(w, end), top + shafts - shaft, shape_.width, 1);
    });
    const auto& across = draft.liftplan.empty() ? draft.treadling : draft.liftplan;
    fillCells(canvas, [&] {
      for (int pick = w.firstPick; pick < w.firstPick + w.picks; ++pick)
        for (const int number : across[static_cast<size_t>(pick)])
          if (number >= 1) cairo_rectangle(canvas, right + number - 1, yOf(w, pick), 1, shape_.height);
    });
    drawGrid(canvas, size, {2, top, w.ends, draft.shafts, {shape_.width, 1}});
    drawGrid(canvas, size, {right, above(), columns(), w.picks, {1, shape_.height}});
    if (!draft.liftplan.empty()) return;
    cairo_set_source_rgb(canvas, kInk, kInk, kInk);
    fillCells(canvas, [&] {
      for (size_t treadle = 0; treadle < draft.tieUp.size(); ++treadle)
        for (const int shaft : draft.tieUp[treadle])
          if (shaft >= 1) cairo_rectangle(canvas, right + static_cast<double>(treadle), top + shafts - shaft, 1, 1);
    });
    drawGrid(canvas, size, {right, top, draft.treadles, draft.shafts, {}});
  }

  const Fabric& fabric_;
  std::span<const Rgb> yarnColours_;
  DraftCorner corner_;
  CrossingShape shape_;
  std::optional<Draft> draft_;
};

/// The windows of a repeat of which each is at most so large.
std::vector<Window> windowsOf(const Weave& weave, int mostEnds, int mostPicks) {
  std::vector<Window> windows;
  for (int pick = 0; pick < weave.picks(); pick += mostPicks)
    for (int end = 0; end < weave.ends(); end += mostEnds)
      windows.push_back({end, std::min(mostEnds, weave.ends() - end), pick, std::min(mostPicks, weave.picks() - pick)});
  return windows;
}

std::string pdfOf(const Sheet& sheet, const Weave& weave, const std::string& file) {
  constexpr double kLargestCell = 5 * kPointsPerMm, kLegibleCell = 1.6 * kPointsPerMm;
  constexpr size_t kMostPages = 40;
  SheetSize size{210 * kPointsPerMm, 297 * kPointsPerMm, 12 * kPointsPerMm, 0, 10 * kPointsPerMm, 0.15};
  if (sheet.across(weave.ends()) > sheet.down(weave.picks())) std::swap(size.width, size.height);
  const double roomX = size.width - 2 * size.margin, roomY = size.height - 2 * size.margin - size.title;
  const double whole = std::min(roomX / sheet.across(weave.ends()), roomY / sheet.down(weave.picks()));
  size.cell = std::min(whole, kLargestCell);
  std::vector<Window> windows{{0, weave.ends(), 0, weave.picks()}};
  const int ends = sheet.endsWithin(roomX / kLegibleCell), picks = sheet.picksWithin(roomY / kLegibleCell);
  if (whole < kLegibleCell && ends >= 8 && picks >= 8) {
    const std::vector<Window> pages = windowsOf(weave, ends, picks);
    if (pages.size() <= kMostPages) {
      windows = pages;
      size.cell = kLegibleCell;
    }
  }
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(appendTo, &bytes, size.width, size.height),
                        cairo_surface_destroy);
  for (const Window& window : windows) {
    const Canvas canvas(cairo_create(surface.get()), cairo_destroy);
    sheet.draw(canvas.get(), size, window);
    expectDrawn(cairo_status(canvas.get()), file, kWhat);
    cairo_surface_show_page(surface.get());
  }
  cairo_surface_finish(surface.get());
  expectDrawn(cairo_surface_status(surface.get()), file, kWhat);
  return withSrgbProfile(bytes);
}

Pixels8 pictureOf(Sheet sheet, const Weave& weave, const std::string& file) {
  constexpr double kLargestSide = 8192, kLargestCell = 16;
  SheetSize size;
  size.margin = 16;
  size.title = 28;
  size.hairline = 1;
  const double longest = std::max(sheet.across(weave.ends()), sheet.down(weave.picks()));
  const double cell = (kLargestSide - size.title - 2 * size.margin) / longest;
  size.cell = cell >= 1 ? std::min(std::floor(cell), kLargestCell) : cell;
  if (cell >= 1) sheet.roundToPixels(size.cell);
  constexpr double kTitleWidth = 720;
  size.width = std::ceil(std::max(sheet.across(weave.ends()) * size.cell, kTitleWidth) + 2 * size.margin);
  size.height = std::ceil(sheet.down(weave.picks()) * size.cell + 2 * size.margin + size.title);
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width), static_cast<int>(size.height)),
      cairo_surface_destroy);
  const Canvas canvas(cairo_create(surface.get()), cairo_destroy);
  cairo_set_antialias(canvas.get(), size.cell >= 1 ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_DEFAULT);
  sheet.draw(canvas.get(), size, {0, weave.ends(), 0, weave.picks()});
  expectDrawn(cairo_status(canvas.get()), file, kWhat);
  return pixelsOf(surface.get());
}

}  // namespace

std::string drawDraft(cairo_t* canvas, const Fabric& fabric, std::span<const Rgb> yarnColours,
                      const DraftCorner& corner, double width, double height) {
  constexpr double kLargestCell = 4 * kPointsPerMm, kLegibleCell = 1.2 * kPointsPerMm;
  const Sheet sheet(fabric, yarnColours, corner);
  const Weave& weave = fabric.weave;
  SheetSize size{width, height, 0, 0, 0, 0.15};
  const double whole = std::min(width / sheet.across(weave.ends()), height / sheet.down(weave.picks()));
  size.cell = std::clamp(whole, kLegibleCell, kLargestCell);
  const int ends = sheet.endsWithin(width / size.cell), picks = sheet.picksWithin(height / size.cell);
  // A loom that leaves no room for the cloth is drawn as a whole, however small.
  constexpr int kFewest = 8;
  if (ends < std::min(kFewest, weave.ends()) || picks < std::min(kFewest, weave.picks())) size.cell = whole;
  const bool all = size.cell == whole || (ends >= weave.ends() && picks >= weave.picks());
  const Window window{0, all ? weave.ends() : std::min(ends, weave.ends()), 0,
                      all ? weave.picks() : std::min(picks, weave.picks())};
  cairo_scale(canvas, size.cell, size.cell);
  sheet.drawParts(canvas, size, window);
  return sheet.figures(window);
}

bool writeDraftSheet(const std::string& file, const Fabric& fabric, const DraftCorner& corner, const Task& task) {
  const std::string extension = lowerExtension(file);
  if (extension != ".pdf" && extension != ".png")
    throw InputError(fmt::format("{}: expected the name of a draft that ends in .pdf or .png", file));
  expectWritable(file);
  const auto colours = reachedColours(fabric, task);
  if (!colours) return false;
  const Sheet sheet(fabric, *colours, corner);
  if (extension == ".pdf")
    writeFileAtomically(file, pdfOf(sheet, fabric.weave, file));
  else
    writePng(file, pictureOf(sheet, fabric.weave, file));
  return true;
}

}  // namespace loomlight
