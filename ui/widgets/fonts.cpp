#include "ui/widgets/fonts.h"

#include <algorithm>
#include <cmath>

#include "font_data.h"

namespace loomlight {
namespace {

/// Latin, Greek, and the symbols that units and keys are written with.
constexpr ImWchar kRanges[] = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2010, 0x2027, 0x2030, 0x2033, 0x2070, 0x209F, 0x2190,
                               0x2193, 0x21E7, 0x21E7, 0x2212, 0x2212, 0x221E, 0x221E, 0x2248, 0x2248, 0x2260, 0x2265,
                               0x25A0, 0x25A1, 0x25B2, 0x25BF, 0x25CF, 0x25CF, 0x2713, 0x2713, 0};

ImFont* add(ImFontAtlas& atlas, std::string_view bytes, float size) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 3;
  config.OversampleV = 2;
  config.PixelSnapH = false;
  // The atlas only reads the bytes; its interface predates const.
  return atlas.AddFontFromMemoryTTF(const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()), std::round(size),
                                    &config, kRanges);
}

/// The rasteriser knows no OpenType features, so the tabular figures are made here: digits centred in equal advances.
void makeDigitsTabular(ImFont& font) {
  float widest = 0;
  for (ImWchar digit = '0'; digit <= '9'; ++digit)
    if (const ImFontGlyph* glyph = font.FindGlyphNoFallback(digit)) widest = std::max(widest, glyph->AdvanceX);
  widest = std::round(widest);
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
    const float shift = 0.5f * (widest - glyph.AdvanceX);
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = widest;
  }
  font.BuildLookupTable();
}

}  // namespace

Fonts loadFonts(ImFontAtlas& atlas, float scale) {
  atlas.Clear();
  Fonts fonts;
  // By the height of their lines, which is 1.21 times the size of the type: 14 and 12 px.
  fonts.regular = add(atlas, kFontRegular, 17.0f * scale);
  fonts.strong = add(atlas, kFontStrong, 17.0f * scale);
  fonts.small = add(atlas, kFontRegular, 15.0f * scale);
  atlas.Build();
  for (ImFont* font : atlas.Fonts) makeDigitsTabular(*font);
  return fonts;
}

}  // namespace loomlight
