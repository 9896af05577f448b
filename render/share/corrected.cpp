#include <algorithm>

#include "core/base/parallel.h"
#include "render/share/block_gains.h"
#include "render/share/error_sums.h"
#include "render/share/shared_picture.h"

// How it works. Two pictures of the same are blended: that of cells, which has little noise and an error of its own,
// and the film, which has noise alone. First blocks of pixels of the cells' picture are brightened as the film is,
// or, where that has no samples yet, as coarser ones are (block_gains.h), which takes away what is wrong alike over
// many pixels. How large the error is that is left, is estimated over the whole picture by how much further the two are
// apart than the film's noise explains. A pixel then trusts the film by that error over error and noise, and after so
// many samples alone.

namespace loomlight {
namespace {

/// The square of the cells' own error, as a share of the square of their light.
float relativeError2(const SharedPicture& shared, const Film& film, int threads) {
  constexpr double kVariesBy = 10;  // single paths vary a lot
  std::vector<ErrorSums> rows(static_cast<size_t>(shared.height));
  parallelFor(rows.size(), threads, [&](size_t row) {
    for (int x = 0; x < shared.width; ++x) {
      const uint32_t samples = film.samples(x, static_cast<int>(row));
      if (samples == 0) continue;
      const size_t i = pixelIndex(x, static_cast<int>(row), shared.width);
      const Rgb apart = film.mean(x, static_cast<int>(row)) - shared.light[i];
      rows[row] += {glm::dot(apart, apart), shared.variances[i] / static_cast<float>(samples),
                    glm::dot(shared.light[i], shared.light[i]), 1};
    }
  });
  ErrorSums all;  // row by row, so that they are the same from any number of threads
  for (const ErrorSums& row : rows) all += row;
  return all.relativeError2(kVariesBy);
}

/// To the light that the films know of.
void brighten(SharedPicture& shared, const Film& film, std::span<const CoarseFilm> coarser, int threads) {
  const BlockGains gains(shared, film, coarser, threads);
  parallelFor(static_cast<size_t>(shared.height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < shared.width; ++x) shared.light[pixelIndex(x, y, shared.width)] *= gains.at(x, y);
  });
}

}  // namespace

std::vector<glm::vec4> corrected(SharedPicture shared, const Film& film, std::span<const CoarseFilm> coarser,
                                 uint32_t samplesAlone, int threads) {
  brighten(shared, film, coarser, threads);
  const float error2 = relativeError2(shared, film, threads);
  std::vector<glm::vec4> picture(shared.light.size());
  parallelFor(static_cast<size_t>(shared.height), threads, [&](size_t row) {
    for (int x = 0; x < shared.width; ++x) {
      const int y = static_cast<int>(row);
      const size_t i = pixelIndex(x, y, shared.width);
      const glm::vec4 cells(shared.light[i], shared.alpha[i]);
      const auto samples = static_cast<float>(film.samples(x, y));
      const float alone = std::min(1.0f, samples / static_cast<float>(samplesAlone));
      const float bias = error2 * glm::dot(shared.light[i], shared.light[i]);
      const float trusted = bias > 0 && samples > 0 ? bias / (bias + shared.variances[i] / samples) : 0.0f;
      const float share = alone < 1 ? trusted + (1 - trusted) * alone * alone : 1.0f;
      picture[i] = samples > 0 ? glm::mix(cells, glm::vec4(film.mean(x, y), film.alpha(x, y)), share) : cells;
    }
  });
  return picture;
}

}  // namespace loomlight
