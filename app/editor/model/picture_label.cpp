#include "app/editor/model/picture_label.h"

#include <fmt/core.h>
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "font_data.h"

namespace loomlight {
namespace {

constexpr uint8_t kBand = 118, kInk = 250;  // 18 % reflectance, as around the cloth on the screen

/// One line of text, drawn into pixels.
class TextLine {
 public:
  explicit TextLine(float height) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(kFontRegular.data());
    if (!stbtt_InitFont(&font_, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)))
      throw std::runtime_error("the built-in font cannot be read");
    scale_ = stbtt_ScaleForPixelHeight(&font_, height);
    int descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&font_, &ascent_, &descent, &gap);
  }

  float width(const std::u32string& text) const {
    float width = 0;
    for (const char32_t c : text) width += advance(c);
    return width;
  }

  void draw(Pixels8& pixels, const std::u32string& text, float x, float top) const {
    const float baseline = top + scale_ * static_cast<float>(ascent_);
    for (const char32_t c : text) {
      int width = 0, height = 0, left = 0, up = 0;
      unsigned char* const glyph = stbtt_GetCodepointBitmapSubpixel(&font_, scale_, scale_, x - std::floor(x), 0,
                                                                    static_cast<int>(c), &width, &height, &left, &up);
      for (int gy = 0; gy < height; ++gy)
        for (int gx = 0; gx < width; ++gx)
          blend(pixels, static_cast<int>(std::floor(x)) + left + gx, static_cast<int>(std::lround(baseline)) + up + gy,
                glyph[gy * width + gx]);
      stbtt_FreeBitmap(glyph, nullptr);
      x += advance(c);
    }
  }

 private:
  float advance(char32_t c) const {
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&font_, static_cast<int>(c), &advance, &bearing);
    return scale_ * static_cast<float>(advance);
  }
  static void blend(Pixels8& pixels, int x, int y, int coverage) {
    if (x < 0 || y < 0 || x >= pixels.width || y >= pixels.height) return;
    uint8_t* const p =
        &pixels.bytes[3 * (static_cast<size_t>(y) * static_cast<size_t>(pixels.width) + static_cast<size_t>(x))];
    for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(p[c] + (kInk - p[c]) * coverage / 255);
  }

  stbtt_fontinfo font_{};
  float scale_ = 1;
  int ascent_ = 0;
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

std::u32string fitted(const TextLine& line, std::u32string text, float room) {
  if (line.width(text) <= room) return text;
  while (!text.empty() && line.width(text + U"\u2026") > room) text.pop_back();
  return text.empty() ? text : text + U"\u2026";
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
  const TextLine line(static_cast<float>(text));
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
