#pragma once

#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"

namespace loomlight {

/// Directions of cameras on a half-dome over the cloth's face: the middles of equal steps in azimuth (from +x towards
/// +y, 0 to 360 degrees) and in inclination (from the normal, 0 to 90 degrees).
struct HalfDomeGrid {
  int azimuths = 64;
  int inclinations = 16;
  bool underneath = false;  ///< over the cloth's back instead: the same azimuths, inclinations from the back's normal

  size_t size() const { return static_cast<size_t>(azimuths) * static_cast<size_t>(inclinations); }
  double azimuth_deg(int i) const { return (i + 0.5) * 360.0 / azimuths; }
  double inclination_deg(int j) const { return (j + 0.5) * 90.0 / inclinations; }
};

/// What the cameras of a half-dome see of a patch of cloth: Figs. 11 to 15 of the report. Each camera is one colour,
/// the mean of its picture.
struct HalfDomeMeasure {
  HalfDomeGrid grid;
  std::vector<Rgb> radiance;  ///< inclination by inclination, from the normal down; in each, azimuth by azimuth
  TraceCounts counts;
};

/// The fabric on a flat patch for measureHalfDome: so large that a picture of its middle sees no edge under any
/// inclination of the grid, and hardly any light that came in through one. Its yarns are evenly spun, as it is to stand
/// for all of the cloth.
Fabric halfDomePatch(Fabric fabric, const HalfDomeGrid& grid);

/// Orthographic cameras over the middle of the scene's patch, made by halfDomePatch with the same grid. Their pictures
/// show a square of the cloth of eight crossings or more, seen at a slant. `samples`: paths for each camera, at least;
/// a function of the scene's seed, never of threads. nullopt when stopped.
std::optional<HalfDomeMeasure> measureHalfDome(const Scene& scene, const Medium& medium, const HalfDomeGrid& grid,
                                               int samples, const Task& task);

/// What white paper in place of the cloth would send to every camera: the unit of a reflectance factor. `light` is
/// directional, from above or below, or a UniformLight.
double paperRadiance(const Light& light);

}  // namespace loomlight
