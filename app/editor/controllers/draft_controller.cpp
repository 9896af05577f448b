#include "app/editor/controllers/draft_controller.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/yarn/derived.h"
#include "ui/widgets/yarn_colours.h"
#include "ui/words/common_words.h"
#include "ui/words/dialog_words.h"

namespace loomlight {
namespace {

WifSett settOf(const Fabric& fabric) {
  return {fabric.ends_per_cm, fabric.picks_per_cm, meanDiameter_mm(fabric, System::warp),
          meanDiameter_mm(fabric, System::weft)};
}

std::string summaryOf(const Fabric& fabric) {
  std::string summary = fmt::format(words::wif::cloth, fabric.name, fabric.weave.ends(), fabric.weave.picks());
  if (fabric.draft) {
    summary += fmt::format(words::common::andShafts, fabric.draft->shafts);
    summary += fabric.draft->liftplan.empty() ? fmt::format(words::wif::andTreadles, fabric.draft->treadles)
                                              : std::string(words::wif::andLiftplan);
  }
  if (fabric.wif && !fabric.wif->program.empty()) summary += fmt::format(words::wif::writtenBy, fabric.wif->program);
  return summary + ".";
}

/// What the draft names of that cloth; empty where it names all.
std::string namedOf(const Fabric& fabric, const WifNamed& named) {
  if (named == WifNamed{}) return {};
  const int ends = named.ends > 0 ? named.ends : fabric.weave.ends();
  const int picks = named.picks > 0 ? named.picks : fabric.weave.picks();
  return fmt::format(words::wif::named, ends, fabric.weave.ends(), picks, fabric.weave.picks());
}

}  // namespace

std::optional<Fabric> DraftController::draw(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours,
                                            int brushYarn, const LongFloats* floats, DraftPreferences& preferences,
                                            const std::optional<CrossingIndex>& lit) {
  auto edited = draftPanel(ui, fabric, yarnColours, brushYarn, floats, preferences, view_, lit);
  if (std::exchange(view_.libraryWanted, false)) structures_.show();
  return edited;
}

/// Another weave in place of the whole or of the selection.
Fabric DraftController::taken(Rewoven result) {
  view_.remark = std::move(result.remark);
  if (!view_.selection) fit();
  return std::move(result.fabric);
}

std::optional<Fabric> DraftController::drawStructures(Ui& ui, const Fabric& fabric, const YarnColourService& colours,
                                                      const LoomLimits& limits) {
  if (!structures_.isOpen()) return std::nullopt;
  const std::vector<ImVec4> shown = displayColours(colours.of(withSecondYarn(fabric)));
  const ImVec4 darkLight[2] = {shown[0], shown[1]};
  const auto structure = structures_.draw(ui, view_.selection, darkLight);
  if (!structure) return std::nullopt;
  return taken(withStructure(fabric, view_.selection, *structure, limits));
}

void DraftController::openPicture(const std::string& file) {
  picture_.await(std::filesystem::path(file).filename().string());
  pictures_.read(file);
}

DraftController::Edit DraftController::drawPicture(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                   const YarnColourService& colours, const LoomLimits& limits) {
  Edit edit;
  if (auto come = pictures_.take()) {
    if (come->source) {
      picture_.show(come->source, fabric->ends_per_cm / fabric->picks_per_cm, view_.selection);
      wovenIsNew_ = false;
    } else {
      picture_.close();
      edit.problem = come->problem;
      if (come->woven) {
        // Only the weave: what else was edited meanwhile stays.
        Fabric rewoven = *fabric;
        rewoven.weave = std::move(come->woven->fabric.weave);
        rewoven.draft = std::move(come->woven->fabric.draft);
        if (!come->fillsSelection) view_.selection.reset();
        edit.fabric = taken({std::move(rewoven), std::move(come->woven->remark)});
      }
    }
  }
  if (auto changed = picture_.takeChanged())
    pictures_.preview(std::move(*changed), fabric, colours.of(*fabric),
                      static_cast<int>(ui.px(PictureDialog::kPreviewSide)));
  if (const auto woven = pictures_.takePreview()) {
    woven_->upload(*woven);
    wovenIsNew_ = true;
  }
  const bool open = picture_.isOpen();
  if (auto order = picture_.draw(ui, wovenIsNew_ ? woven_->id() : ImTextureID{}))
    pictures_.weave(std::move(*order), fabric, limits);
  if (open && !picture_.isOpen()) pictures_.forget();
  return edit;
}

void DraftController::askForSizes(std::shared_ptr<const Fabric> mine, std::vector<WifWarning> warnings,
                                  WifNamed named) {
  wifKept_ = std::move(mine);
  wifNamed_ = named;
  std::vector<WifWarning> beyond;
  withWifSizes(*wifKept_, beyond);
  wif_.show({summaryOf(*wifKept_), wifSett(*wifKept_), settOf(*wifKept_), namedOf(*wifKept_, named), std::move(beyond),
             std::move(warnings)});
}

std::optional<Fabric> DraftController::drawSizes(Ui& ui) {
  const auto choices = wif_.draw(ui);
  if (!choices) return std::nullopt;
  Fabric fabric = choices->threads == WifThreadChoice::named ? cutToNamed(*wifKept_, wifNamed_) : *wifKept_;
  std::vector<WifWarning> said;  // the dialog has them already
  return choices->sizes == WifSizeChoice::file ? withWifSizes(std::move(fabric), said) : fabric;
}

DraftController::Edit DraftController::drawDialogs(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                   const YarnColourService& colours,
                                                   const DraftPreferences& preferences) {
  auto structured = drawStructures(ui, *fabric, colours, preferences.loom);
  Edit edit = drawPicture(ui, fabric, colours, preferences.loom);
  auto sized = drawSizes(ui);
  if (!edit.fabric) edit.fabric = structured ? std::move(structured) : std::move(sized);
  return edit;
}

void DraftController::goTo(const EditPlace& place) {
  view_.cell = place.cell;
  view_.origin = ImVec2(place.originX, place.originY);
}

void DraftController::startOver() {
  pictures_.forget();
  picture_.close();
  wif_.close();
  wifKept_.reset();
  fit();
  view_.selection.reset();
  view_.remark.clear();
  view_.warpOrder = view_.weftOrder = {};
  view_.chosenFloat.reset();
}

}  // namespace loomlight
