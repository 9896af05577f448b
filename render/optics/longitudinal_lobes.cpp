#include "render/optics/longitudinal_lobes.h"

#include <numeric>

#include "render/optics/dielectric_cylinder.h"

// How it works. The header has the law, and with it an equation for a(): energy that leaves must be the share of the
// mode in every direction. It is solved at the nodes of a quadrature by Sinkhorn's scaling, in which each a is replaced
// by the geometric mean of itself and of what would satisfy its own equation; some dozens of rounds are enough. Tables
// over the cosine are then read off the equation itself. All of it happens once for a kind of fibre.
namespace loomlight::optics {
namespace {

/// Shares of the modes, averaged over the offset h, by the midpoint rule in its arcsine: periodic and smooth.
class MeanShares {
 public:
  explicit MeanShares(double index) : index_(static_cast<float>(index)) {
    for (size_t k = 0; k < kPoints; ++k) {
      const double gamma = 0.5 * kPi * (static_cast<double>(k) + 0.5) / kPoints;
      offset_[k] = static_cast<float>(std::sin(gamma));
      weight_[k] = static_cast<float>(std::cos(gamma));
    }
  }
  /// Of light whose inclination has this cosine.
  Float32x4 at(double cosine) const {
    const auto sine = static_cast<float>(std::sqrt(std::max(0.0, 1 - cosine * cosine)));
    Float32x4 sum{};
    float weights = 0;
    for (size_t k = 0; k < kPoints; ++k) {
      const CylinderHit<float> hit({sine, static_cast<float>(cosine), 0}, offset_[k], index_);
      sum += weight_[k] * Float32x4{hit.share[0], hit.share[1], hit.share[2], hit.share[3]};
      weights += weight_[k];
    }
    return sum / weights;
  }

 private:
  static constexpr size_t kPoints = 24;
  float index_;
  std::array<float, kPoints> offset_, weight_;
};

double normOf(double v) {
  return 1 / (v * -std::expm1(-2 / v));
}

/// A quadrature rule over inclinations that weighs M(o, i) cos_i^2; functions of i are taken as even. Continued over
/// the poles M is periodic and smooth, so that the midpoint rule converges exponentially once its step is below the
/// width of the lobe; the lower bound on its points is for the shares, which change fast near the poles.
class Quadrature {
 public:
  explicit Quadrature(double variance)
      : variance_(variance), size_(static_cast<size_t>(std::clamp(0.25 * kPi / std::sqrt(variance), 32.0, 64.0)) * 4) {
    const double step = 0.5 * kPi / static_cast<double>(size_);
    for (size_t k = 0; k < size_; ++k) {
      const double theta = (static_cast<double>(k) + 0.5) * step;
      sine_.push_back(static_cast<float>(std::sin(theta)));
      cosine_.push_back(static_cast<float>(std::cos(theta)));
      weight_.push_back(normOf(variance) * step * std::cos(theta) * std::cos(theta));
    }
  }
  size_t size() const { return size_; }
  double cosine(size_t k) const { return static_cast<double>(cosine_[k]); }

  /// Weights for an o of this cosine: the integral of f(i) M(o, i) cos_i^2 is the sum of f times these.
  void weights(double cosine, double* result) const {
    const auto c = static_cast<float>(cosine), s = static_cast<float>(std::sqrt(1 - cosine * cosine));
    const auto inverse = static_cast<float>(1 / variance_);
    for (size_t k = 0; k < size_; k += 4) {
      Float32x4 si{}, ci{}, root{};
      for (size_t lane = 0; lane < 4; ++lane) {
        si[lane] = sine_[k + lane];
        ci[lane] = cosine_[k + lane];
        root[lane] = std::sqrt(c * ci[lane] * inverse);
      }
      const BesselI0<Float32x4> bessel = besselI0(root);
      const auto side = [&](Float32x4 difference) {
        const Float32x4 versine = 0.5f * (difference * difference + (c - ci) * (c - ci));
        return bessel.factor * exponential(-bessel.rest - versine * inverse);
      };
      const Float32x4 both = side(s - si) + side(s + si);
      for (size_t lane = 0; lane < 4; ++lane) result[k + lane] = weight_[k + lane] * static_cast<double>(both[lane]);
    }
  }

 private:
  double variance_;
  size_t size_;
  std::vector<float> sine_, cosine_;
  std::vector<double> weight_;
};

/// a() of a mode at the nodes, by Sinkhorn's scaling.
std::vector<double> scaling(const Quadrature& nodes, const MeanShares& shares, size_t mode) {
  const size_t n = nodes.size();
  std::vector<double> share(n), a(n), sums(n), matrix(n * n);
  for (size_t k = 0; k < n; ++k) {
    share[k] = shares.at(nodes.cosine(k))[mode];
    a[k] = std::sqrt(share[k] / nodes.cosine(k));  // the solution for narrow lobes, away from the poles
    nodes.weights(nodes.cosine(k), &matrix[k * n]);
  }
  double worst = 1;
  for (int iteration = 0; iteration < 200 && worst > 1e-7; ++iteration) {
    for (size_t k = 0; k < n; ++k) sums[k] = std::inner_product(a.begin(), a.end(), &matrix[k * n], 0.0);
    worst = 0;
    for (size_t k = 0; k < n; ++k) {
      worst = std::max(worst, std::abs(a[k] * sums[k] / share[k] - 1));
      a[k] = std::sqrt(a[k] * share[k] / sums[k]);
    }
  }
  return a;
}

}  // namespace

LongitudinalLobes::LongitudinalLobes(double roughness, double index, double scaleTilt_rad)
    : tilted_(scaleTilt_rad != 0), outgoing_(kRows + 2), incoming_(kRows + 2) {
  // The scales turn the mirror cone of each mode by a different multiple of their angle (Marschner et al. 2003).
  constexpr double shifts[kModes] = {-2, 1, 4, 0};
  // Variance by roughness (Chiang et al. 2016, Eq. 7), and of the other modes relative to R (Marschner et al. 2003).
  const double b = roughness;
  const double root = 0.726 * b + 0.812 * b * b + 3.7 * std::pow(b, 20);
  constexpr double relative[kModes] = {1, 0.25, 4, 4};
  const MeanShares shares(index);
  std::vector<Float32x4> rowShares(kRows + 1);
  for (size_t row = 0; row <= kRows; ++row) rowShares[row] = shares.at(static_cast<double>(row) / kRows);
  for (size_t mode = 0; mode < kModes; ++mode) {
    const double tilt = shifts[mode] * scaleTilt_rad;
    tilt_[mode] = {static_cast<float>(std::sin(tilt)), static_cast<float>(std::cos(tilt))};
    const double v = relative[mode] * root * root;
    inverseVariance_[mode] = static_cast<float>(1 / v);
    inverseDeviation_[mode] = static_cast<float>(1 / std::sqrt(v));
    norm_[mode] = static_cast<float>(normOf(v));
    const Quadrature nodes(v);
    const std::vector<double> a = scaling(nodes, shares, mode);
    // The equation itself continues the solution from the nodes to any angle.
    std::vector<double> weights(nodes.size());
    for (size_t row = 0; row <= kRows; ++row) {
      nodes.weights(static_cast<double>(row) / kRows, weights.data());
      const double sum = std::inner_product(a.begin(), a.end(), weights.begin(), 0.0);
      outgoing_[row][mode] = static_cast<float>(1 / sum);
      incoming_[row][mode] = static_cast<float>(rowShares[row][mode] / sum);
    }
    outgoing_[kRows + 1] = outgoing_[kRows];
    incoming_[kRows + 1] = incoming_[kRows];
    variance_[mode] = static_cast<float>(v);
    for (size_t row = 1; row <= kRows; ++row) {
      // Between two rows a * cosine is at most the larger a times the larger cosine.
      const float largest = std::max(incoming_[row - 1][mode], incoming_[row][mode]);
      bound_[mode] = std::max(bound_[mode], largest * static_cast<float>(row) / kRows);
    }
  }
}

}  // namespace loomlight::optics
