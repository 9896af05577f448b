#include "app/editor/controllers/viewport_controller.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "app/editor/controllers/inset_model.h"
#include "core/fabric/model/choice_names.h"
#include "render/display/booth.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

/// How wide a picture is in a viewport of this size: as high as that, and of its own proportions.
int shownWidth(const Frame& frame, int width, int height) {
  const PixelRect& window = frame.window;
  if (window.height <= 0 || (window.width == width && window.height == height)) return width;
  return static_cast<int>(std::clamp<int64_t>(int64_t{window.width} * height / window.height, 1, 4 * int64_t{width}));
}

/// Linear, red, green and blue: the mean of all pixels, which noise leaves where it is.
std::string lightOf(std::span<const glm::vec4> pixels) {
  glm::dvec3 sum(0.0);
  for (const glm::vec4& pixel : pixels) sum += glm::dvec3(pixel);
  if (!pixels.empty()) sum /= static_cast<double>(pixels.size());
  return fmt::format("{:.6f} {:.6f} {:.6f}", sum.r, sum.g, sum.b);
}

/// What a divided frame shows under one lamp.
std::vector<glm::vec4> quarterOf(const Frame& frame, size_t lamp) {
  std::vector<glm::vec4> quarter;
  size_t i = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x, ++i)
      if (boothPixel(x, y, frame.width, frame.height).lamp == lamp) quarter.push_back(frame.booth[i]);
  return quarter;
}

}  // namespace

Tone ViewportController::tone(const Light& light) const {
  if (view_.isPlain(light)) return plainTone();
  Tone tone;
  tone.exposure_stops = static_cast<float>(view_.exposure_stops);
  return tone;
}

void ViewportController::layFlat(const Fabric& fabric, const FlatCloth& cloth) {
  if (cloth.inRepeats)
    flatRepeats_ = static_cast<int>(cloth.count);
  else
    flatSide_cm_ = cloth.count;
  const glm::dvec2 piece_mm = pieceOf(fabric, cloth).size_mm;
  const Camera& from = flat_ ? flat_->view.sight.camera : fabric.camera;
  flat_ = Flat{{cloth, {piece_mm, aboveFlat(from, piece_mm.x, piece_mm.y, aspect())}}, fabric.drape, piece_mm};
}

void ViewportController::lookAs(const std::optional<FlatView>& flat, const Fabric& fabric) {
  flat_ = flat ? std::optional(Flat{*flat, fabric.drape, pieceOf(fabric, flat->cloth).size_mm}) : std::nullopt;
}

bool ViewportController::lookAtFlat(const Camera& camera) {
  if (flat_) flat_->view.sight.camera = camera;
  return flat_.has_value();
}

std::optional<Fabric> ViewportController::onItsDrape(Fabric edited, const Fabric& fabric) {
  Drape drape = fabric.drape;
  if (edited.drape.kind != DrapeKind::flat) {  // another one was chosen
    drape.kind = edited.drape.kind;
    leaveFlat();
  }
  edited.drape = drape;
  edited.camera = fabric.camera;
  if (edited.drape == fabric.drape && edited.light == fabric.light) return std::nullopt;
  return edited;
}

ViewportController::Edit ViewportController::draw(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                  const std::optional<CrossingIndex>& hovered, const SoftProof& proof,
                                                  double fibreMemory_GB) {
  const LiveStatus status = service_.status();
  if (view_.inset.on) view_.booth = false;  // the lens has its place in the whole view
  std::optional<ViewportPicture::Outline> outline;
  const Weave& weave = fabric->weave;
  // A coarse first pass has pixels larger than crossings; an outline of them would only be blocks.
  constexpr int kCoarsest = 3;
  const Frame* shown = service_.frame().get();
  const ImVec4& accent = ui.theme.accent;
  if (hovered && shown && shown->divider <= kCoarsest)
    outline = {inRepeat(*hovered, weave), weave.ends(), weave.picks(), Rgb(accent.x, accent.y, accent.z)};
  ViewportModel model;
  const int pictureWidth = shown ? shownWidth(*shown, view_.width, view_.height) : view_.width;
  model.pictureSize = ImVec2(static_cast<float>(pictureWidth), static_cast<float>(view_.height));
  model.picture = service_.picture(model.pictureSize, tone(fabric->light), proof, outline);
  lookUnderPointer();
  model.under = underPointer_;
  model.underYarn = underPointerYarn_;
  model.denoised = shown && !shown->denoised.empty();
  model.divided = shown && shown->isDivided();
  model.plain = view_.isPlain(fabric->light);
  model.proofed = proof.prints != nullptr;
  model.warned = proof.warnsOfGamut;
  model.building = status.phase == LiveStatus::Phase::voxelising && status.buildProgress < 1;
  model.buildProgress = status.buildProgress;
  model.error = status.error;
  const std::shared_ptr<const FabricStats> stats = service_.stats();
  if (stats && stats->fabric->drape == fabric->drape) model.mesh = stats->mesh;
  if (flat_) {
    const glm::dvec2& piece_mm = flat_->view.sight.piece_mm;
    model.flat = fmt::format(words::viewport::flat, flatPieceText(*fabric, flat_->view.cloth));
    if (std::exchange(view_.fitWanted, false))
      flat_->view.sight.camera = aboveFlat(flat_->view.sight.camera, piece_mm.x, piece_mm.y, aspect());
  }
  ui.probe.fact("flat", model.flat);
  const bool liesFlat = flat_.has_value();
  const Fabric seen = asSeen(*fabric, false, flatSight());
  model.inset = insetModelFor(status.inset, seen, proof, fibreMemory_GB);
  ViewportEdit result = viewportPanel(ui, seen, model, view_);
  if (liesFlat && result.fabric) result.fabric = onItsDrape(std::move(*result.fabric), *fabric);

  Edit edit{std::move(result.fabric), result.camera, {}, result.inset.changeLimit, false};
  edit.orbited = result.camera && view_.drag == ViewportView::Drag::orbit;
  if (const auto hit = result.picked ? service_.hitAt(*result.picked) : std::nullopt)
    edit.yarn = std::min(hit->yarn, static_cast<int>(fabric->yarns.size()) - 1);
  if (!result.inset.remedy) return edit;
  const auto drape = fittingPiece(seen.drape, status.inset.bytes, 1e9 * fibreMemory_GB);
  if (drape && flat_) {
    flat_->view.sight.piece_mm = {drape->width_mm, drape->height_mm};
    view_.fitWanted = true;
  } else if (drape) {
    edit.fabric = *fabric;
    edit.fabric->drape = *drape;
    view_.fitWanted = true;
  }
  return edit;
}

InsetModel ViewportController::insetModelFor(const InsetStatus& status, const Fabric& fabric, const SoftProof& proof,
                                             double fibreMemory_GB) {
  const InsetFrame* frame = service_.insetFrame();
  InsetModel model = insetModel(status, frame, view_.inset.showsDifference, 1e9 * fibreMemory_GB, fabric.drape);
  if (!frame || !view_.inset.on) return model;
  const PixelRect window = frame->fibres->reach();
  model.window = {window.x, window.y, window.width, window.height};
  model.picture = service_.insetPicture(tone(fabric.light), proof);
  return model;
}

Camera ViewportController::atActualSize(const Fabric& fabric, double rulerFactor) const {
  return atScale(turnedTo(flat_ ? flat_->view.sight.camera : fabric.camera, Viewpoint::above), view_.height,
                 display_pixels_per_mm_ / rulerFactor);
}

void ViewportController::lookUnderPointer() {
  underPointer_.reset();
  const auto hit = view_.pointer ? service_.hitAt(*view_.pointer) : std::nullopt;
  if (!hit) return;
  underPointer_ = CrossingIndex{hit->pick, hit->end};
  underPointerYarn_.clear();
  // The picture may be of an older fabric that had more yarns.
  if (hit->yarn < static_cast<int>(view_.yarnNames.size()))
    underPointerYarn_ = view_.yarnNames[static_cast<size_t>(hit->yarn)];
}

void ViewportController::follow(const std::shared_ptr<const Fabric>& fabric, int yarn, bool visibilityShown,
                                const ViewLimits& limits, const ClothSide& side) {
  if (flat_ && fabric->drape != flat_->instead) leaveFlat();  // another drape is wanted
  if (flat_) {
    const glm::dvec2 asked_mm = pieceOf(*fabric, flat_->view.cloth).size_mm;
    // Only then, as the piece may be smaller than was asked for: as large as fibres have room.
    if (std::exchange(flat_->asked_mm, asked_mm) != asked_mm) flat_->view.sight.piece_mm = asked_mm;
  }
  ViewState state;
  state.flat = flatSight();
  state.fabric = fabric;
  state.width = view_.width;
  state.height = view_.height;
  state.denoised = view_.denoised;
  state.rest = static_cast<uint32_t>(limits.samples);
  state.booth = view_.booth;
  const InsetView& inset = view_.inset;
  if (inset.on && inset.placed)
    state.inset = {{inset.rect.x, inset.rect.y, inset.rect.width, inset.rect.height}, 1e9 * limits.fibreMemory_GB};
  state.yarn = yarn;
  state.visibilityShown = visibilityShown;
  state.back = side.back;
  state.longFloat_mm = side.longFloat_mm;
  service_.follow(state);
}

void ViewportController::tellProbe(WidgetProbe& probe, int yarn) {
  const LiveStatus status = service_.status();
  const std::shared_ptr<const Frame>& shown = service_.frame();
  const InsetFrame* inset = service_.insetFrame();
  probe.fact("generation", std::to_string(service_.generation()));
  probe.fact("built_generation", std::to_string(status.builtGeneration));
  probe.fact("shown_generation", std::to_string(shown ? shown->generation : 0));
  probe.fact("shown_samples", std::to_string(shown ? shown->samples : 0));
  if (std::exchange(lightToldOf_, shown) != shown) {  // of millions of pixels, so not in every frame of the window
    shownLight_ = shown ? lightOf(shown->whole()) : "";
    for (size_t lamp = 0; lamp < kBoothLamps.size(); ++lamp)
      boothLight_[lamp] = shown && shown->isDivided() ? lightOf(quarterOf(*shown, lamp)) : "";
  }
  probe.fact("shown_light", shownLight_);
  for (size_t lamp = 0; lamp < kBoothLamps.size(); ++lamp)
    probe.fact(std::string("booth.light.") + choiceName(kBoothLamps[lamp]), boothLight_[lamp]);
  static constexpr const char* kPhases[] = {"idle", "voxelising", "tracing", "converged"};
  probe.fact("phase", kPhases[static_cast<int>(status.phase)]);
  probe.fact("shown_sketch", shown && shown->quality == PreviewQuality::sketch ? "yes" : "no");
  probe.fact("denoised", shown && !shown->denoised.empty() ? "yes" : "no");
  probe.fact("error", status.error);
  static constexpr const char* kInsetPhases[] = {"closed",    "waiting", "needless", "laying",
                                                 "too_large", "failed",  "tracing",  "converged"};
  probe.fact("lens", kInsetPhases[static_cast<int>(status.inset.phase)]);
  probe.fact("fit", view_.fitWanted ? "awaited" : "done");
  probe.fact("lens_tool", view_.inset.placed ? "placed" : view_.inset.on ? "chosen" : "off");
  probe.fact("lens_samples", std::to_string(inset ? inset->fibres->samples : 0));
  probe.fact("lens_generation", std::to_string(inset ? inset->fibres->generation : 0));
  probe.fact("lens_difference", inset && inset->difference ? "known" : "unknown");
  const BakedVisibility* visibility = service_.visibility();
  const bool baked = visibility && visibility->yarn == yarn;
  probe.fact("visibility", !baked ? "none" : visibility->finished ? "finished" : "early");
}

}  // namespace loomlight
