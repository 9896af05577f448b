#pragma once

#include <optional>
#include <vector>

#include "core/base/rgb.h"
#include "core/fabric/model/changes.h"
#include "render/film/film.h"
#include "render/scene/scene.h"
#include "render/transport/path_records.h"

namespace loomlight {

/// The colours of the wanted fabric, for a picture that was traced in that light.
Recolouring recolouringTo(const Fabric& wanted, const Light& traced);
/// What makes the picture of one scene that of the other: nullopt where the edit between them has changed more than how
/// much fibres absorb and how brightly and of which colour the lamps shine.
std::optional<Recolouring> recolouringBetween(const Scene& traced, const Scene& wanted, const Changes& edit);

/// What becomes of light that is much like light that is known in both colours.
struct LightChange {
  Rgb factor{1};  ///< of each channel
  Rgb more{0};    ///< beside that, for each unit of luminance

  Rgb operator()(Rgb light) const { return factor * light + luminance(light) * more; }
  glm::vec4 operator()(const glm::vec4& light) const { return {(*this)(Rgb(light)), light.a}; }
};
/// From one light to the other: their ratio, channel by channel. A channel that has hardly any light, or less than
/// none, has no ratio that noise would leave alone: it changes as the lamps do, and what is more or less of it than
/// that goes with the luminance. Where there is no light to compare, nothing is known but the lamps.
LightChange changeOfLight(Rgb from, Rgb to, Rgb lamps);

/// A picture in other colours than it was traced in.
struct Recoloured {
  std::vector<glm::vec4> rgba;      ///< linear, premultiplied; row by row from the top left
  std::vector<LightChange> change;  ///< of the light around each pixel on the same yarn, to what was traced
  double variance = 0;              ///< of the luminance, mean over the pixels
};

/// Answers from the records of a film what it would look like had it been traced with this dye. Pixels whose samples
/// are all on record are exactly that. Where the film has more, it is multiplied by the ratio of the two colours among
/// the samples on record, those of pixels around on the same yarn too: a ratio estimator (Cochran 1977, chapter 6),
/// nearly as free of noise as the film, and exactly the film in that light when only the lamps change.
Recoloured recolour(const Film& film, const PathRecords& records, const Recolouring& recolouring, int threads);

/// Variance of the luminance, mean over the pixels: what Recoloured::variance is to be compared with. 0 with fewer than
/// two samples.
double meanVariance(const Film& film);

}  // namespace loomlight
