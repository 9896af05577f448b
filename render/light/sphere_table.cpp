#include "render/light/sphere_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

// How it works. The sphere is cut into rows of equal angle and each row into cells. A draw inverts the cumulative power
// of the rows, then that within the row, and takes a point of the cell evenly by solid angle. Cumulative shares are
// whole numbers of 2^-31, so that density and draw agree exactly.

namespace loomlight {
namespace {

constexpr double kShares = 0x1p31;

/// Cumulative shares of `count` weights, at least 0; all zero: equal shares.
template <class Weight>
void accumulate(int count, double total, uint32_t* shares, Weight&& weight) {
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    sum += total > 0 ? weight(i) / total : 1.0 / count;
    shares[i] = static_cast<uint32_t>(std::llround(std::min(sum, 1.0) * kShares));
  }
  shares[count - 1] = static_cast<uint32_t>(kShares);
}

uint32_t share(const uint32_t* cumulative, int i) {
  return cumulative[i] - (i > 0 ? cumulative[i - 1] : 0);
}

/// The first whose cumulative share is more than a random number of 31 bits. By halves and without a branch: no
/// processor could foretell where the number falls.
int draw(const uint32_t* cumulative, int count, Random& random) {
  const uint32_t u = random.bits() >> 1;
  const uint32_t* first = cumulative;
  for (int rest = count; rest > 1;) {
    const int half = rest / 2;
    first += first[half - 1] <= u ? half : 0;
    rest -= half;
  }
  return static_cast<int>(first - cumulative);
}

}  // namespace

SphereTable::SphereTable(int width, int height, const std::vector<float>& radiance)
    : width_(width),
      height_(height),
      rows_(static_cast<size_t>(height)),
      cells_(static_cast<size_t>(width) * static_cast<size_t>(height)),
      cosines_(static_cast<size_t>(height) + 1) {
  assert(radiance.size() == cells_.size());
  for (int y = 0; y <= height; ++y) cosines_[static_cast<size_t>(y)] = static_cast<float>(std::cos(kPi * y / height));
  std::vector<double> rowPower(rows_.size());
  for (int y = 0; y < height; ++y) {
    const size_t first = static_cast<size_t>(y) * static_cast<size_t>(width);
    const auto value = [&](int x) { return static_cast<double>(radiance[first + static_cast<size_t>(x)]); };
    double sum = 0;
    for (int x = 0; x < width; ++x) sum += value(x);
    accumulate(width, sum, &cells_[first], value);
    const double height_cos = cosines_[static_cast<size_t>(y)] - cosines_[static_cast<size_t>(y) + 1];
    rowPower[static_cast<size_t>(y)] = sum * height_cos * (2 * kPi / width);
    power_ += rowPower[static_cast<size_t>(y)];
  }
  // An all-black table is drawn from uniformly: rows by their solid angle.
  accumulate(height, power_ > 0 ? power_ : 2.0, rows_.data(), [&](int y) {
    const size_t i = static_cast<size_t>(y);
    return power_ > 0 ? rowPower[i] : static_cast<double>(cosines_[i] - cosines_[i + 1]);
  });
}

SphereTable::Sample SphereTable::sample(Random& random) const {
  const int y = draw(rows_.data(), height_, random);
  const int x = draw(row(y), width_, random);
  const float top = cosines_[static_cast<size_t>(y)], bottom = cosines_[static_cast<size_t>(y) + 1];
  const float cosTheta = bottom + (top - bottom) * random.uniform();
  const float u = (static_cast<float>(x) + random.uniform()) / static_cast<float>(width_);
  return {latLongDirection(u, cosTheta), cellPdf(x, y)};
}

float SphereTable::pdf(glm::vec3 d) const {
  return cellPdf(cellOf(latLongU(d), width_), cellOf(latLongV(d), height_));
}

float SphereTable::cellPdf(int x, int y) const {
  const float rowShare = static_cast<float>(share(rows_.data(), y)), cellShare = static_cast<float>(share(row(y), x));
  const float solidAngle = (cosines_[static_cast<size_t>(y)] - cosines_[static_cast<size_t>(y) + 1]) *
                           static_cast<float>(2 * kPi) / static_cast<float>(width_);
  return rowShare * cellShare * 0x1p-62f / solidAngle;
}

}  // namespace loomlight
