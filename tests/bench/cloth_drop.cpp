#include "tests/bench/cloth_drop.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/random.h"
#include "core/shell/mesh_file.h"
#include "core/shell/mesh_repair.h"

namespace loomlight {
namespace {

constexpr double kGravity = 9810.0;  // mm/s^2
constexpr double kStep = 1.0 / 2500.0;
constexpr double kAirDrag = 3.0;   // 1/s
constexpr double kFriction = 0.9;  // share of the sliding that contact takes away in a step

/// Keeps two points at a distance, as stiffly as the compliance (s^2, for unit masses) says.
struct Link {
  uint32_t a, b;
  double rest;
  double compliance;
};

class Simulation {
 public:
  explicit Simulation(const ClothDrop& drop)
      : drop_(drop), side_(static_cast<uint32_t>(drop.cells / 2) + 1), spacing_(2 * drop.size_mm / drop.cells) {
    placeCloth();
    addLinks();
  }

  std::vector<glm::dvec3> run() {
    const int steps = static_cast<int>(drop_.seconds / kStep);
    for (int i = 0; i < steps; ++i) {
      // Let it come to rest: the air thickens towards the end.
      step(kAirDrag * (1 + 10.0 * i / steps), i % 8 == 0);
    }
    return refined();
  }

 private:
  uint32_t at(uint32_t column, uint32_t row) const { return row * side_ + column; }

  void placeCloth() {
    Random random(7);
    const double turn = drop_.turn_deg * kPi / 180;
    const glm::dmat2 rotation(std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn));
    for (uint32_t row = 0; row < side_; ++row)
      for (uint32_t column = 0; column < side_; ++column) {
        const glm::dvec2 flat = glm::dvec2(column, row) * spacing_ - drop_.size_mm / 2;
        // A breath of unevenness decides which way each fold goes.
        points_.emplace_back(rotation * flat + drop_.offset_mm,
                             drop_.ballRadius_mm + drop_.gap_mm + 0.05 * random.uniformDouble());
      }
    velocities_.assign(points_.size(), glm::dvec3(0));
    before_ = points_;
  }

  void addLink(uint32_t column, uint32_t row, int right, int up, double compliance) {
    const int64_t toColumn = static_cast<int64_t>(column) + right, toRow = static_cast<int64_t>(row) + up;
    if (toColumn < 0 || toColumn >= side_ || toRow >= side_) return;
    links_.push_back({at(column, row), at(static_cast<uint32_t>(toColumn), static_cast<uint32_t>(toRow)),
                      spacing_ * std::hypot(right, up), compliance});
  }

  void addLinks() {
    const double stretch = 0, shear = 3e-7, bend = 1e-6 / drop_.bending;
    for (uint32_t row = 0; row < side_; ++row)
      for (uint32_t column = 0; column < side_; ++column) {
        addLink(column, row, 1, 0, stretch);
        addLink(column, row, 0, 1, stretch);
        addLink(column, row, 1, 1, shear);
        addLink(column, row, -1, 1, shear);
        addLink(column, row, 2, 0, bend);
        addLink(column, row, 0, 2, bend);
        addLink(column, row, 2, 2, bend);
        addLink(column, row, -2, 2, bend);
      }
  }

  void step(double drag, bool search) {
    for (size_t i = 0; i < points_.size(); ++i) {
      velocities_[i].z -= kGravity * kStep;
      velocities_[i] *= std::max(0.0, 1 - drag * kStep);
      before_[i] = points_[i];
      points_[i] += velocities_[i] * kStep;
    }
    if (search) findClose();
    // There and back again, so that the order of the links leaves no mark on the cloth.
    if (forth_)
      for (auto link = links_.begin(); link != links_.end(); ++link) solve(*link);
    else
      for (auto link = links_.rbegin(); link != links_.rend(); ++link) solve(*link);
    forth_ = !forth_;
    for (const auto& [a, b] : close_) keepApart(a, b);
    for (size_t i = 0; i < points_.size(); ++i) keepOffBall(i);
    for (size_t i = 0; i < points_.size(); ++i) velocities_[i] = (points_[i] - before_[i]) / kStep;
  }

  void solve(const Link& link) {
    const glm::dvec3 arm = points_[link.b] - points_[link.a];
    const double length = glm::length(arm);
    if (length < 1e-9) return;
    const double lambda = (length - link.rest) / (2 + link.compliance / (kStep * kStep));
    const glm::dvec3 move = arm * (lambda / length);
    points_[link.a] += move;
    points_[link.b] -= move;
  }

  void keepOffBall(size_t i) {
    const double radius = drop_.ballRadius_mm + drop_.gap_mm / 2;
    const double distance = glm::length(points_[i]);
    if (distance >= radius) return;
    const glm::dvec3 normal = points_[i] / distance;
    points_[i] = normal * radius;
    const glm::dvec3 moved = points_[i] - before_[i];
    points_[i] -= kFriction * (moved - normal * glm::dot(moved, normal));
  }

  void keepApart(uint32_t a, uint32_t b) {
    const glm::dvec3 arm = points_[b] - points_[a];
    const double length = glm::length(arm);
    if (length >= drop_.gap_mm || length < 1e-9) return;
    const glm::dvec3 move = arm * (0.5 * (length - drop_.gap_mm) / length);
    points_[a] += move;
    points_[b] -= move;
  }

  /// Pairs that may touch until the next search: near in space, though not neighbours in the cloth.
  void findClose() {
    close_.clear();
    const double reach = 1.5 * drop_.gap_mm;
    const double apart = 2.5 * drop_.gap_mm / spacing_;  // in cells
    const auto cellOf = [&](glm::dvec3 p) { return glm::i64vec3(glm::floor(p / reach)) + int64_t{1 << 20}; };
    const auto keyOf = [](glm::i64vec3 c) { return (c.z << 42) | (c.y << 21) | c.x; };
    std::vector<std::pair<int64_t, uint32_t>> cells;
    cells.reserve(points_.size());
    for (uint32_t i = 0; i < points_.size(); ++i) cells.emplace_back(keyOf(cellOf(points_[i])), i);
    std::sort(cells.begin(), cells.end());
    for (uint32_t i = 0; i < points_.size(); ++i) {
      const glm::i64vec3 centre = cellOf(points_[i]);
      for (int64_t z = -1; z <= 1; ++z)
        for (int64_t y = -1; y <= 1; ++y) {
          // Cells along x are neighbours in the sorted list.
          const std::pair<int64_t, uint32_t> first(keyOf(centre + glm::i64vec3(-1, y, z)), 0u);
          const int64_t last = keyOf(centre + glm::i64vec3(1, y, z));
          for (auto it = std::lower_bound(cells.begin(), cells.end(), first); it != cells.end() && it->first <= last;
               ++it) {
            const uint32_t j = it->second;
            if (j <= i || glm::distance(points_[i], points_[j]) > reach) continue;
            const int64_t columns = int64_t{i % side_} - int64_t{j % side_},
                          rows = int64_t{i / side_} - int64_t{j / side_};
            if (std::hypot(static_cast<double>(columns), static_cast<double>(rows)) > apart) close_.emplace_back(i, j);
          }
        }
    }
  }

  /// The points as control points of a uniform cubic B-spline surface, evaluated at twice the resolution: knots get
  /// 1/6 4/6 1/6, the middles between them 1/48 23/48 23/48 1/48. What the grid cannot carry is smoothed away.
  std::vector<glm::dvec3> refined() const {
    const uint32_t fine = 2 * side_ - 1;
    const std::vector<glm::dvec3> rows = refinedAlong(points_, side_, side_, 1, side_);
    return refinedAlong(rows, side_, fine, fine, 1);
  }

  /// Doubles the resolution of `count` points along a line, for each of `lines` lines.
  static std::vector<glm::dvec3> refinedAlong(const std::vector<glm::dvec3>& from, uint32_t count, uint32_t lines,
                                              uint32_t pointStride, uint32_t lineStride) {
    const bool alongRows = pointStride == 1;
    const uint32_t fine = 2 * count - 1;
    std::vector<glm::dvec3> to(size_t{fine} * lines);
    for (uint32_t line = 0; line < lines; ++line) {
      // Beyond the ends the line goes on straight.
      const auto point = [&](int64_t i) {
        const int64_t last = int64_t{count} - 1;
        const auto in = [&](int64_t k) {
          return from[static_cast<size_t>(k) * pointStride + size_t{line} * lineStride];
        };
        if (i < 0) return 2.0 * in(0) - in(-i);
        if (i > last) return 2.0 * in(last)-in(2 * last - i);
        return in(i);
      };
      for (uint32_t i = 0; i < fine; ++i) {
        const int64_t k = i / 2;
        const glm::dvec3 value = i % 2 == 0 ? (point(k - 1) + 4.0 * point(k) + point(k + 1)) / 6.0
                                            : (point(k - 1) + 23.0 * (point(k) + point(k + 1)) + point(k + 2)) / 48.0;
        to[alongRows ? size_t{line} * fine + i : size_t{i} * lines + line] = value;
      }
    }
    return to;
  }

  const ClothDrop& drop_;
  uint32_t side_;
  double spacing_;
  bool forth_ = true;
  std::vector<glm::dvec3> points_, before_, velocities_;
  std::vector<Link> links_;
  std::vector<std::pair<uint32_t, uint32_t>> close_;
};

}  // namespace

DrapeMesh dropCloth(const ClothDrop& drop) {
  const std::vector<glm::dvec3> points = Simulation(drop).run();
  MeshFile soup;
  for (const glm::dvec3& point : points) soup.positions.emplace_back(point);
  const uint32_t side = static_cast<uint32_t>(drop.cells) + 1;
  const auto uv = [&](uint32_t i) {
    return glm::vec2(i % side, i / side) * static_cast<float>(drop.size_mm / drop.cells);
  };
  for (uint32_t row = 0; row + 1 < side; ++row)
    for (uint32_t column = 0; column + 1 < side; ++column) {
      const uint32_t a = row * side + column, b = a + 1, c = a + side, d = c + 1;
      // The shorter diagonal follows the folds.
      const bool rising = glm::distance(points[a], points[d]) < glm::distance(points[b], points[c]);
      const std::array<uint32_t, 3> first = rising ? std::array{a, b, d} : std::array{a, b, c};
      const std::array<uint32_t, 3> second = rising ? std::array{a, d, c} : std::array{b, d, c};
      for (const auto& t : {first, second}) soup.triangles.push_back({t, {uv(t[0]), uv(t[1]), uv(t[2])}, true});
    }
  return repairMesh("cloth drop", soup, 1.0);
}

std::string toObj(const DrapeMesh& mesh) {
  std::string text;
  for (const glm::vec3& p : mesh.positions) text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", p.x, p.y, p.z);
  for (const glm::vec2& uv : mesh.uv_mm) text += fmt::format("vt {:.6g} {:.6g}\n", uv.x, uv.y);
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::uvec3 t = triangle + 1u;
    text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", t.x, t.y, t.z);
  }
  return text;
}

}  // namespace loomlight
