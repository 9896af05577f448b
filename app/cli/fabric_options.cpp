#include "app/cli/fabric_options.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/fabric/model/colourways.h"
#include "core/shell/drape_mesh.h"

namespace loomlight {
namespace {

void applyLight(const LightChoice& choice, Light& light) {
  light.kind = choice.kind;
  light.file = choice.file;
  if (choice.angles) {
    light.azimuth_deg = choice.angles->azimuth_deg;
    light.elevation_deg = choice.angles->elevation_deg;
  } else if (choice.kind == LightKind::sky && light.elevation_deg <= 0) {
    light.elevation_deg = Light{}.elevation_deg;  // of a lamp below the cloth; no sky has its sun there
  }
}

void applyIlluminant(const IlluminantChoice& choice, Light& light) {
  light.illuminant = choice.illuminant;
  light.illuminantFile = choice.file;
  light.temperature_K = choice.temperature_K.value_or(light.temperature_K);
}

Fabric inColourwayNamed(const std::string& name, const Fabric& fabric, const std::string& source) {
  std::string names;
  for (const Colourway& colourway : fabric.colourways) {
    if (colourway.name == name) return inColourway(fabric, colourway);
    names += (names.empty() ? "'" : ", '") + colourway.name + "'";
  }
  throw InputError(fmt::format("{}: colourway '{}': expected {}", source, name,
                               names.empty() ? "one of the fabric's, which has none" : "one of " + names));
}

}  // namespace

Fabric withOptions(Fabric fabric, const FabricOptions& options, const std::string& source) {
  if (!options.colourway.empty()) fabric = inColourwayNamed(options.colourway, fabric, source);
  RenderSettings& render = fabric.render;
  if (options.size) {
    render.width = options.size->width;
    render.height = options.size->height;
  }
  render.samplesPerPixel = options.samplesPerPixel.value_or(render.samplesPerPixel);
  render.seed = options.seed.value_or(render.seed);
  render.resolution = options.resolution.value_or(render.resolution);
  render.maxDepth = options.maxDepth.value_or(render.maxDepth);
  render.method = options.method.value_or(render.method);
  render.estimator = options.estimator.value_or(options.eventLaw ? Estimator::none : render.estimator);
  render.eventLaw = options.eventLaw.value_or(render.eventLaw);

  if (options.drape) {
    fabric.drape.kind = options.drape->kind;
    fabric.drape.file = options.drape->file;
  }
  fabric.drape.grain_deg = options.grain_deg.value_or(fabric.drape.grain_deg);
  fabric.drape.uvScale_mm = options.uvScale_mm.value_or(fabric.drape.uvScale_mm);
  if (options.light) applyLight(*options.light, fabric.light);
  fabric.light.temperature_K = options.temperature_K.value_or(fabric.light.temperature_K);
  if (options.illuminant) applyIlluminant(*options.illuminant, fabric.light);
  render.observer = options.observer.value_or(render.observer);

  auto view = options.view;
  if (!view && options.drape) view = ViewChoice{fabric.camera.azimuth_deg, fabric.camera.elevation_deg, {}, {}};
  if (view) fabric.camera = cameraOf(*view, fabric, makeDrape(fabric.drape));
  return fabric;
}

}  // namespace loomlight
