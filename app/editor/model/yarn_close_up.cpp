#include "app/editor/model/yarn_close_up.h"

#include <algorithm>

#include "core/fabric/model/height_seen.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {

Fabric yarnCloseUp(const Fabric& fabric, int yarn, int width, int height) {
  Fabric alone;
  alone.name = "close-up";
  alone.fibres = fabric.fibres;
  alone.yarns = {fabric.yarns[static_cast<size_t>(yarn)]};
  alone.yarns[0].name.clear();
  for (Fibre& fibre : alone.fibres) fibre.name.clear();
  // One end that always lies over its picks, and these so far apart that the picture shows none.
  constexpr double kPitchDiameters = 8, kSeenDiameters = 2.4;
  const double diameter_mm = yarnDiameter_mm(alone.yarns[0], meanFibre(alone.yarns[0], alone.fibres));
  // A piece is a millimetre wide at least, and a second end in it would leave its middle free.
  constexpr double kNarrowest_mm = 1;
  const double pitch_mm = std::clamp(kPitchDiameters * diameter_mm, kNarrowest_mm, 50.0);
  alone.weave = Weave(std::vector<Weave::Row>{{1}});
  alone.ends_per_cm = alone.picks_per_cm = 10 / pitch_mm;
  alone.press = 0;
  alone.drape.width_mm = pitch_mm;
  alone.drape.height_mm = 2 * pitch_mm;
  alone.camera.azimuth_deg = 0;  // so that the yarn runs from left to right
  alone.camera.elevation_deg = 75;
  alone.camera.distance_mm = std::clamp(kSeenDiameters * diameter_mm / heightSeenPerDistance(alone.camera), 0.1, 1e5);
  alone.light.azimuth_deg = 60;
  alone.light.elevation_deg = 50;
  alone.render.width = width;
  alone.render.height = height;
  alone.render.samplesPerPixel = 48;
  alone.render.resolution = 1;
  alone.render.method = Method::fibres;
  return alone;
}

}  // namespace loomlight
