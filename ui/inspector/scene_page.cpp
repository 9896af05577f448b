#include <fmt/format.h>

#include "ui/inspector/inspector.h"
#include "ui/widgets/choices.h"
#include "ui/widgets/member_fields.h"
#include "ui/words/scene_words.h"

namespace loomlight {
namespace {

/// The resolutions that a volume can have, and where they are in the list.
constexpr const char* kResolutionNames[] = {"1", "2", "4", "8", "16"};

bool resolutionRow(Ui& ui, RenderSettings& render) {
  int chosen = -1;
  for (int i = 0; i < 5; ++i)
    if (render.resolution == 1 << i) chosen = i;
  if (!segmentField(ui, rowText("scene", &RenderSettings::resolution), kResolutionNames, chosen)) return false;
  render.resolution = 1 << chosen;
  return true;
}

bool lightRows(Ui& ui, Light& light, const std::optional<StandardIlluminant>& ownLamp, InspectorResult& result) {
  const LightKind before = light.kind;
  bool changed = memberChoice(ui, "light", light, &Light::kind, lightNames(light));
  if (light.kind != before) light = withKind(light, light.kind);
  changed |= memberField(ui, "light", light, &Light::intensity, 2);
  changed |= memberChoice(ui, "light", light, &Light::illuminant, illuminantNames(light));
  if (ownLamp) quietLine(ui, "light.own_lamp", fmt::format(words::scenePage::onlyToJudge, lampWord(*ownLamp)));
  changed |= memberField(ui, "light", light, &Light::temperature_K, 0);
  const bool aimed = light.kind == LightKind::sky || light.kind == LightKind::directional;
  const bool turns = aimed || light.kind == LightKind::environment || light.kind == LightKind::window ||
                     light.kind == LightKind::booth;
  if (turns) changed |= memberField(ui, "light", light, &Light::azimuth_deg, 0, 1);
  if (aimed) changed |= memberField(ui, "light", light, &Light::elevation_deg, 0, 0.5);
  if (light.kind == LightKind::sky) changed |= memberField(ui, "light", light, &Light::turbidity, 1);
  const Word& choose = words::scenePage::chooseEnvironment;
  if (button(ui, "light.browse", choose.label, 0, true, choose.help)) result.command = Command::chooseEnvironment;
  return changed;
}

bool drapeRows(Ui& ui, Drape& drape, InspectorResult& result) {
  bool changed = memberChoice(ui, "drape", drape, &Drape::kind, drapeNames(drape));
  if (drape.kind == DrapeKind::mesh) {
    changed |= memberField(ui, "drape", drape, &Drape::uvScale_mm, 2);
  } else {
    if (drape.kind != DrapeKind::skirt) changed |= memberField(ui, "drape", drape, &Drape::width_mm, 1);
    changed |= memberField(ui, "drape", drape, &Drape::height_mm, 1);
    if (drape.kind != DrapeKind::flat) changed |= memberField(ui, "drape", drape, &Drape::radius_mm, 1);
  }
  if (drape.kind != DrapeKind::flat) changed |= memberField(ui, "drape", drape, &Drape::grain_deg, 0, 1);
  const Word& choose = words::scenePage::chooseMesh;
  if (button(ui, "drape.browse", choose.label, 0, true, choose.help)) result.command = Command::chooseMesh;
  return changed;
}

bool cameraRows(Ui& ui, Camera& camera) {
  bool changed = memberField(ui, "camera", camera, &Camera::azimuth_deg, 0, 1);
  changed |= memberField(ui, "camera", camera, &Camera::elevation_deg, 0, 0.5);
  changed |= memberField(ui, "camera", camera, &Camera::distance_mm, 1);
  changed |= memberField(ui, "camera", camera, &Camera::fov_deg, 0, 0.2);
  return changed;
}

}  // namespace

InspectorResult scenePage(Ui& ui, const Fabric& fabric, const InspectorModel& model) {
  InspectorResult result;
  Light light = fabric.light;
  Drape drape = fabric.drape;
  Camera camera = fabric.camera;
  RenderSettings render = fabric.render;
  heading(ui, words::scenePage::light);
  bool changed = lightRows(ui, light, model.ownLamp, result);
  heading(ui, words::scenePage::drape);
  changed |= drapeRows(ui, drape, result);
  heading(ui, words::scenePage::camera);
  if (cameraRows(ui, camera)) result.camera = camera;
  heading(ui, words::scenePage::detail);
  changed |= resolutionRow(ui, render);
  changed |= memberChoice(ui, "scene", render, &RenderSettings::observer, observerNames());
  changed |= memberChoice(ui, "scene", render, &RenderSettings::method, methodNames());
  if (render.method == Method::volume) {
    changed |= memberChoice(ui, "scene", render, &RenderSettings::estimator, estimatorNames());
    if (render.estimator == Estimator::none)
      changed |= memberChoice(ui, "scene", render, &RenderSettings::eventLaw, eventLawNames());
  }
  if (!changed) return result;
  result.fabric = fabric;
  result.fabric->light = light;
  result.fabric->drape = drape;
  result.fabric->render = render;
  return result;
}

}  // namespace loomlight
