#include "ui/viewport/viewport_panel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "ui/viewport/booth_overlay.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/denoise_button.h"
#include "ui/viewport/view_labels.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/keys.h"
#include "ui/words/viewport_words.h"

namespace loomlight {
namespace {

std::optional<Camera> mouseMoves(const Camera& camera, ViewportView& view, ImVec2 min, ImVec2 max, bool divided) {
  const ImGuiIO& io = ImGui::GetIO();
  std::optional<Camera> moved;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const ImVec2 at = fromMiddle(io.MousePos, min, max, divided);
    moved = zoomed(camera, io.MouseWheel, at.x, at.y, view.height);
  }
  if (!ImGui::IsItemActive()) {
    view.drag = ViewportView::Drag::none;
    return moved;
  }
  const bool space = keyHeld(ImGuiKey_Space);
  if (view.drag == ViewportView::Drag::none) {
    const bool pan = io.MouseDown[ImGuiMouseButton_Middle] || io.KeyShift || space;
    view.drag = pan ? ViewportView::Drag::pan : ViewportView::Drag::orbit;
    return moved;
  }
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return moved;
  const Camera from = moved ? *moved : camera;
  return view.drag == ViewportView::Drag::pan ? panned(from, io.MouseDelta.x, io.MouseDelta.y, view.height)
                                              : orbited(from, io.MouseDelta.x, io.MouseDelta.y);
}

/// 1, 2 and 3 look from above, aslant and along the cloth, unless a text or a list has the keys.
std::optional<Camera> viewKeys(const Camera& camera) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  if (io.WantTextInput || io.KeyCtrl || ImGui::IsPopupOpen("", kAny)) return std::nullopt;
  constexpr Viewpoint kViews[] = {Viewpoint::above, Viewpoint::aslant, Viewpoint::grazing};
  for (int i = 0; i < static_cast<int>(std::size(kViews)); ++i)
    if (letterPressed(static_cast<char>('1' + i))) return turnedTo(camera, kViews[i]);
  return std::nullopt;
}

/// True while the mouse holds the inset by an edge, or is giving it a place.
bool insetHolds(Ui& ui, ViewportView& view, ImVec2 min) {
  InsetView& inset = view.inset;
  const ImVec2 mouse = ImGui::GetIO().MousePos, at(mouse.x - min.x, mouse.y - min.y);
  const bool active = ImGui::IsItemActive();
  const bool taking = ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (taking || (ImGui::IsItemHovered() && !active)) {
    const InsetView::Grip under = inset.gripAt(at, ui.px(5));
    if (under != InsetView::Grip::none) ImGui::SetMouseCursor(cursorOf(under));
    if (taking) inset.grab(under, at);
  }
  if (inset.grip == InsetView::Grip::none || inset.grip == InsetView::Grip::move) return false;
  ImGui::SetMouseCursor(cursorOf(inset.grip));
  inset.drag(at, view.width, view.height);
  if (!active) inset.letGo(view.width, view.height);
  return true;
}

/// 0..1 of the picture; nothing beside it.
std::optional<ImVec2> placeIn(ImVec2 corner, ImVec2 size, ImVec2 point) {
  const ImVec2 place((point.x - corner.x) / size.x, (point.y - corner.y) / size.y);
  const bool inside = place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1;
  return inside ? std::optional(place) : std::nullopt;
}

/// Where the picture was clicked, as opposed to dragged.
std::optional<ImVec2> clickedAt(const ViewportView& view, ImVec2 min, ImVec2 size) {
  constexpr float kStill = 3;
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemDeactivated() || view.drag != ViewportView::Drag::orbit) return std::nullopt;
  if (io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > kStill * kStill) return std::nullopt;
  return placeIn(min, size, io.MousePos);
}

float widest(std::span<const char* const> names) {
  float width = 0;
  for (const char* const name : names) width = std::max(width, ImGui::CalcTextSize(name).x);
  return width;
}

/// Where the choices below the picture are. They share what the buttons leave; exposure, a number that says its unit,
/// and then the choices go without their labels before a choice would lose its end.
struct StripColumns {
  float choice = 0, exposure = 0;
  bool exposureLabelled = true, choicesLabelled = true;
};

StripColumns stripColumns(Ui& ui, float room) {
  const auto labelled = [&](const char* label, float field) {
    return ImGui::CalcTextSize(label).x + ui.px(12) + field;
  };
  const float number = ui.px(84), list = widest(lightNames({})) + ui.px(40);
  const float longest = labelled(words::viewport::drape.label, list);
  StripColumns columns;
  columns.exposure = labelled(words::viewport::exposure.label, number);
  columns.exposureLabelled = room - columns.exposure >= 2 * longest;
  if (!columns.exposureLabelled) columns.exposure = number;
  columns.choicesLabelled = room - columns.exposure >= 2 * longest;
  columns.choice = std::clamp(0.5f * (room - columns.exposure), 0.5f * list, ui.px(220));
  return columns;
}

std::optional<Fabric> lightChoice(Ui& ui, const Fabric& fabric, bool labelled) {
  int kind = static_cast<int>(fabric.light.kind);
  if (!choiceField(ui, {"view.light", labelled ? words::viewport::light.label : "", words::viewport::light.help, true},
                   lightNames(fabric.light), kind))
    return std::nullopt;
  Fabric edited = fabric;
  edited.light = withKind(fabric.light, static_cast<LightKind>(kind));
  return edited;
}

std::optional<Fabric> drapeChoice(Ui& ui, const Fabric& fabric, bool labelled) {
  int kind = static_cast<int>(fabric.drape.kind);
  const auto names = drapeNames(fabric.drape);
  if (!choiceField(ui, {"view.drape", labelled ? words::viewport::drape.label : "", words::viewport::drape.help, true},
                   names, kind))
    return std::nullopt;
  Fabric edited = fabric;
  edited.drape.kind = static_cast<DrapeKind>(kind);
  return edited;
}

/// In the plain tone it is 0; the designer's own comes back with the curve.
void exposureField(Ui& ui, bool labelled, bool plain, double& exposure_stops) {
  const char* const label = labelled ? words::viewport::exposure.label : "";
  if (plain) {
    readout(ui, {"view.exposure", label, words::viewport::noExposureHelp, true}, words::viewport::noExposure);
    return;
  }
  NumberStyle style;
  style.unit = "EV";
  style.min = -kMostExposure_stops;
  style.max = kMostExposure_stops;
  style.decimals = 1;
  style.perPixel = 0.02;
  numberField(ui, {"view.exposure", label, words::viewport::exposure.help, true}, style, exposure_stops);
}

/// The strip below the picture: what is changed most often while looking. In a narrow window the choices need the room
/// more than what keys and menus do too.
std::optional<Fabric> quickChoices(Ui& ui, const Fabric& fabric, bool plain, ViewportView& view) {
  std::optional<Fabric> edited;
  const float all = ImGui::GetContentRegionAvail().x;
  const bool narrow = all < ui.px(400);
  const float gap = ui.px(narrow ? 8 : 16);
  const float fit = all < ui.px(300) ? 0 : ui.px(56), inset = ui.px(40), between = ui.px(8);
  const float tools = narrow ? 0 : all < ui.px(560) ? 1 : 2;
  const StripColumns columns = stripColumns(ui, all - fit - tools * (between + inset) - 3 * gap);
  float x = ImGui::GetStyle().WindowPadding.x;
  const float y = ImGui::GetCursorPosY();
  auto column = [&](const char* id, float width, auto&& content) {
    ImGui::SetCursorPos(ImVec2(x, y));
    ImGui::BeginChild(id, ImVec2(width, ImGui::GetFrameHeight()), false, ImGuiWindowFlags_NoScrollbar);
    content();
    ImGui::EndChild();
    x += width + gap;
  };
  column("light", columns.choice, [&] { edited = lightChoice(ui, fabric, columns.choicesLabelled); });
  column("drape", columns.choice, [&] {
    auto draped = drapeChoice(ui, fabric, columns.choicesLabelled);
    if (!draped) return;
    edited = std::move(draped);
    view.fitWanted = true;
  });
  column("exposure", columns.exposure,
         [&] { exposureField(ui, columns.exposureLabelled, plain, view.exposure_stops); });
  const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  if (tools > 1) {
    ImGui::SetCursorPos(ImVec2(right - fit - tools * (between + inset), y));
    denoiseButton(ui, view.denoised, inset);
  }
  if (tools > 0) {
    ImGui::SetCursorPos(ImVec2(right - fit - between - inset, y));
    insetButton(ui, view.inset, inset);
  }
  if (fit == 0) return edited;
  ImGui::SetCursorPos(ImVec2(right - fit, y));
  if (button(ui, "view.fit", words::viewport::fit.label, fit, true, words::viewport::fit.help)) view.fitWanted = true;
  return edited;
}

}  // namespace

ViewportEdit viewportPanel(Ui& ui, const Fabric& fabric, const ViewportModel& model, ViewportView& view) {
  ViewportEdit edit;
  const ImVec2 min = ImGui::GetWindowPos();
  const float strip = ImGui::GetFrameHeight() + ui.px(16);
  const ImVec2 max(min.x + ImGui::GetWindowWidth(), min.y + ImGui::GetWindowHeight() - strip);
  const ImVec2 size(std::max(max.x - min.x, 1.0f), std::max(max.y - min.y, 1.0f));
  view.width = static_cast<int>(size.x);
  view.height = static_cast<int>(size.y);

  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("cloth", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ui.probe.recordItem("viewport");
  const bool withInset = insetHolds(ui, view, min);
  // A picture of other proportions than the panel's stands in its middle until the next one comes.
  const ImVec2 corner(std::floor(0.5f * (min.x + max.x - model.pictureSize.x)), min.y);
  edit.picked = clickedAt(view, corner, model.pictureSize);
  if (!withInset) edit.camera = mouseMoves(fabric.camera, view, min, max, model.divided);
  if (!edit.camera) edit.camera = viewKeys(fabric.camera);
  view.pointer.reset();
  if (ImGui::IsItemHovered() && !withInset && view.drag == ViewportView::Drag::none) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    view.pointer = placeIn(corner, model.pictureSize, mouse);
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(min, max, false);
  draw.AddRectFilled(min, max, packed(ui.theme.surround));
  const ImVec2 end(corner.x + model.pictureSize.x, corner.y + model.pictureSize.y);
  if (model.picture.texture) draw.AddImage(model.picture.texture, corner, end, ImVec2(0, 0), model.picture.end);
  if (model.divided) boothOverlay(ui, corner, end);
  viewLabels(ui, model, view.inset, min, max);
  edit.inset = insetOverlay(ui, model.inset, view.inset, min, view.width, view.height);
  draw.PopClipRect();

  ImGui::SetCursorScreenPos(ImVec2(min.x + ImGui::GetStyle().WindowPadding.x, max.y + ui.px(8)));
  edit.fabric = quickChoices(ui, fabric, model.plain, view);
  // Another drape has a size, and a camera that looks at it, only when it is shown.
  const bool otherDrape = edit.fabric && edit.fabric->drape != fabric.drape;
  const bool sizeIsKnown = !otherDrape && (!hasOwnExtent(fabric.drape) || model.mesh);
  if (view.fitWanted && sizeIsKnown) {
    edit.camera = fitted(fabric.camera, fabric.drape, size.x / size.y, model.mesh.value_or(MeshExtent{}));
    view.fitWanted = false;
  }
  return edit;
}

}  // namespace loomlight
