#include "ui/widgets/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace loomlight {
namespace {

/// Relative luminance of an opaque sRGB colour, WCAG 2.1.
double luminance(const ImVec4& c) {
  const auto linear = [](double s) { return s <= 0.03928 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

struct Colour {
  std::string name;
  ImVec4 value;
};

/// WCAG 2.1, success criterion 1.4.3: text that is not large.
void expectReadable(const std::string& theme, const std::vector<Colour>& texts, const std::vector<Colour>& grounds) {
  for (const Colour& text : texts)
    for (const Colour& ground : grounds)
      EXPECT_GE(contrast(text.value, ground.value), 4.5) << theme << ": " << text.name << " on " << ground.name;
}

void expectReadable(const std::string& name, const Theme& t) {
  const std::vector<Colour> grounds{{"panel", t.panel},
                                    {"popup", t.popup},
                                    {"field", t.field},
                                    {"fieldHover", t.fieldHover},
                                    {"fieldFill", t.fieldFill}};
  expectReadable(name, {{"text", t.text}, {"textQuiet", t.textQuiet}}, grounds);
  expectReadable(name, {{"warning", t.warning}, {"error", t.error}}, {{"panel", t.panel}, {"popup", t.popup}});
  expectReadable(name, {{"onAccent", t.onAccent}}, {{"accent", t.accent}});
  expectReadable(name, {{"ink", t.ink}}, {{"paper", t.paper}});
}

TEST(Theme, WordsAreReadableOnWhateverTheyStand) {
  expectReadable("dark", Theme::dark());
  expectReadable("light", Theme::light());
}

/// WCAG 2.1, success criterion 1.4.11: what tells a control's state.
TEST(Theme, WhatIsSelectedStandsOut) {
  for (const Theme& t : {Theme::dark(), Theme::light()})
    for (const ImVec4& ground : {t.panel, t.field}) EXPECT_GE(contrast(t.accent, ground), 3.0);
}

TEST(Theme, TheSurroundReflects18Percent) {
  for (const Theme& t : {Theme::dark(), Theme::light()}) EXPECT_NEAR(luminance(t.surround), 0.18, 0.005);
}

}  // namespace
}  // namespace loomlight
