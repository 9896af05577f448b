#include "core/volume/build/fibre_moments.h"

#include "core/volume/pool/tangent_spread.h"

// How it works. A voxel's fibres are known by the tensor of their tangents, the sum of t t^T by length. Their mean
// direction is its principal axis, found in closed form and not by iteration, four voxels at a time; their spread
// follows from what of the tensor lies along that axis.
namespace loomlight {
namespace {

/// Symmetric tensors.
struct TensorLanes {
  Float64x4 xx, yy, zz, xy, xz, yz;
};
struct VectorLanes {
  Float64x4 x, y, z;
};

VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Float64x4 squareOf(const VectorLanes& a) {
  return a.x * a.x + a.y * a.y + a.z * a.z;
}
void replaceWhere(Int64x4 mask, VectorLanes& a, const VectorLanes& b) {
  a = {mask ? b.x : a.x, mask ? b.y : a.y, mask ? b.z : a.z};
}

/// cos(2/3 arccos u) for u in [0, 1], within 1e-10: the Chebyshev interpolant. The function is analytic but for u = -1.
Float64x4 cosineOfTwoThirds(Float64x4 u) {
  constexpr double c[] = {0.5000000000811,    0.5773502495,      -0.1111103097483,   0.05344544284377,
                          -0.03281303117398,  0.02231990908138,  -0.01527998732616,  0.009378129674463,
                          -0.004485293774699, 0.001402487051647, -0.0002075962534449};
  const Float64x4 u2 = u * u, u4 = u2 * u2;
  const Float64x4 low = (c[0] + c[1] * u) + (c[2] + c[3] * u) * u2;
  const Float64x4 middle = (c[4] + c[5] * u) + (c[6] + c[7] * u) * u2;
  const Float64x4 high = (c[8] + c[9] * u) + c[10] * u2;
  return low + (middle + high * u4) * u4;
}

/// A direction across `rows`, which are all parallel, or all 0.
VectorLanes acrossParallel(const VectorLanes (&rows)[3]) {
  VectorLanes row = rows[0];
  for (const VectorLanes& r : rows) replaceWhere(squareOf(r) > squareOf(row), row, r);
  const Int64x4 flat = magnitude(row.z) <= most(magnitude(row.x), magnitude(row.y));
  const Float64x4 one = broadcast<Float64x4>(1.0);
  VectorLanes across = cross(row, {flat ? Float64x4{} : one, Float64x4{}, flat ? one : Float64x4{}});
  replaceWhere(squareOf(across) == 0, across, {Float64x4{}, Float64x4{}, one});
  return across;
}

/// A voxel's tensor on its way to the principal axis. Work goes in steps, each for all voxels: a processor overlaps
/// what it computes for one with what it computes for the next only as far as it sees ahead, and roots and quotients
/// take long.
struct Fit {
  TensorLanes t;     ///< per length
  Float64x4 p, u;    ///< of the deviator: size, and cosine of half the angle that tells its eigenvalues
  VectorLanes axis;  ///< of any length
};

void findAngles(Fit& fit, const FibreMoments* m) {
  const Float64x4 length{m[0].others[3], m[1].others[3], m[2].others[3], m[3].others[3]}, scale = 1 / length;
  const auto square = [m, scale](int i) {
    return scale * Float64x4{m[0].squares[i], m[1].squares[i], m[2].squares[i], m[3].squares[i]};
  };
  const auto other = [m, scale](int i) {
    return scale * Float64x4{m[0].others[i], m[1].others[i], m[2].others[i], m[3].others[i]};
  };
  fit.t = {square(0), square(1), square(2), square(3), other(0), other(1)};
  const TensorLanes& t = fit.t;
  const Float64x4 xx = t.xx - 1.0 / 3, yy = t.yy - 1.0 / 3, zz = t.zz - 1.0 / 3;
  const Float64x4 p2 = (xx * xx + yy * yy + zz * zz + 2 * (t.xy * t.xy + t.xz * t.xz + t.yz * t.yz)) * (1.0 / 6);
  const Float64x4 det =
      xx * (yy * zz - t.yz * t.yz) - t.xy * (t.xy * zz - t.yz * t.xz) + t.xz * (t.xy * t.yz - yy * t.xz);
  fit.p = squareRoot(p2);
  const Float64x4 halfCosine = 0.25 * det / most(p2 * fit.p, broadcast<Float64x4>(1e-280));
  fit.u = squareRoot(least(most(halfCosine + 0.5, Float64x4{}), broadcast<Float64x4>(1.0)));
}

/// Eigenvectors of the largest eigenvalues; any one of them where several are largest. Closed form (Smith 1961,
/// "Eigenvalues of a symmetric 3 x 3 matrix"); the vectors from cross products.
void findAxes(Fit& fit) {
  const TensorLanes& t = fit.t;
  const Float64x4 largest = 1.0 / 3 + 2 * fit.p * cosineOfTwoThirds(fit.u);
  const VectorLanes rows[3] = {
      {t.xx - largest, t.xy, t.xz}, {t.xy, t.yy - largest, t.yz}, {t.xz, t.yz, t.zz - largest}};
  fit.axis = cross(rows[0], rows[1]);
  Float64x4 best = squareOf(fit.axis);
  for (int i = 1; i < 3; ++i) {
    const VectorLanes c = cross(rows[i], rows[(i + 1) % 3]);
    const Float64x4 size = squareOf(c);
    replaceWhere(size > best, fit.axis, c);
    best = most(size, best);
  }
  // Where the two largest are equal, or all directions alike, nothing but rounding is left of the cross products.
  const Float64x4 p2 = fit.p * fit.p;
  const Int64x4 parallel = best <= most(1e-20 * p2 * p2, broadcast<Float64x4>(1e-40));
  if (any(parallel)) replaceWhere(parallel, fit.axis, acrossParallel(rows));
}

DistributionLanes distributionOf(const Fit& fit, const FibreMoments* m) {
  const TensorLanes& t = fit.t;
  const auto& [x, y, z] = fit.axis;
  const Float64x4 along = x * x * t.xx + y * y * t.yy + z * z * t.zz + 2 * (x * y * t.xy + x * z * t.xz + y * z * t.yz);
  const Float64x4 length{m[0].others[3], m[1].others[3], m[2].others[3], m[3].others[3]};
  return {.x = x,
          .y = y,
          .z = z,
          .spread = TangentSpread::spreadsFromMeanSquareSines(1 - along / squareOf(fit.axis)),
          .lengthDensity = length};
}

}  // namespace

void fitDistributions(const FitBatch& batch, int count, FittedBatch& fitted) {
  std::array<Fit, kFitBatch / kLanes<Float64x4>> fits;
  const int fours = (count + kLanes<Float32x8> - 1) / kLanes<Float32x8> * 2;
  for (int i = 0; i < fours; ++i) findAngles(fits[i], &batch[i * kLanes<Float64x4>]);
  for (int i = 0; i < fours; ++i) findAxes(fits[i]);
  for (int i = 0; i < fours; ++i) fitted[i / 2][i % 2] = distributionOf(fits[i], &batch[i * kLanes<Float64x4>]);
}

double mergeCost(const FibreMoments& a, const FibreMoments& b) {
  const double la = a.length_mm(), lb = b.length_mm();
  const Float64x4 squares = a.squares / la - b.squares / lb, others = a.others / la - b.others / lb;
  const Float64x4 distances = squares * squares * Float64x4{1, 1, 1, 2} + others * others * Float64x4{2, 2, 0, 0};
  return (distances[0] + distances[1] + distances[2] + distances[3]) * la * lb / (la + lb);
}

}  // namespace loomlight
