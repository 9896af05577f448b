#include "app/editor/model/book_colours.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "core/fabric/yarn/band_colour.h"
#include "render/colour/colour_difference.h"
#include "render/colour/colour_space.h"
#include "render/colour/tristimulus.h"
#include "ui/words/file_words.h"

namespace loomlight {
namespace {

glm::dvec3 whiteOf(const std::string& illuminant, Observer observer) {
  try {
    return whiteXyz(tristimulusWeights(illuminantNamed(illuminant), observer));
  } catch (const InputError&) {
    return d65Xyz();  // of a light that nobody knows the colour stays as its numbers say
  }
}

Rgb linearOf(const WhiteLab& lab) {
  const glm::dvec3 white =
      whiteOf(lab.illuminant, lab.observer_degrees == 10 ? Observer::degrees10 : Observer::degrees2);
  return Rgb(linearUnder(white, {lab.L, lab.a, lab.b}));
}

/// Of a colour of three numbers no more is known than how it looks to the observer of displays.
WhiteLab labByDay(const NamedColour& colour, const Rgb& linear) {
  constexpr const char* kDaylight = "D65";
  constexpr int kTrade_degrees = 10, kDisplay_degrees = 2;
  if (colour.reflectance) {
    const Lab lab = labUnder(tristimulusWeights(illuminantNamed(kDaylight), Observer::degrees10), *colour.reflectance);
    return {lab.L, lab.a, lab.b, kDaylight, kTrade_degrees};
  }
  if (colour.lab && colour.lab->illuminant == kDaylight) return *colour.lab;
  const Lab lab = labFromLinear(glm::dvec3(linear));
  return {lab.L, lab.a, lab.b, kDaylight, kDisplay_degrees};
}

ColourFile colourFile(Palette palette) {
  std::vector<std::string> remarks = std::move(palette.remarks);
  return {std::nullopt, std::move(palette), std::move(remarks)};
}

/// Several measurements are a book.
ColourFile colourFile(SwatchFile file, const std::string& name) {
  if (file.swatches.size() == 1) return {std::move(file.swatches.front()), {}, std::move(file.remarks)};
  Palette palette = paletteOf(file);
  palette.name = std::filesystem::path(name).stem().string();
  return colourFile(std::move(palette));
}

}  // namespace

BookColour bookColour(const NamedColour& colour) {
  BookColour shown{colour.name, colour.linear, colour.reflectance, {}};
  if (colour.reflectance)
    shown.linear = linearFromReflectance(*colour.reflectance);
  else if (colour.lab)
    shown.linear = linearOf(*colour.lab);
  shown.lab = labByDay(colour, shown.linear);
  return shown;
}

ColourBook colourBook(const Palette& palette) {
  ColourBook book{palette.name, {}};
  for (const NamedColour& colour : palette.colours) {
    BookColour shown = bookColour(colour);
    if (shown.name.empty()) shown.name = fmt::format(words::files::unnamedColour, book.colours.size() + 1);
    book.colours.push_back(std::move(shown));
  }
  return book;
}

ColourFile readColourFile(const std::string& file) {
  if (!isSwatchFile(file)) return colourFile(readPalette(file));
  try {
    return colourFile(readSwatches(file), file);
  } catch (const InputError& asMeasurement) {
    // Its ending may be that of a table of codes too. Where it is neither, what is wrong with the measurement is said.
    if (!isPaletteFile(file)) throw;
    try {
      return colourFile(readPalette(file));
    } catch (const InputError&) {
      throw InputError(asMeasurement);
    }
  }
}

}  // namespace loomlight
