#include "app/export/sheet/cloth_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "app/export/picture.h"
#include "app/export/sheet/cloth_sheet_page.h"
#include "app/export/task_part.h"
#include "app/export/whole_picture.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/model/height_seen.h"
#include "render/transport/colour_patch.h"
#include "render/transport/reached_colours.h"

namespace loomlight {
namespace {

constexpr double kFine = 150 / kMmPerInch, kCoarse = 100 / kMmPerInch;  // pixels to the mm

/// A square of the cloth, flat under a light booth, seen from straight above without perspective. Its picture is shown
/// in the plain tone, as the chips of colour beside it are: white paper would be white.
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
  piece.camera.distance_mm = side_mm / heightSeenPerDistance(piece.camera);
  piece.render.width = piece.render.height = static_cast<int>(std::lround(side_mm * pixels_per_mm));
  piece.render.samplesPerPixel = samples;
  return piece;
}

/// What it takes to find a colour that is told as figures: about as much as so many samples of a picture.
constexpr double kColourWork = 200'000;

double pictureWork(double side_mm, double pixels_per_mm, int samples) {
  return std::pow(side_mm * pixels_per_mm, 2) * samples;
}

/// Work that is done step by step, with one progress for all.
class Steps {
 public:
  Steps(const Task& whole, double work) : whole_(whole), work_(work) {}

  /// Begins the next, and takes the one before it for done.
  Task next(double work) {
    const double from = done_ / work_;
    done_ += work;
    whole_.report(from);
    return partOf(whole_, from, done_ / work_);
  }
  /// The same of what does not say how far it is.
  Task nextQuiet(double work) {
    Task step = next(work);
    step.progress = nullptr;
    return step;
  }

 private:
  const Task& whole_;
  double work_, done_ = 0;
};

std::optional<WholePicture> tracedPiece(const Fabric& cloth, double side_mm, double pixels_per_mm,
                                        const ClothSheetOptions& options, Steps& steps) {
  return renderWhole(std::make_shared<const Fabric>(pieceOf(cloth, side_mm, pixels_per_mm, options.samplesPerPixel)),
                     {options.memoryLimit_bytes, FibreExtent::automatic},
                     steps.next(pictureWork(side_mm, pixels_per_mm, options.samplesPerPixel)));
}

std::optional<ClothSheetContent> tracedContent(const Fabric& fabric, const ClothSheetOptions& options,
                                               const Task& task) {
  const size_t count = std::min(fabric.colourways.size(), kSheetColourways);
  const int samples = options.samplesPerPixel;
  const double standardsWork = static_cast<double>(options.standards.size()) * kColourWork;
  const double facesWork = static_cast<double>(facesToTell(fabric)) * kColourWork;
  Steps steps(task, standardsWork + pictureWork(kSheetCloth_mm, kFine, samples) +
                        static_cast<double>(count) * pictureWork(kSheetColourway_mm, kCoarse, samples) + facesWork +
                        kColourWork);
  ClothSheetContent content;
  const auto patch = makeColourPatch(fabric, steps.nextQuiet(0));  // it takes a moment
  if (!patch) return std::nullopt;
  // First, as a wrong part is soon told.
  auto matches = standardMatches(*patch, options.standards, steps.nextQuiet(standardsWork));
  if (!matches) return std::nullopt;
  content.matches = std::move(*matches);
  const auto whole = tracedPiece(fabric, kSheetCloth_mm, kFine, options, steps);
  if (!whole) return std::nullopt;
  content.cloth = toPixels(whole->film, plainTone());
  content.measures = whole->scene->cloth->volume->geometry().measure();
  for (size_t i = 0; i < count; ++i) {
    const auto picture =
        tracedPiece(inColourway(fabric, fabric.colourways[i]), kSheetColourway_mm, kCoarse, options, steps);
    if (!picture) return std::nullopt;
    content.colourways.push_back(toPixels(picture->film, plainTone()));
  }
  auto faces = faceColours(*patch, steps.next(facesWork));
  if (!faces) return std::nullopt;
  content.faces = std::move(*faces);
  std::shared_ptr<const Scene> shared = patch->scene;
  const auto paths = tracePathsToYarns(fabric, kChipPaths, steps.nextQuiet(kColourWork), &shared);
  if (!paths) return std::nullopt;
  content.yarnColours = reachedColours(*paths, colouringOf(fabric));
  content.coloursOfNames = coloursForNames(*paths, content.yarnColours);
  return content;
}

/// Where a sheet goes: a .pdf, or a .png to be looked at.
class SheetFile {
 public:
  explicit SheetFile(const std::string& file) : file_(file), isPng_(lowerExtension(file) == ".png") {
    if (!isPng_ && lowerExtension(file) != ".pdf")
      throw InputError(fmt::format("{}: expected the name of a sheet that ends in .pdf or .png", file));
    expectWritable(file);
  }
  double pixels_per_mm() const { return isPng_ ? 200 / kMmPerInch : 0; }
  void write(Paper& paper) const { paper.write(file_); }

 private:
  const std::string& file_;
  bool isPng_;
};

}  // namespace

bool writeClothSheet(const std::string& file, const Fabric& fabric, const ClothSheetOptions& options,
                     const Task& task) {
  const SheetFile sheet(file);
  const auto content = tracedContent(fabric, options, task);
  if (!content) return false;
  Paper paper(kSheetWidth_mm, kSheetHeight_mm, sheet.pixels_per_mm());
  layOutClothSheet(paper, fabric, options, *content);
  sheet.write(paper);
  return true;
}

bool writeColourwaySheet(const std::string& file, const Fabric& fabric, const ClothSheetOptions& options,
                         const Task& task) {
  const SheetFile sheet(file);
  std::vector<Colourway> colourways{colourwayOf(fabric, "As it is now")};
  colourways.insert(colourways.end(), fabric.colourways.begin(), fabric.colourways.end());
  const double side_mm = colourwaySide_mm(colourways.size());
  const double pieceWork = pictureWork(side_mm, kFine, options.samplesPerPixel);
  Steps steps(task, static_cast<double>(colourways.size()) * pieceWork);
  std::vector<NamedPiece> pieces;
  for (const Colourway& colourway : colourways) {
    const auto picture = tracedPiece(inColourway(fabric, colourway), side_mm, kFine, options, steps);
    if (!picture) return false;
    pieces.push_back({colourway.name, toPixels(picture->film, plainTone())});
  }
  Paper paper(kSheetWidth_mm, kSheetHeight_mm, sheet.pixels_per_mm());
  layOutColourways(paper, fabric.name, pieces);
  sheet.write(paper);
  return true;
}

}  // namespace loomlight
