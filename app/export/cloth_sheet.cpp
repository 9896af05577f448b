#include "app/export/cloth_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/export/face_colours.h"
#include "app/export/paper.h"
#include "app/export/picture.h"
#include "app/export/whole_picture.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/base/text.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/weave/thread_order.h"
#include "core/fabric/weave/weave_code.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/yarn_name.h"
#include "core/fabric/yarn/yarn_need.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "core/geometry/cloth_geometry.h"

namespace loomlight {
namespace {

constexpr double kPage_mm[] = {210, 297}, kMargin_mm = 12, kColumn_mm = 90, kGap_mm = 6;
constexpr double kCloth_mm = kColumn_mm, kColourway_mm = 28;
constexpr double kLine_mm = 3.8;
constexpr Paper::Font kTitle{5.2, true}, kHeading{3.0, true}, kBody{2.6}, kQuiet{2.6, false, 0.4};
constexpr size_t kMostColourways = 6;

/// A square of the cloth, flat under a light booth, seen from straight above without perspective.
Fabric pieceOf(const Fabric& fabric, double side_mm, double pixels_per_mm, int samples) {
  constexpr double kAround_mm = 4;  // light comes through from the cloth around it
  Fabric piece = fabric;
  piece.drape = Drape{};
  piece.drape.width_mm = piece.drape.height_mm = side_mm + 2 * kAround_mm;
  piece.light = Light{};
  piece.light.kind = LightKind::booth;
  piece.camera = Camera{};
  piece.camera.elevation_deg = 90;
  piece.camera.fov_deg = 0;
  piece.camera.distance_mm = side_mm / (2 * std::tan(10 * kPi / 180));
  piece.render.width = piece.render.height = static_cast<int>(std::lround(side_mm * pixels_per_mm));
  piece.render.samplesPerPixel = samples;
  return piece;
}

/// What is traced for the page.
struct Pictures {
  Pixels8 cloth;
  std::vector<Pixels8> colourways;
  ClothMeasures measures;
  std::vector<FaceColour> faces;
};

std::optional<Pictures> tracedPictures(const Fabric& fabric, const ClothSheetOptions& options, const Task& task) {
  constexpr double kFine = 150 / 25.4, kCoarse = 100 / 25.4;  // pixels to the mm
  const size_t count = std::min(fabric.colourways.size(), kMostColourways);
  const double small = kColourway_mm * kCoarse, large = kCloth_mm * kFine;
  const double all = large * large + static_cast<double>(count) * small * small;
  Pictures pictures;
  double done = 0;
  const auto traced = [&](const Fabric& cloth, double side_mm, double pixels_per_mm) -> std::optional<WholePicture> {
    const auto piece = std::make_shared<const Fabric>(pieceOf(cloth, side_mm, pixels_per_mm, options.samplesPerPixel));
    const double share = std::pow(side_mm * pixels_per_mm, 2) / all;
    Task part = task;
    part.progress = [&task, done, share](double fraction) { task.report(done + share * fraction); };
    auto picture = renderWhole(piece, {options.memoryLimit_bytes, FibreExtent::automatic}, part);
    done += share;
    return picture;
  };
  const auto whole = traced(fabric, kCloth_mm, kFine);
  if (!whole) return std::nullopt;
  pictures.cloth = toPixels(whole->film, Tone{});
  pictures.measures = whole->scene->cloth->volume->geometry().measure();
  for (size_t i = 0; i < count; ++i) {
    const auto picture = traced(inColourway(fabric, fabric.colourways[i]), kColourway_mm, kCoarse);
    if (!picture) return std::nullopt;
    pictures.colourways.push_back(toPixels(picture->film, Tone{}));
  }
  Task quiet = task;
  quiet.progress = nullptr;  // it takes a moment
  auto faces = faceColours(fabric, quiet);
  if (!faces) return std::nullopt;
  pictures.faces = std::move(*faces);
  return pictures;
}

/// Writes one part of the page below the other.
class SheetWriter {
 public:
  SheetWriter(Paper& paper, const Fabric& fabric, const ClothSheetOptions& options, const Pictures& pictures)
      : paper_(paper), fabric_(fabric), options_(options), pictures_(pictures) {}

  void write() {
    const double left = kMargin_mm, right = kMargin_mm + kColumn_mm + kGap_mm;
    double y = kMargin_mm + kTitle.size_mm;
    paper_.text(left, y, fabric_.name, kTitle, kPage_mm[0] - 2 * kMargin_mm);
    y += 2;
    paper_.line(left, y, kPage_mm[0] - kMargin_mm, y, 0.3, 0.2);
    y += 4;
    const double belowCloth = cloth(left, y), belowDraft = draft(right, y);
    y = std::max(belowCloth, belowDraft) + 5;
    const double belowFigures = construction(left, y), belowOrders = orders(right, y);
    y = yarns(left, std::max(belowFigures, belowOrders) + 5) + 5;
    y = colours(left, y) + 5;
    y = notes(left, y);
    colourways(left);
  }

 private:
  double heading(double x, double y, const std::string& text) {
    paper_.text(x, y, text, kHeading);
    return y + kLine_mm + 0.6;
  }

  double row(double x, double y, const std::string& label, const std::string& value) {
    paper_.text(x, y, label, kQuiet);
    paper_.text(x + 32, y, value, kBody, kColumn_mm - 32);
    return y + kLine_mm;
  }

  double cloth(double x, double y) {
    paper_.picture(x, y, kCloth_mm, kCloth_mm, pictures_.cloth);
    y += kCloth_mm + 3;
    constexpr double kBar_mm = 50;  // to check that the page was not scaled in print
    paper_.line(x, y - 1, x + kBar_mm, y - 1, 0.3, 0.1);
    for (int i = 0; i <= 5; ++i) paper_.line(x + 10 * i, y - 2, x + 10 * i, y, 0.2, 0.1);
    paper_.text(x + kBar_mm + 2, y, "50 mm; cloth at 1 : 1", kQuiet);
    return y + kLine_mm;
  }

  double draft(double x, double y) {
    std::string said;
    constexpr double kPoints = 72 / 25.4;
    paper_.draw(x, y, [&](cairo_t* canvas) {
      said = drawDraft(canvas, fabric_, options_.corner, kColumn_mm * kPoints, kCloth_mm * kPoints);
    });
    paper_.text(x, y + kCloth_mm + 3, said, kQuiet, kColumn_mm);
    return y + kCloth_mm + 3 + kLine_mm;
  }

  double construction(double x, double y) {
    const ClothMeasures& m = pictures_.measures;
    const Weave& weave = fabric_.weave;
    const auto settOf = [](double ends, double picks) {
      return fmt::format("{:.1f} x {:.1f} per cm   ({:.0f} x {:.0f} per inch)", ends, picks, 2.54 * ends, 2.54 * picks);
    };
    y = heading(x, y, "Construction");
    y = row(x, y, "Sett, finished", settOf(fabric_.ends_per_cm, fabric_.picks_per_cm));
    // Cloth on the loom is stretched flat: the yarn that is crimped in the finished cloth lies straight there.
    y = row(x, y, "Sett, on the loom",
            settOf(fabric_.ends_per_cm / (1 + m.crimpWeft), fabric_.picks_per_cm / (1 + m.crimpWarp)));
    y = row(x, y, "Width",
            fmt::format("{:.0f} cm finished, {:.0f} cm in the reed", options_.width_cm,
                        options_.width_cm * (1 + m.crimpWeft)));
    y = row(x, y, "Ends", fmt::format("{:.0f}", options_.width_cm * fabric_.ends_per_cm));
    y = row(x, y, "Weave", isoWeaveCode(weave) ? "ISO 9354  " + *isoWeaveCode(weave) : "as drawn");
    y = row(x, y, "Weave repeat", repeat(weave.ends(), weave.picks()));
    y = row(x, y, "Pattern repeat", repeat(patternEnds(fabric_), patternPicks(fabric_)));
    y = row(x, y, "Mass",
            fmt::format("{:.0f} g/m\xC2\xB2   {:.0f} g per running metre", m.arealMass_g_m2,
                        m.arealMass_g_m2 * options_.width_cm / 100));
    y = row(x, y, "Thickness", fmt::format("{:.2f} mm", m.thickness_mm));
    y = row(x, y, "Crimp", fmt::format("warp {:.1f} %, weft {:.1f} %", 100 * m.crimpWarp, 100 * m.crimpWeft));
    const CoverFactors cover = coverFactors(fabric_);
    y = row(x, y, "Cover factor (Peirce)",
            fmt::format("warp {:.1f}, weft {:.1f}, cloth {:.1f}", cover.warp, cover.weft, cover.cloth));
    const Floats f = floats(weave);
    return row(x, y, "Longest float",
               fmt::format("warp {} ({:.1f} mm), weft {} ({:.1f} mm)", f.warp(),
                           floatLength_mm(fabric_, System::warp, f.warp()), f.weft(),
                           floatLength_mm(fabric_, System::weft, f.weft())));
  }

  std::string repeat(int64_t ends, int64_t picks) const {
    return fmt::format("{} x {} threads, {:.1f} x {:.1f} mm", ends, picks,
                       static_cast<double>(ends) * fabric_.warpPitch_mm(),
                       static_cast<double>(picks) * fabric_.weftPitch_mm());
  }

  /// An order as weavers write it, and below how many threads of each yarn it has.
  double order(double x, double y, const char* label, const std::vector<int>& sequence, double pitch_mm) {
    paper_.text(x, y, label, kQuiet);
    y = paper_.paragraph(x + 14, y, threadOrderText(sequence), kBody, kColumn_mm - 14, 5);
    std::map<int, int> counts;
    for (const int yarn : sequence) ++counts[yarn];
    std::string sums;
    for (const auto& [yarn, count] : counts) sums += fmt::format("{} {}   ", yarnLetters(yarn), count);
    paper_.text(x + 14, y,
                fmt::format("{}= {} threads, {:.1f} mm", sums, sequence.size(),
                            pitch_mm * static_cast<double>(sequence.size())),
                kQuiet, kColumn_mm - 14);
    return y + kLine_mm + 1;
  }

  double orders(double x, double y) {
    y = heading(x, y, "Colour orders");
    y = order(x, y, "Warp", fabric_.warpSequence, fabric_.warpPitch_mm());
    return order(x, y, "Weft", fabric_.weftSequence, fabric_.weftPitch_mm());
  }

  std::string twistOf(const Yarn& yarn) const {
    const auto turns = [](double per_m, TwistDirection way) {
      return fmt::format("{:.0f} {}", per_m, way == TwistDirection::z ? "Z" : "S");
    };
    std::string text = turns(yarn.plyTwist_per_m, yarn.plyTwistDirection);
    if (yarn.plies > 1) text += " / " + turns(yarn.yarnTwist_per_m, yarn.yarnTwistDirection);
    if (yarn.cords > 1) text += " / " + turns(yarn.cableTwist_per_m, yarn.cableTwistDirection);
    return text;
  }

  double yarns(double x, double y) {
    const double columns[] = {x, x + 12, x + 66, x + 98, x + 128, x + 166}, end = kPage_mm[0] - kMargin_mm;
    y = heading(x, y, "Yarns");
    const char* const heads[] = {"", "Yarn", "Count", "Twist, turns/m", "Fibre", "kg / 100 m"};
    for (size_t i = 0; i < std::size(heads); ++i) paper_.text(columns[i], y, heads[i], kQuiet);
    paper_.line(x, y + 1.2, end, y + 1.2, 0.15);
    y += kLine_mm + 0.6;
    const auto needs =
        yarnNeed(fabric_, {100, options_.width_cm}, pictures_.measures.crimpWarp, pictures_.measures.crimpWeft);
    constexpr size_t kMostYarns = 12;
    for (size_t i = 0; i < std::min(fabric_.yarns.size(), kMostYarns); ++i) {
      const Yarn& yarn = fabric_.yarns[i];
      const auto index = static_cast<int>(i);
      const Rgb colour = srgbFromLinear(glm::clamp(yarnReflectance(fabric_, yarn), Rgb(0.0f), Rgb(1.0f)));
      paper_.text(columns[0], y, yarnLetters(index), kBody);
      paper_.fill(columns[0] + 5, y - 2.4, 5, 2.8, colour);
      std::string fibre = fabric_.fibres[static_cast<size_t>(yarn.fibre)].name;
      if (yarn.blendFibre)
        fibre = fmt::format("{:.0f} % {}, {}", 100 * (1 - yarn.blendShare.value_or(0.5)), fibre,
                            fabric_.fibres[static_cast<size_t>(*yarn.blendFibre)].name);
      const std::string cells[] = {yarnName(fabric_, index, options_.counts),
                                   writtenCount(yarn, meanFibre(yarn, fabric_.fibres), options_.counts), twistOf(yarn),
                                   fibre, fmt::format("{:.2f}", needs[i].mass_kg)};
      for (size_t k = 0; k < std::size(cells); ++k)
        paper_.text(columns[k + 1], y, cells[k], kBody,
                    (k + 2 < std::size(columns) ? columns[k + 2] : end) - columns[k + 1] - 2);
      y += kLine_mm;
    }
    if (fabric_.yarns.size() > kMostYarns) {
      paper_.text(columns[1], y, fmt::format("and {} more", fabric_.yarns.size() - kMostYarns), kQuiet);
      y += kLine_mm;
    }
    return y;
  }

  /// As a spectrophotometer would read the cloth.
  double colours(double x, double y) {
    const double columns[] = {x, x + 12, x + 66, x + 108, x + 150};
    y = heading(x, y, "Colour of the face, CIELAB for 10 degrees");
    const char* const heads[] = {"", "Where it lies on top", "D65", "A", "moves by (CIEDE2000)"};
    for (size_t i = 0; i < std::size(heads); ++i) paper_.text(columns[i], y, heads[i], kQuiet);
    paper_.line(x, y + 1.2, kPage_mm[0] - kMargin_mm, y + 1.2, 0.15);
    y += kLine_mm + 0.6;
    const auto text = [](const Lab& lab) {
      return fmt::format("L* {:.1f}  a* {:.1f}  b* {:.1f}", lab.L, lab.a, lab.b);
    };
    for (const FaceColour& face : pictures_.faces) {
      paper_.fill(columns[0] + 5, y - 2.4, 5, 2.8, srgbFromLinear(glm::clamp(face.shown, Rgb(0.0f), Rgb(1.0f))));
      paper_.text(columns[1], y, face.name, kBody, columns[2] - columns[1] - 2);
      paper_.text(columns[2], y, text(face.daylight), kBody);
      paper_.text(columns[3], y, text(face.bulb), kBody);
      paper_.text(columns[4], y, fmt::format("{:.1f}", face.inconstancy), kBody);
      y += kLine_mm;
    }
    return y;
  }

  double notes(double x, double y) {
    if (fabric_.description.empty()) return y;
    y = heading(x, y, "Notes");
    return paper_.paragraph(x, y, fabric_.description, kBody, kPage_mm[0] - 2 * kMargin_mm, 4);
  }

  /// Along the lower edge.
  void colourways(double x) {
    if (pictures_.colourways.empty()) return;
    const double top = kPage_mm[1] - kMargin_mm - kColourway_mm - kLine_mm;
    heading(x, top - 2, "Colourways");
    for (size_t i = 0; i < pictures_.colourways.size(); ++i, x += kColourway_mm + 3) {
      paper_.picture(x, top, kColourway_mm, kColourway_mm, pictures_.colourways[i]);
      paper_.text(x, top + kColourway_mm + 3, fabric_.colourways[i].name, kBody, kColourway_mm);
    }
  }

  Paper& paper_;
  const Fabric& fabric_;
  const ClothSheetOptions& options_;
  const Pictures& pictures_;
};

}  // namespace

bool writeClothSheet(const std::string& file, const Fabric& fabric, const ClothSheetOptions& options,
                     const Task& task) {
  const std::string extension = lowerExtension(file);
  if (extension != ".pdf" && extension != ".png")
    throw InputError(fmt::format("{}: expected the name of a sheet that ends in .pdf or .png", file));
  expectWritable(file);
  const auto pictures = tracedPictures(fabric, options, task);
  if (!pictures) return false;
  constexpr double kPngPixels_per_mm = 200 / 25.4;
  Paper paper(kPage_mm[0], kPage_mm[1], extension == ".png" ? kPngPixels_per_mm : 0);
  SheetWriter(paper, fabric, options, *pictures).write();
  writeFileAtomically(file, paper.bytes(file));
  return true;
}

}  // namespace loomlight
