#include "app/export/sheet/paper.h"

#include <cairo-pdf.h>

#include <memory>
#include <sstream>

#include "app/export/sheet/cairo_output.h"
#include "app/export/sheet/pdf_profile.h"
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/base/utf8.h"

namespace loomlight {
namespace {

void choose(cairo_t* canvas, const Paper::Font& font) {
  cairo_select_font_face(canvas, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(canvas, font.size_mm);
  cairo_set_source_rgb(canvas, font.grey, font.grey, font.grey);
}

}  // namespace

Paper::Paper(double width_mm, double height_mm, double pixels_per_mm)
    : width_mm_(width_mm), height_mm_(height_mm), pixels_per_mm_(pixels_per_mm), isPdf_(pixels_per_mm <= 0) {
  if (isPdf_)
    surface_ =
        cairo_pdf_surface_create_for_stream(appendTo, &bytes_, width_mm * kPointsPerMm, height_mm * kPointsPerMm);
  begin();
}

/// A white page, with a millimetre as the unit.
void Paper::begin() {
  if (!isPdf_)
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width_mm_ * pixels_per_mm_),
                                          static_cast<int>(height_mm_ * pixels_per_mm_));
  canvas_ = cairo_create(surface_);
  const double unit = isPdf_ ? kPointsPerMm : pixels_per_mm_;
  cairo_scale(canvas_, unit, unit);
  if (isPdf_) return;
  cairo_set_source_rgb(canvas_, 1, 1, 1);
  cairo_paint(canvas_);
}

void Paper::newPage() {
  ++page_;
  if (isPdf_) {
    cairo_show_page(canvas_);
    return;
  }
  cairo_destroy(canvas_);
  full_.push_back(surface_);
  begin();
}

Paper::~Paper() {
  cairo_destroy(canvas_);
  cairo_surface_destroy(surface_);
  for (cairo_surface_t* const page : full_) cairo_surface_destroy(page);
}

double Paper::width(const std::string& text, const Font& font) {
  choose(canvas_, font);
  cairo_text_extents_t extents;
  cairo_text_extents(canvas_, text.c_str(), &extents);
  return extents.x_advance;
}

double Paper::text(double x, double y, const std::string& text, const Font& font, double room_mm) {
  constexpr size_t kMostBytes = 2000;  // more than fit on a page, so that long texts are soon cut
  std::string shown(room_mm > 0 ? wholeCharacters(text, kMostBytes) : text);
  if (room_mm > 0 && width(shown, font) > room_mm) {
    const std::string ellipsis = "\xE2\x80\xA6";
    while (!shown.empty() && width(shown + ellipsis, font) > room_mm) {
      while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0) == 0x80) shown.pop_back();
      if (!shown.empty()) shown.pop_back();
    }
    shown += ellipsis;
  }
  choose(canvas_, font);
  cairo_move_to(canvas_, x, y);
  cairo_text_extents_t ink;
  cairo_text_extents(canvas_, shown.c_str(), &ink);
  boxes_.push_back({page_, x + ink.x_bearing, y + ink.y_bearing, ink.width, ink.height, shown});
  cairo_show_text(canvas_, shown.c_str());
  return x + width(shown, font);
}

double Paper::paragraph(double x, double y, const std::string& text, const Font& font, double room_mm, int mostLines) {
  std::istringstream words(text);
  std::string line, word;
  const double step = 1.3 * font.size_mm;
  int lines = 0;
  while (lines < mostLines && words >> word) {
    std::string longer = line;
    if (!line.empty()) longer += ' ';
    longer += word;
    if (line.empty() || width(longer, font) <= room_mm) {
      line = longer;
      continue;
    }
    if (lines + 1 == mostLines) {
      line = longer;  // cut off below
      break;
    }
    this->text(x, y + step * lines++, line, font, room_mm);
    line = word;
  }
  if (!line.empty()) this->text(x, y + step * lines++, line, font, room_mm);
  return y + step * lines;
}

void Paper::line(double x0, double y0, double x1, double y1, double width_mm, double grey) {
  cairo_set_source_rgb(canvas_, grey, grey, grey);
  cairo_set_line_width(canvas_, width_mm);
  cairo_move_to(canvas_, x0, y0);
  cairo_line_to(canvas_, x1, y1);
  cairo_stroke(canvas_);
}

void Paper::fill(double x, double y, double width, double height, const Rgb& srgb) {
  cairo_set_source_rgb(canvas_, srgb.r, srgb.g, srgb.b);
  cairo_rectangle(canvas_, x, y, width, height);
  cairo_fill(canvas_);
}

void Paper::picture(double x, double y, double width, double height, const Pixels8& pixels) {
  boxes_.push_back({page_, x, y, width, height, {}});
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height), cairo_surface_destroy);
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  unsigned char* const rows = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int row = 0; row < pixels.height; ++row) {
    auto* const out = reinterpret_cast<uint32_t*>(rows + static_cast<ptrdiff_t>(row) * stride);
    const uint8_t* in = &pixels.bytes[3 * static_cast<size_t>(row) * static_cast<size_t>(pixels.width)];
    for (int column = 0; column < pixels.width; ++column, in += 3)
      out[column] = static_cast<uint32_t>(in[0]) << 16 | static_cast<uint32_t>(in[1]) << 8 | in[2];
  }
  cairo_surface_mark_dirty(image.get());
  cairo_save(canvas_);
  cairo_translate(canvas_, x, y);
  cairo_scale(canvas_, width / pixels.width, height / pixels.height);
  cairo_set_source_surface(canvas_, image.get(), 0, 0);
  cairo_pattern_set_extend(cairo_get_source(canvas_), CAIRO_EXTEND_PAD);  // else it is mixed with paper at its edges
  cairo_rectangle(canvas_, 0, 0, pixels.width, pixels.height);
  cairo_fill(canvas_);
  cairo_restore(canvas_);
}

void Paper::draw(double x, double y, const std::function<void(cairo_t*)>& how) {
  cairo_save(canvas_);
  cairo_translate(canvas_, x, y);
  cairo_scale(canvas_, 1 / kPointsPerMm, 1 / kPointsPerMm);
  how(canvas_);
  cairo_restore(canvas_);
}

void Paper::write(const std::string& file) {
  if (isPdf_) {
    cairo_surface_show_page(surface_);
    cairo_surface_finish(surface_);
  }
  for (const cairo_status_t status : {cairo_status(canvas_), cairo_surface_status(surface_)})
    expectDrawn(status, file, "the sheet");
  if (isPdf_) {
    writeFileAtomically(file, withSrgbProfile(bytes_));
    return;
  }
  Pixels8 sheet = pixelsOf(full_.empty() ? surface_ : full_.front());
  for (size_t page = 1; page <= full_.size(); ++page) {
    const Pixels8 next = pixelsOf(page < full_.size() ? full_[page] : surface_);
    sheet.bytes.insert(sheet.bytes.end(), next.bytes.begin(), next.bytes.end());
    sheet.height += next.height;
  }
  writePng(file, sheet, {}, kMmPerInch * pixels_per_mm_);
}

}  // namespace loomlight
