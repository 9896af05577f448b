#include "render/display/recolour.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

// How it works. Paths on record say what light they would bring in the other colours. Where all of a pixel's samples
// are on record, that is its new colour. Elsewhere the film's colour is multiplied by the ratio of new to old light,
// over the pixels around that show the same yarn: both lights come along the same paths, so the ratio has little noise.
// A channel too weak for a ratio gets the difference of both instead, which has as little (a control variate). The
// variance of either follows from the samples' second moments.

namespace loomlight {
namespace {

/// Samples on record of some pixels, as PathRecords::Sums.
struct Pool {
  Rgb traced{0}, recoloured{0};
  Rgb tracedTraced{0}, tracedRecoloured{0}, recolouredRecoloured{0};
  float samples = 0, freedom = 0;

  void add(const PathRecords::Sums& s) {
    traced += s.traced;
    recoloured += s.recoloured;
    tracedTraced += s.tracedTraced;
    tracedRecoloured += s.tracedRecoloured;
    recolouredRecoloured += s.recolouredRecoloured;
    samples += static_cast<float>(s.samples);
    if (s.samples > 1) freedom += static_cast<float>(s.samples - 1);
  }
};

/// How brightly lamps shine beside others. One that is off shows nothing in any colours.
Rgb brightness(const Light& from, const Light& to) {
  if (!(from.intensity > 0)) return Rgb(1);
  return static_cast<float>(to.intensity / from.intensity) * Lighting::tint(to) / Lighting::tint(from);
}

/// Of the luminance, from that of the channels, whose noise is that of the paths and hence nearly the same.
double luminanceVariance(Rgb variance) {
  const Rgb deviation = glm::sqrt(glm::max(variance, Rgb(0.0f)));
  const double ofAll = luminance(glm::dvec3(deviation));
  return ofAll * ofAll;
}

}  // namespace

Recolouring recolouringTo(const Fabric& wanted, const Light& traced) {
  return {colouringOf(wanted), brightness(traced, wanted.light)};
}

std::optional<Recolouring> recolouringBetween(const Scene& traced, const Scene& wanted, const Changes& edit) {
  const Light& from = traced.fabric->light;
  if (!edit.stages.within(Stage::colour | Stage::brightness | Stage::label) || !(from.intensity > 0))
    return std::nullopt;
  return Recolouring{wanted.colouring, brightness(from, wanted.fabric->light)};
}

LightChange changeOfLight(Rgb from, Rgb to, Rgb lamps) {
  constexpr float kHardlyAny = 0.15f;  // of the luminance: as the green of scarlet has
  const float all = luminance(from);
  LightChange change{lamps};
  if (!(all > 0)) return change;
  for (int channel = 0; channel < 3; ++channel) {
    if (from[channel] > kHardlyAny * all)
      change.factor[channel] = to[channel] / from[channel];
    else
      change.more[channel] = (to[channel] - lamps[channel] * from[channel]) / all;
  }
  return change;
}

Recoloured recolour(const Film& film, const PathRecords& records, const Recolouring& recolouring, int threads) {
  const int width = film.width(), height = film.height();
  const std::vector<PathRecords::Sums> sums = records.recoloured(recolouring, threads);
  const auto at = [&](int x, int y) -> const PathRecords::Sums& { return sums[pixelIndex(x, y, width)]; };

  std::vector<int> yarns(sums.size());
  const auto yarnAt = [&](int x, int y) -> int& { return yarns[pixelIndex(x, y, width)]; };
  parallelFor(static_cast<size_t>(height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) yarnAt(x, y) = film.hit(x, y).yarn;
  });

  Recoloured result;
  result.rgba.resize(sums.size());
  result.change.resize(sums.size());
  std::vector<double> variances(static_cast<size_t>(height));
  parallelFor(variances.size(), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const int yarn = yarnAt(x, y);
      const PathRecords::Sums& own = at(x, y);
      Pool around;
      for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
          if (yarnAt(u, v) == yarn) around.add(at(u, v));
      const bool complete = own.samples > 0 && own.samples == film.samples(x, y);
      const LightChange change = changeOfLight(around.traced, around.recoloured, recolouring.light);
      const Rgb colour = complete ? own.recoloured / static_cast<float>(own.samples) : change(film.mean(x, y));
      const size_t i = pixelIndex(x, y, width);
      result.rgba[i] = glm::vec4(colour, film.alpha(x, y));
      result.change[i] = change;
      if (around.freedom <= 0) continue;
      const Rgb& factor = change.factor;
      const Rgb ofFilm = factor * factor * around.tracedTraced / static_cast<float>(film.samples(x, y));
      const Rgb ofChange = (around.recolouredRecoloured - 2.0f * factor * around.tracedRecoloured +
                            factor * factor * around.tracedTraced) /
                           around.samples;
      const Rgb all = around.recolouredRecoloured / static_cast<float>(std::max(1u, own.samples));
      variances[row] += luminanceVariance((complete ? all : ofFilm + ofChange) / around.freedom);
    }
  });
  for (const double variance : variances) result.variance += variance / static_cast<double>(sums.size());
  return result;
}

double meanVariance(const Film& film) {
  double sum = 0;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) sum += film.variance(x, y);
  return sum / (static_cast<double>(film.width()) * film.height());
}

}  // namespace loomlight
