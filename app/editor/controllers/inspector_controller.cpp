#include "app/editor/controllers/inspector_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/editor/model/book_colours.h"
#include "core/fabric/palette/colour_code.h"
#include "core/fabric/yarn/band_colour.h"
#include "ui/widgets/yarn_colours.h"
#include "ui/words/dialog_words.h"
#include "ui/words/error_words.h"

namespace loomlight {

InspectorResult InspectorController::draw(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                          const YarnColourService& yarnColours, const ViewService& seen,
                                          const std::optional<StandardIlluminant>& ownLamp, bool inches) {
  const ClothMeasures measures = seen.status().measures;
  const std::shared_ptr<const FabricStats> stats = seen.stats();
  InspectorModel model;
  if (stats && stats->yarn == view_.yarn && stats->section) model.section = &*stats->section;
  model.measured = measures.thickness_mm > 0;  // a moment after it is built
  model.crimpWarp = measures.crimpWarp;
  model.crimpWeft = measures.crimpWeft;
  model.thickness_mm = measures.thickness_mm;
  model.arealMass_g_m2 = measures.arealMass_g_m2;
  if (stats) {
    model.floats = &stats->floats;
    model.binding = &stats->binding;
    model.warnings = &stats->warnings;
  }
  model.yarns = shownYarns(*fabric, yarnColours.of(*fabric), yarnColours.forNames(*fabric), view_.units.count);
  if (view_.page == InspectorView::Page::yarn && view_.yarn < static_cast<int>(fabric->yarns.size()))
    model.closeUp = pictures_.closeUp(fabric, view_.yarn, ui.scale);
  if (view_.page == InspectorView::Page::fibre)
    model.clothColour = colours_.model(fabric, dyed(*fabric), view_.clothColour);
  model.visibility = seen.visibilityModel(view_.yarn);
  model.ownLamp = ownLamp;
  model.inches = inches;
  return inspector(ui, *fabric, model, view_);
}

std::optional<Fabric> InspectorController::drawColourways(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                          const YarnColourService& yarnColours) {
  ColourwayLooks looks{pictures_.colourways(fabric, colourways_.pictureSize()),
                       {displayColours(yarnColours.of(*fabric))}};
  for (size_t i = 0; i < fabric->colourways.size(); ++i)
    looks.yarnColours.push_back(displayColours(yarnColours.ofColourway(*fabric, i)));
  return colourways_.draw(ui, *fabric, looks);
}

void InspectorController::drawColourDifference(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                               const YarnColourService& yarnColours) {
  ColourDifferenceModel model;
  model.yarns = shownYarns(*fabric, yarnColours.of(*fabric), yarnColours.forNames(*fabric), view_.units.count).names;
  model.colourways.emplace_back(words::colourways::asItIsNow);
  for (const Colourway& colourway : fabric->colourways) model.colourways.push_back(colourway.name);
  differences_.follow(fabric, colourDifference_.pairOf(*fabric));
  differences_.tell(model);
  colourDifference_.draw(ui, model, view_.clothColour.tolerance_cmc);
}

std::optional<InspectorController::Dyed> InspectorController::follow(const std::shared_ptr<const Fabric>& fabric,
                                                                     uint64_t gesture, bool isShown) {
  followBooks();
  if (view_.yarn != lookedAt_) before_ = std::exchange(lookedAt_, view_.yarn);
  if (view_.page != InspectorView::Page::fibre || !isShown) return std::nullopt;
  if (const auto code = std::exchange(view_.clothColour.entered, std::nullopt)) wantCode(dyed(*fabric), *code);
  if (std::exchange(colourWish_, view_.clothColour.wish) != view_.clothColour.wish) colourGesture_ = gesture;
  auto edited = colours_.follow(fabric, dyed(*fabric), view_.clothColour);
  if (!edited) return std::nullopt;
  return Dyed{std::move(*edited), colourGesture_};
}

ClothPart InspectorController::dyed(const Fabric& fabric) const {
  const int yarn = std::clamp(view_.yarn, 0, static_cast<int>(fabric.yarns.size()) - 1);
  return view_.clothColour.dyed(yarn, shownFibre(fabric, view_));
}

void InspectorController::wantCode(const ClothPart& part, const std::string& code) {
  ClothColourView& view = view_.clothColour;
  const BookColour* const called = view.book ? view.book->named(code) : nullptr;
  const std::optional<NamedColour> written = called ? std::nullopt : colourFromCode(code);
  view.refusal = "";
  if (called)
    view.want(part, {called->linear, called->measured, called->name});
  else if (written)
    view.want(part, {bookColour(*written).linear, {}, code});
  else
    view.refusal = fmt::format(words::errors::noColour, code,
                               view.book ? fmt::format(words::errors::orOfBook, view.book->name) : "");
}

void InspectorController::dyeLike(const Fabric& fabric, const MeasuredSwatch& swatch, const std::optional<int>& yarn) {
  view_.page = InspectorView::Page::fibre;
  if (yarn) {
    view_.yarn = *yarn;
    view_.clothColour.dyes = ClothPart::Kind::yarn;
  }
  std::string name = swatch.name;
  if (const std::string_view specularly = specularText(swatch.specular); !specularly.empty())
    name += fmt::format(" ({})", specularly);
  const Spectrum measured = bandReflectance(swatch);
  view_.clothColour.want(dyed(fabric), {linearFromReflectance(measured), measured, std::move(name)});
}

void InspectorController::open(const Palette& palette, const std::string& file) {
  view_.page = InspectorView::Page::fibre;
  show(colourBook(palette), file);
}

void InspectorController::show(ColourBook book, const std::string& file) {
  view_.clothColour.book = std::make_shared<const ColourBook>(std::move(book));
  view_.clothColour.books.take(file);
  view_.clothColour.search.clear();
  view_.clothColour.refusal.clear();
}

/// Books that were used before are opened, shut and forgotten as the page asks for it.
void InspectorController::followBooks() {
  ClothColourView& view = view_.clothColour;
  BookShelf& shelf = view.books;
  const auto shut = [&] {
    view.book.reset();
    books_.forget();
  };
  if (const auto wanted = std::exchange(shelf.wanted, std::nullopt)) {
    shut();
    shelf.open = *wanted;
    if (*wanted >= 0) books_.read(shelf.files[static_cast<size_t>(*wanted)]);
  }
  if (const auto removed = std::exchange(shelf.remove, std::nullopt)) {
    if (*removed == shelf.open) shut();
    shelf.forget(*removed);
  }
  auto read = books_.take();
  if (!read) return;
  if (read->book) return show(std::move(*read->book), read->file);
  shelf.open = -1;
  view.refusal = read->problem;
}

void InspectorController::stepYarn(int step, size_t yarns) {
  const auto count = static_cast<int>(yarns);
  view_.yarn = (view_.yarn + step + count) % count;
}

void InspectorController::swapYarns(size_t yarns) {
  view_.yarn = std::min(before_, static_cast<int>(yarns) - 1);
}

void InspectorController::goTo(const EditPlace& place) {
  view_.page = static_cast<InspectorView::Page>(place.page);
  view_.yarn = place.yarn;
}

void InspectorController::startOver() {
  colours_.forget();
  view_.yarn = 0;
  view_.clothColour.wanted.clear();
  view_.clothColour.code.clear();
  view_.clothColour.refusal.clear();
}

}  // namespace loomlight
