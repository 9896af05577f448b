#include "core/shell/drape_shapes.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/shell/drape_grid.h"

// How it works. Cloth does not stretch, so each drape is a curve by its own length: folds are a line whose slope is a
// sine of the length; a cushion's two middle lines are curves of the piece's width and height, and its surface their
// product; a skirt is a cone over a wavy curve on the unit sphere, as long as the circle that it is cut from. Where
// such a curve has no closed form, it is summed up in small steps and inverted by search.
namespace loomlight {
namespace {

/// A quantity by the length of a curve, at equal steps of what the curve is given by.
class ByLength {
 public:
  /// speed(t): length per t, for t in [from, to].
  template <class Speed>
  ByLength(double from, double to, const Speed& speed) : from_(from), step_((to - from) / kSteps) {
    for (int i = 0; i < kSteps; ++i)
      lengths_[static_cast<size_t>(i) + 1] = lengths_[static_cast<size_t>(i)] + step_ * speed(from + (i + 0.5) * step_);
  }
  double length() const { return lengths_.back(); }
  /// The t at which the curve is that long.
  double at(double length) const {
    const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<size_t>(next - lengths_.begin());
    return from_ + step_ * (static_cast<double>(i) - (lengths_[i] - length) / (lengths_[i] - lengths_[i - 1]));
  }

 private:
  static constexpr int kSteps = 8192;
  double from_, step_;
  std::array<double, kSteps + 1> lengths_{};
};

/// Where a function that rises passes a value, between two arguments.
template <class Rising>
double solve(double low, double high, double value, const Rising& f) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void centre(DrapeMesh& mesh) {
  glm::vec3 lower = mesh.positions.front(), upper = lower;
  for (const glm::vec3& p : mesh.positions) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  for (glm::vec3& p : mesh.positions) p -= 0.5f * (lower + upper);
}

}  // namespace

DrapeMesh foldedDrape(const Drape& drape) {
  constexpr double kSteepest = 1.5;  // radians: not quite upright
  constexpr int kSubsteps = 8;
  constexpr double kFewestFolds = 3;
  const double bend = std::min(drape.radius_mm, drape.width_mm / (2 * kPi * kSteepest * kFewestFolds));
  const double wave = 2 * kPi * kSteepest * bend;
  const int columns = cellsFor(drape.width_mm, facetAcross(bend), 2000);
  const int rows = cellsFor(drape.height_mm, kMaxCellAspect * drape.width_mm / columns, kMaxDrapeCells / columns);
  const double step = drape.width_mm / (columns * kSubsteps);
  const auto slope = [&](double s) { return -kSteepest * std::sin(2 * kPi * (s - drape.width_mm / 2) / wave); };
  std::vector<glm::dvec2> profile{glm::dvec2(0)};
  for (int i = 0; i < columns; ++i) {
    glm::dvec2 p = profile.back();
    for (int k = 0; k < kSubsteps; ++k) {
      const double angle = slope((i * kSubsteps + k + 0.5) * step);
      p += step * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    profile.push_back(p);
  }
  DrapeMesh mesh = gridMesh(drape.width_mm, drape.height_mm, columns, rows, [&](glm::dvec2 uv) {
    const glm::dvec2 p = profile[static_cast<size_t>(std::lround(uv.x / drape.width_mm * columns))];
    const double angle = slope(uv.x);
    return SurfacePoint{{p.x, uv.y, p.y}, {-std::sin(angle), 0, std::cos(angle)}};
  });
  centre(mesh);
  return mesh;
}

DrapeMesh cushionDrape(const Drape& drape) {
  constexpr double kEdge = 0.985, kRoundness = 2.5;  // where the seam is, of the half width of a superellipse
  const double height = std::min(drape.radius_mm, 0.35 * std::min(drape.width_mm, drape.height_mm));
  const auto profile = [](double t) { return std::sqrt(1 - std::pow(std::abs(t), kRoundness)); };
  const auto slope = [&](double t) {
    return -0.5 * kRoundness * std::copysign(std::pow(std::abs(t), kRoundness - 1), t) / profile(t);
  };
  // Of half width `half`, the line over the middle.
  const auto line = [&](double half) {
    return ByLength(-kEdge, kEdge, [&, half](double t) { return std::hypot(half, height * slope(t)); });
  };
  const auto halfOf = [&](double length) {
    return solve(0, length, length, [&](double half) { return line(half).length(); });
  };
  const glm::dvec2 half(halfOf(drape.width_mm), halfOf(drape.height_mm));
  const ByLength alongX = line(half.x), alongY = line(half.y);
  const double cell = facetAcross(0.25 * height);  // bends most at the seam
  // An even number, so that a line of vertices runs over the top.
  const auto cells = [&](double length) { return 2 * cellsFor(length / 2, cell, 200); };
  DrapeMesh mesh =
      gridMesh(drape.width_mm, drape.height_mm, cells(drape.width_mm), cells(drape.height_mm), [&](glm::dvec2 uv) {
        const glm::dvec2 t(alongX.at(uv.x), alongY.at(uv.y));
        const glm::dvec2 f(profile(t.x), profile(t.y));
        const glm::dvec2 rise = height * glm::dvec2(slope(t.x) * f.y, f.x * slope(t.y)) / half;
        return SurfacePoint{glm::dvec3(half * t, height * f.x * f.y), glm::normalize(glm::dvec3(-rise, 1))};
      });
  centre(mesh);
  if (height < drape.radius_mm)
    mesh.repairs.push_back(
        fmt::format("drape.radius_mm: a cushion of {:g} x {:g} mm is at most {:.4g} mm high, not {:g}", drape.width_mm,
                    drape.height_mm, height, drape.radius_mm));
  return mesh;
}

DrapeMesh skirtDrape(const Drape& drape) {
  constexpr int kFlutes = 6;
  constexpr double kFlare = 50 * kPi / 180;  // from the axis
  // The skirt is a cone over a curve on the unit sphere as long as the circle that it is cut from.
  const auto flare = [](double turn, double depth) { return kFlare + depth * std::cos(kFlutes * turn); };
  const auto speed = [&](double turn, double depth) {
    return std::hypot(kFlutes * depth * std::sin(kFlutes * turn), std::sin(flare(turn, depth)));
  };
  const auto curve = [&](double depth) {
    return ByLength(0, 2 * kPi, [&, depth](double turn) { return speed(turn, depth); });
  };
  const double depth = solve(0, 0.5, 2 * kPi, [&](double d) { return curve(d).length(); });
  const ByLength around = curve(depth);
  const double waist = drape.radius_mm, hem = waist + drape.height_mm;

  // Cells may be longer where they are wider, so they grow towards the hem, and there are fewer of them. The surface is
  // the same, since two straight lines to the cone's tip span a plane.
  constexpr int kRows = 1500;  // each turns by 1.5 degrees at most, about
  // Length of a cell over its width. Longer ones lie across one another's boxes: at 64 rays took a fifth longer.
  constexpr double kCellAspect = 32;
  static_assert(kCellAspect <= kMaxCellAspect);
  const double growth = 1 + kCellAspect * 2 * kPi / kRows;
  const int columns = cellsFor(std::log(hem / waist), std::log(growth), kMaxDrapeCells / kRows);
  const auto radiusAt = [&](double column) { return waist * std::pow(hem / waist, column / columns); };
  // The circle closes: its last row is its first.
  const auto cut = [](double y) { return y >= 2 * kPi ? 0.0 : y; };
  DrapeMesh mesh = gridMesh(columns, 2 * kPi, columns, kRows, [&](glm::dvec2 uv) {
    const double turn = around.at(cut(uv.y)), angle = flare(turn, depth);
    const glm::dvec3 out(std::cos(turn), std::sin(turn), 0), side(-out.y, out.x, 0);
    const glm::dvec3 ray = std::sin(angle) * out - glm::dvec3(0, 0, std::cos(angle));
    const double opening = -kFlutes * depth * std::sin(kFlutes * turn);  // of the angle, by the turn
    const glm::dvec3 along =
        std::sin(angle) * side + opening * (std::cos(angle) * out + glm::dvec3(0, 0, std::sin(angle)));
    return SurfacePoint{radiusAt(uv.x) * ray, glm::normalize(glm::cross(ray, along))};
  });
  for (glm::vec2& uv : mesh.uv_mm) {
    const double radius = radiusAt(uv.x), angle = cut(uv.y);
    uv = glm::dvec2(hem + radius * std::cos(angle), hem + radius * std::sin(angle));
  }
  centre(mesh);
  return mesh;
}

}  // namespace loomlight
