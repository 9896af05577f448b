// How it works. Around where it stands the residuals are taken to be linear, r + J d. The step d that makes their
// squares least is solved for by Cholesky's factors of (JtJ + damping diag(JtJ)) d = -Jt r. A step that makes things
// worse is not taken, and the next one is shorter for more damping; one that helps is, and the next may be longer.
// Unknowns at a bound that a step would carry past it stand still, and the others' step is solved for without them.
#include "app/export/handover/least_squares.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loomlight {
namespace {

using Numbers = std::vector<double>;

double squares(const Numbers& r) {
  double sum = 0;
  for (const double x : r) sum += x * x;
  return sum;
}

/// Solves A x = b, A symmetric, n x n row by row; nothing where it is not positive definite.
std::optional<Numbers> solved(Numbers a, Numbers b) {
  const size_t n = b.size();
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j <= i; ++j) {
      double sum = a[i * n + j];
      for (size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      if (i == j && !(sum > 0)) return std::nullopt;
      a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
    }
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < i; ++k) b[i] -= a[i * n + k] * b[k];
    b[i] /= a[i * n + i];
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; ++k) b[i] -= a[k * n + i] * b[k];
    b[i] /= a[i * n + i];
  }
  return b;
}

/// JtJ and Jt r.
struct Normal {
  Numbers matrix, gradient;
};

Normal normalAt(std::span<const Unknown> unknowns, const Numbers& at, const Numbers& r,
                const std::function<Numbers(std::span<const double>)>& residuals) {
  const size_t n = at.size();
  std::vector<Numbers> columns;
  for (size_t i = 0; i < n; ++i) {
    const double step = 1e-3 * (unknowns[i].high - unknowns[i].low);
    Numbers moved = at;
    moved[i] += at[i] + step <= unknowns[i].high ? step : -step;
    columns.push_back(residuals(moved));
    for (size_t k = 0; k < r.size(); ++k) columns[i][k] = (columns[i][k] - r[k]) / (moved[i] - at[i]);
  }
  Normal normal{Numbers(n * n), Numbers(n)};
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < r.size(); ++k) normal.gradient[i] += columns[i][k] * r[k];
    for (size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (size_t k = 0; k < r.size(); ++k) sum += columns[i][k] * columns[j][k];
      normal.matrix[i * n + j] = normal.matrix[j * n + i] = sum;
    }
  }
  return normal;
}

/// Where a damped step leads. `scale`: what an unknown's own square is damped by at least, so that one that does not
/// matter here stays where it is.
Numbers stepped(std::span<const Unknown> unknowns, const Numbers& at, const Normal& normal, double damping) {
  const size_t n = at.size();
  double scale = 1e-12;
  for (size_t i = 0; i < n; ++i) scale = std::max(scale, 1e-9 * normal.matrix[i * n + i]);
  Numbers matrix = normal.matrix, right(n);
  for (size_t i = 0; i < n; ++i) {
    const bool held =
        (at[i] <= unknowns[i].low && normal.gradient[i] > 0) || (at[i] >= unknowns[i].high && normal.gradient[i] < 0);
    right[i] = held ? 0 : -normal.gradient[i];
    if (held)
      for (size_t j = 0; j < n; ++j) matrix[i * n + j] = matrix[j * n + i] = 0;
    matrix[i * n + i] += damping * normal.matrix[i * n + i] + scale;
  }
  Numbers next = at;
  if (const auto step = solved(std::move(matrix), std::move(right)))
    for (size_t i = 0; i < n; ++i) next[i] = std::clamp(at[i] + (*step)[i], unknowns[i].low, unknowns[i].high);
  return next;
}

}  // namespace

LeastSquares leastSquares(std::span<const Unknown> unknowns,
                          const std::function<std::vector<double>(std::span<const double>)>& residuals, int mostSteps) {
  constexpr double kLeastDamping = 1e-9, kMostDamping = 1e9, kLeastGain = 1e-6;
  LeastSquares fit;
  for (const Unknown& unknown : unknowns) fit.values.push_back(std::clamp(unknown.start, unknown.low, unknown.high));
  Numbers r = residuals(fit.values);
  fit.sum = squares(r);
  double damping = 1e-3;
  while (fit.steps < mostSteps && fit.sum > 0) {
    const Normal normal = normalAt(unknowns, fit.values, r, residuals);
    const double before = fit.sum;
    for (; damping <= kMostDamping; damping *= 10) {
      Numbers next = stepped(unknowns, fit.values, normal, damping);
      Numbers nextResiduals = residuals(next);
      const double sum = squares(nextResiduals);
      if (!(sum < fit.sum)) continue;
      fit.values = std::move(next);
      fit.sum = sum;
      r = std::move(nextResiduals);
      break;
    }
    damping = std::clamp(0.1 * damping, kLeastDamping, kMostDamping);
    ++fit.steps;
    if (before - fit.sum < kLeastGain * before) break;
  }
  return fit;
}

}  // namespace loomlight
