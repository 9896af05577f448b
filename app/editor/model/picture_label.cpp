#include "app/editor/model/picture_label.h"

#include <fmt/core.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "font_data.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace {

constexpr uint8_t kBand = 118, kInk = 250;  // 18 % reflectance, as around the cloth on the screen

/// One line of text, drawn into pixels.
class TextLine {
 public:
  /// `height` in pixels, from the highest ascent to the lowest descent.
  explicit TextLine(int height) {
    const auto* bytes = reinterpret_cast<const FT_Byte*>(kFontRegular.data());
    FT_Size_RequestRec size{FT_SIZE_REQUEST_TYPE_REAL_DIM, 0, height * 64L, 0, 0};
    if (FT_Init_FreeType(&library_) != 0 ||
        FT_New_Memory_Face(library_, bytes, static_cast<FT_Long>(kFontRegular.size()), 0, &face_) != 0 ||
        FT_Request_Size(face_, &size) != 0) {
      FT_Done_FreeType(library_);
      throw std::runtime_error(words::errors::font);
    }
  }
  ~TextLine() { FT_Done_FreeType(library_); }  // and with it the face
  TextLine(const TextLine&) = delete;
  TextLine& operator=(const TextLine&) = delete;

  float width(const std::u32string& text) const {
    float width = 0;
    for (const char32_t c : text)
      if (load(c)) width += advance();
    return width;
  }

  void draw(Pixels8& pixels, const std::u32string& text, float x, float top) const {
    const int baseline = static_cast<int>(std::lround(top + static_cast<float>(face_->size->metrics.ascender) / 64));
    for (const char32_t c : text) {
      if (!load(c)) continue;
      FT_GlyphSlot glyph = face_->glyph;
      const float next = x + advance(), whole = std::floor(x);
      FT_Outline_Translate(&glyph->outline, std::lround(64 * (x - whole)), 0);
      x = next;
      if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL) != 0) continue;
      const FT_Bitmap& bitmap = glyph->bitmap;
      for (int gy = 0; gy < static_cast<int>(bitmap.rows); ++gy)
        for (int gx = 0; gx < static_cast<int>(bitmap.width); ++gx)
          blend(pixels, static_cast<int>(whole) + glyph->bitmap_left + gx, baseline - glyph->bitmap_top + gy,
                bitmap.buffer[gy * bitmap.pitch + gx]);
    }
  }

 private:
  bool load(char32_t c) const { return FT_Load_Char(face_, c, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) == 0; }
  float advance() const { return static_cast<float>(face_->glyph->linearHoriAdvance) / 65536; }
  static void blend(Pixels8& pixels, int x, int y, int coverage) {
    if (x < 0 || y < 0 || x >= pixels.width || y >= pixels.height) return;
    uint8_t* const p =
        &pixels.bytes[3 * (static_cast<size_t>(y) * static_cast<size_t>(pixels.width) + static_cast<size_t>(x))];
    for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(p[c] + (kInk - p[c]) * coverage / 255);
  }

  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// UTF-8; what is none is left out.
std::u32string decoded(const std::string& text) {
  std::u32string codes;
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
    if (length == 0 || i + static_cast<size_t>(length) > text.size()) {
      ++i;
      continue;
    }
    char32_t code = length == 1 ? lead : lead & (0xFF >> (length + 1));
    for (int k = 1; k < length; ++k) code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
    if (code >= 32) codes += code;
    i += static_cast<size_t>(length);
  }
  return codes;
}

/// As much of the text as has room, and an ellipsis in the place of the rest.
std::u32string fitted(const TextLine& line, const std::u32string& text, float room) {
  if (line.width(text) <= room) return text;
  const std::u32string ellipsis = U"\u2026";
  float left = room - line.width(ellipsis);
  size_t kept = 0;
  while (kept < text.size() && (left -= line.width(text.substr(kept, 1))) >= 0) ++kept;
  return kept == 0 ? U"" : text.substr(0, kept) + ellipsis;
}

void fill(Pixels8& pixels, int left, int top, int right, int bottom, uint8_t value) {
  for (int y = std::max(top, 0); y < std::min(bottom, pixels.height); ++y)
    for (int x = std::max(left, 0); x < std::min(right, pixels.width); ++x)
      for (size_t c = 0; c < 3; ++c)
        pixels.bytes[3 * (static_cast<size_t>(y) * static_cast<size_t>(pixels.width) + static_cast<size_t>(x)) + c] =
            value;
}

std::string lengthText(double mm) {
  if (mm >= 10) return fmt::format("{:g} cm", mm / 10);
  if (mm >= 0.1) return fmt::format("{:g} mm", mm);
  return fmt::format("{:g} \u00B5m", 1000 * mm);
}

}  // namespace

double roundLength(double longest) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest)));
  const double digits = longest / decade;
  return decade * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

Pixels8 labelled(const Pixels8& picture, const PictureLabel& label, double mm_per_pixel) {
  assert(picture.channels == 3 && mm_per_pixel > 0);
  if (label.isEmpty()) return picture;
  const int text = std::max(10, picture.height / 40), pad = text / 2, band = text + 2 * pad;
  Pixels8 whole{picture.width, picture.height + band, 3, picture.bytes};
  whole.bytes.resize(3 * static_cast<size_t>(whole.width) * static_cast<size_t>(whole.height), kBand);
  const TextLine line(text);
  const auto top = static_cast<float>(picture.height + pad);
  auto left = static_cast<float>(pad);
  if (label.scaleBar) {
    const double length_mm = roundLength(0.2 * picture.width * mm_per_pixel);
    const int right = pad + std::max(1, static_cast<int>(std::lround(length_mm / mm_per_pixel)));
    const int middle = picture.height + band / 2, thick = std::max(1, text / 6), tick = std::max(2, text / 3);
    fill(whole, pad, middle - thick / 2, right, middle - thick / 2 + thick, kInk);
    fill(whole, pad, middle - tick, pad + thick, middle + tick, kInk);
    fill(whole, right - thick, middle - tick, right, middle + tick, kInk);
    const std::u32string length = decoded(lengthText(length_mm));
    line.draw(whole, length, static_cast<float>(right + pad), top);
    left = static_cast<float>(right + 3 * pad) + line.width(length);
  }
  const float room = static_cast<float>(picture.width - pad) - left;
  const std::u32string caption = fitted(line, decoded(label.caption), room);
  line.draw(whole, caption, static_cast<float>(picture.width - pad) - line.width(caption), top);
  return whole;
}

}  // namespace loomlight
