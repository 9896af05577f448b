#pragma once

#include <string>
#include <vector>

#include "app/export/sheet/cloth_sheet.h"
#include "app/export/sheet/face_colours.h"
#include "app/export/sheet/paper.h"
#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {

/// A4, upright.
inline constexpr double kSheetWidth_mm = 210, kSheetHeight_mm = 297, kSheetMargin_mm = 12;
/// Sides of the square pieces of cloth that are shown at 1 : 1.
inline constexpr double kSheetCloth_mm = 80, kSheetColourway_mm = 24;
/// As many colourways as stand side by side.
inline constexpr size_t kSheetColourways = 6;

/// What is found out of a cloth for its sheet.
struct ClothSheetContent {
  Pixels8 cloth;
  std::vector<Pixels8> colourways;  ///< of the first ones
  ClothMeasures measures;
  std::vector<FaceColour> faces;
  std::vector<StandardMatch> matches;
  std::vector<Rgb> yarnColours;     ///< that the cloth reaches, linear
  std::vector<Rgb> coloursOfNames;  ///< by which the yarns are called (coloursForNames())
};

/// Lays the sheet out: on one page where it fits, as it does with a dozen yarns; what is beyond goes on the next.
void layOutClothSheet(Paper& paper, const Fabric& fabric, const ClothSheetOptions& options,
                      const ClothSheetContent& content);

/// A piece of cloth and what is written below it.
struct NamedPiece {
  std::string name;
  Pixels8 picture;  ///< square
};
/// How large each of so many pieces is shown: two or three side by side, as large as a page has room for.
double colourwaySide_mm(size_t pieces);
/// In rows, on as many pages as they take.
void layOutColourways(Paper& paper, const std::string& title, const std::vector<NamedPiece>& pieces);

}  // namespace loomlight
