#include <fmt/core.h>

#include <cmath>

#include "app/editor/controllers/lens_model.h"
#include "app/editor/controllers/status_model.h"
#include "app/editor/session.h"
#include "core/base/stopwatch.h"
#include "ui/desk.h"
#include "ui/draft/draft_panel.h"
#include "ui/menu_bar.h"
#include "ui/widgets/preset_list.h"
#include "ui/widgets/yarn_colours.h"

namespace loomlight {
namespace {

/// How wide a picture is in a viewport of this size: as high as that, and of its own proportions. A coarse one reaches
/// beyond its viewport by a part of a pixel, which is nothing of its proportions.
int shownWidth(const Frame& frame, int width, int height) {
  const PixelRect& window = frame.window;
  const auto covers = [&](int length, int room) { return length >= room && length < room + frame.divider; };
  if (window.height <= 0 || (covers(window.width, width) && covers(window.height, height))) return width;
  return static_cast<int>(std::clamp<int64_t>(int64_t{window.width} * height / window.height, 1, 4 * int64_t{width}));
}

/// Linear, red, green and blue: the mean of all pixels, which noise leaves where it is.
std::string lightOf(const Frame& frame) {
  const auto& pixels = frame.shown();
  glm::dvec3 sum(0.0);
  for (const glm::vec4& pixel : pixels) sum += glm::dvec3(pixel);
  if (!pixels.empty()) sum /= static_cast<double>(pixels.size());
  return fmt::format("{:.6f} {:.6f} {:.6f}", sum.r, sum.g, sum.b);
}

}  // namespace

void Session::frame(Ui& ui) {
  Stopwatch watch;
  if (views_.take(viewport_.lens.showsDifference)) followViewToKeep();
  work_s_ = watch.lap();
  // A gesture lasts while a button is down or a text is open; what it changes is one step of undo.
  if (!ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) ++gesture_;
  if (!dialogIsOpen()) readKeys();
  drawPanels(ui);
  drawDialogs(ui);
  watch.lap();
  follow();
  work_s_ += watch.lap();
}

void Session::drawPanels(Ui& ui) {
  const LiveStatus status = views_.status();
  const std::shared_ptr<const Insight> insight = views_.insight();
  MenuModel menu;
  menu.title = document_.fabric()->name;
  menu.edited = document_.isDirty();
  menu.canUndo = document_.canUndo();
  menu.canRedo = document_.canRedo();
  menu.darkTheme = settings_.darkTheme;
  menu.panelsShown = settings_.desk.panelsShown;
  menu.lensOn = viewport_.lens.on;
  menu.denoised = viewport_.denoised;
  menu.weave = {draft_.selection.has_value(), draft_.back, draft_.marksFloats};
  const float menuHeight = ImGui::GetFontSize() + ui.px(16);
  menu.recent = settings_.recent;
  const MenuChoice choice = menuBar(ui, menu);

  const DeskAreas areas = deskAreas(settings_.desk, ImGui::GetIO().DisplaySize, menuHeight, ui.scale,
                                    shelf_.empty() ? 0 : kSnapshotStripHeight);
  splitters(ui, settings_.desk, areas);
  beginPanel("viewport", areas.viewport, false);
  drawViewport(ui, insight.get(), status);
  endPanel();
  if (!shelf_.empty()) {
    beginPanel("strip", areas.strip, false);
    drawStrip(ui);
    endPanel();
  }
  if (settings_.desk.panelsShown) {
    beginPanel("draft", areas.draft, true);
    drawDraft(ui);
    endPanel();
    beginPanel("inspector", areas.inspector, true);
    drawInspector(ui, insight.get(), status);
    endPanel();
  }
  beginPanel("status", areas.status, false);
  statusBar(ui, statusToSay(insight.get(), status));
  endPanel();
  const ImVec2 picture(static_cast<float>(viewport_.width), static_cast<float>(viewport_.height));
  firstHints(ui, areas.viewport.min, picture, hints_);
  keepSettings();
  tellProbe(ui, status);
  if (choice.command) run(*choice.command);
  if (choice.draft) run(*choice.draft);
  if (choice.recent.appeared) lookFor(settings_.recent);
  if (choice.recent.file) openRecent(*choice.recent.file);
  if (choice.recent.clear) settings_.recent.clear();
}

void Session::drawDraft(Ui& ui) {
  const Fabric& fabric = *document_.fabric();
  place_ = placeInDraft();
  draft_.brushYarn = inspector_.yarn;
  auto edited = draftPanel(ui, fabric, yarnColours(fabric), settings_.draft, draft_, underPointer_);
  hints_.drew |= edited.has_value();
  if (edited) edit(std::move(*edited));
  inspector_.yarn = draft_.brushYarn;
  if (std::exchange(draft_.libraryWanted, false)) run(DraftCommand::structures);
  if (const auto choice = presetList(ui, presetDesk_.names(), sampleNames_)) applyPreset(*choice);
}

void Session::drawViewport(Ui& ui, const Insight* insight, const LiveStatus& status) {
  place_ = {};
  std::optional<ViewportPicture::Outline> outline;
  const Weave& weave = document_.fabric()->weave;
  // A coarse first pass has pixels larger than crossings; an outline of them would only be blocks.
  constexpr int kCoarsest = 3;
  const Frame* shown = views_.frame();
  const ImVec4& accent = ui.theme.accent;
  if (draft_.hovered && shown && shown->divider <= kCoarsest)
    outline = {inRepeat(*draft_.hovered, weave), weave.ends(), weave.picks(), Rgb(accent.x, accent.y, accent.z)};
  ViewportModel model;
  const int pictureWidth = shown ? shownWidth(*shown, viewport_.width, viewport_.height) : viewport_.width;
  model.picture = views_.picture(pictureWidth, viewport_.height, tone(), outline);
  model.pictureSize = ImVec2(static_cast<float>(pictureWidth), static_cast<float>(viewport_.height));
  lookUnderPointer();
  model.under = underPointer_;
  model.underYarn = underPointerYarn_;
  model.denoised = shown && !shown->denoised.empty();
  model.building = status.phase == LiveStatus::Phase::voxelising && status.buildProgress < 1;
  model.buildProgress = status.buildProgress;
  model.error = status.error;
  if (insight && insight->fabric->drape == document_.fabric()->drape) model.mesh = insight->mesh;
  model.lens = lensModelFor(status.lens);
  ViewportEdit result = viewportPanel(ui, *document_.fabric(), model, viewport_);
  if (result.fabric) edit(std::move(*result.fabric));
  if (result.camera) document_.lookFrom(*result.camera);
  hints_.turned |= result.camera && viewport_.drag == ViewportView::Drag::orbit;
  if (const auto hit = result.picked ? views_.hitAt(*result.picked) : std::nullopt)
    inspector_.yarn = std::min(hit->yarn, static_cast<int>(document_.fabric()->yarns.size()) - 1);
  if (result.lens.changeLimit) run(Command::preferences);
  if (!result.lens.remedy) return;
  Fabric smaller = *document_.fabric();
  if (const auto drape = fittingPiece(smaller.drape, status.lens.bytes, 1e9 * settings_.fibreMemory_GB)) {
    smaller.drape = *drape;
    edit(std::move(smaller));
    viewport_.fitWanted = true;
  }
}

LensModel Session::lensModelFor(const LensStatus& status) {
  const LensFrame* frame = views_.lensFrame();
  LensModel model = lensModel(status, frame, viewport_.lens.showsDifference, 1e9 * settings_.fibreMemory_GB,
                              document_.fabric()->drape);
  if (!frame || !viewport_.lens.on) return model;
  const PixelRect& window = frame->fibres->window;
  model.window = {window.x, window.y, window.width, window.height};
  model.picture = views_.lensPicture(tone());
  return model;
}

void Session::lookUnderPointer() {
  underPointer_.reset();
  const auto hit = viewport_.pointer ? views_.hitAt(*viewport_.pointer) : std::nullopt;
  if (!hit) return;
  const Fabric& fabric = *document_.fabric();
  underPointer_ = CrossingIndex{hit->pick, hit->end};
  underPointerYarn_.clear();
  // The picture may be of an older fabric that had more yarns.
  if (hit->yarn < static_cast<int>(fabric.yarns.size()))
    underPointerYarn_ = fabric.yarns[static_cast<size_t>(hit->yarn)].name;
}

void Session::drawInspector(Ui& ui, const Insight* insight, const LiveStatus& status) {
  const Fabric& fabric = *document_.fabric();
  InspectorModel model;
  if (insight && insight->yarn == inspector_.yarn) model.section = &insight->section;
  model.measured = status.measures.thickness_mm > 0;  // a moment after it is built
  model.crimpWarp = status.measures.crimpWarp;
  model.crimpWeft = status.measures.crimpWeft;
  model.thickness_mm = status.measures.thickness_mm;
  model.arealMass_g_m2 = status.measures.arealMass_g_m2;
  if (insight) {
    model.floats = &insight->floats;
    model.binding = &insight->binding;
    model.warnings = &insight->warnings;
  }
  model.yarnColours = yarnColours(fabric);
  if (inspector_.page == InspectorView::Page::yarn && inspector_.yarn < static_cast<int>(fabric.yarns.size()))
    model.closeUp = sidePictures_.closeUp(document_.fabric(), inspector_.yarn, ui.scale);
  if (inspector_.page == InspectorView::Page::fibre)
    model.clothColour = colours_.model(fabric, shownFibre(fabric, inspector_), inspector_.clothColour);
  model.visibility = views_.visibilityModel(inspector_.yarn);
  place_ = placeInInspector();
  model.inches = settings_.draft.inches;
  inspector_.units = settings_.units;
  InspectorResult result = inspector(ui, fabric, model, inspector_);
  settings_.units = inspector_.units;
  hints_.set |= result.fabric.has_value();
  if (result.fabric) edit(std::move(*result.fabric));
  if (result.camera) document_.lookFrom(*result.camera);
  if (result.command) run(*result.command);
}

/// What is unsafe comes before what is worth knowing of the cloth.
StatusModel Session::statusToSay(const Insight* insight, const LiveStatus& status) const {
  StatusModel model = statusModel(insight, status, views_.visibilityStatus(), views_.frame());
  const auto insist = [&model](std::string warning) {
    model.warning = std::move(warning);
    model.moreWarnings = 0;
  };
  if (const std::string unknown = views_.insightProblem(); !unknown.empty())
    insist("The cloth's figures are not known: " + unknown);
  if (const std::string& unsafe = shelf_.problem(); !unsafe.empty())
    insist("The view that was kept will not last: " + unsafe);
  if (const std::string unsafe = autosave_.problem(); !unsafe.empty())
    insist("Unsaved work is not kept safe: " + unsafe);
  if (!refusal_.empty()) insist(refusal_);
  return model;
}

void Session::tellProbe(Ui& ui, const LiveStatus& status) const {
  if (!ui.probe.watching()) return;
  const Frame* shown = views_.frame();
  const LensFrame* lens = views_.lensFrame();
  ui.probe.fact("frame", std::to_string(ImGui::GetFrameCount()));
  ui.probe.fact("text_input", ImGui::GetIO().WantTextInput ? "yes" : "no");
  ui.probe.fact("name", document_.fabric()->name);
  ui.probe.fact("file", document_.file());
  ui.probe.fact("dirty", document_.isDirty() ? "yes" : "no");
  ui.probe.fact("revision", std::to_string(document_.revision()));
  ui.probe.fact("generation", std::to_string(views_.generation()));
  ui.probe.fact("built_generation", std::to_string(status.builtGeneration));
  ui.probe.fact("shown_generation", std::to_string(shown ? shown->generation : 0));
  ui.probe.fact("shown_samples", std::to_string(shown ? shown->samples : 0));
  ui.probe.fact("shown_light", shown ? lightOf(*shown) : "");
  static constexpr const char* kPhases[] = {"idle", "voxelising", "tracing", "converged"};
  ui.probe.fact("phase", kPhases[static_cast<int>(status.phase)]);
  ui.probe.fact("shown_draft", shown && shown->quality == Quality::sketch ? "yes" : "no");
  ui.probe.fact("denoised", shown && !shown->denoised.empty() ? "yes" : "no");
  ui.probe.fact("error", status.error);
  ui.probe.fact("refusal", refusal_);
  ui.probe.fact("autosave_problem", autosave_.problem());
  static constexpr const char* kLensPhases[] = {"closed",    "waiting", "needless", "laying",
                                                "too_large", "failed",  "tracing",  "converged"};
  ui.probe.fact("lens", kLensPhases[static_cast<int>(status.lens.phase)]);
  ui.probe.fact("lens_tool", viewport_.lens.placed ? "placed" : viewport_.lens.on ? "chosen" : "off");
  ui.probe.fact("lens_samples", std::to_string(lens ? lens->fibres->samples : 0));
  ui.probe.fact("lens_generation", std::to_string(lens ? lens->fibres->generation : 0));
  ui.probe.fact("lens_difference", lens && lens->difference ? "known" : "unknown");
  const BakedVisibility* visibility = views_.visibility();
  const bool baked = visibility && visibility->yarn == inspector_.yarn;
  ui.probe.fact("visibility", !baked ? "none" : visibility->finished ? "finished" : "early");
  ui.probe.fact("yarn", std::to_string(inspector_.yarn));
  ui.probe.fact("dialog", dialogIsOpen() ? "open" : "none");
}

}  // namespace loomlight
