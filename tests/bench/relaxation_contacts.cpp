#include "tests/bench/relaxation_contacts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/modulo.h"

namespace loomlight {

glm::dvec3 Contacts::between(const glm::dvec3& a, const glm::dvec3& b) const {
  glm::dvec3 d = b - a;
  for (int k = 0; k < 2; ++k) d[k] -= beads_.period[k] * std::round(d[k] / beads_.period[k]);
  return d;
}

void Contacts::find() {
  const double reach = 2.5 * *std::max_element(beads_.radius_mm.begin(), beads_.radius_mm.end());
  const glm::ivec2 cells = glm::max(glm::ivec2(beads_.period / reach), glm::ivec2(1));
  double lowest = 0;
  for (const glm::dvec3& at : beads_.at) lowest = std::min(lowest, at.z);
  const auto cellOf = [&](const glm::dvec3& at) {
    const auto on = [&](int k) {
      return wrap(static_cast<int>(std::floor(at[k] / beads_.period[k] * cells[k])), cells[k]);
    };
    return glm::ivec3(on(0), on(1), static_cast<int>((at.z - lowest) / reach));
  };
  std::map<std::tuple<int, int, int>, std::vector<int>> grid;
  for (size_t i = 0; i < beads_.at.size(); ++i) {
    const glm::ivec3 c = cellOf(beads_.at[i]);
    grid[{c.z, c.y, c.x}].push_back(static_cast<int>(i));
  }
  pairs_.clear();
  const auto consider = [&](int a, int b) {
    const auto i = static_cast<size_t>(a), j = static_cast<size_t>(b);
    if (beads_.strand[i] == beads_.strand[j]) return;
    const double near = 1.25 * (beads_.radius_mm[i] + beads_.radius_mm[j]);
    const glm::dvec3 d = between(beads_.at[i], beads_.at[j]);
    if (glm::dot(d, d) < near * near) pairs_.emplace_back(a, b);
  };
  for (const auto& [cell, inside] : grid) {
    const auto [z, y, x] = cell;
    std::vector<std::tuple<int, int, int>> around;
    for (int i = 0; i < 27; ++i)
      around.emplace_back(z + i / 9 - 1, wrap(y + i / 3 % 3 - 1, cells.y), wrap(x + i % 3 - 1, cells.x));
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (const auto& name : around) {
      const auto found = grid.find(name);
      if (found == grid.end()) continue;
      for (const int a : inside)
        for (const int b : found->second)
          if (a < b) consider(a, b);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
}

double Contacts::sweep(const std::vector<glm::dvec3>& before) {
  double deepest = 0;
  for (const auto& [a, b] : pairs_) {
    const auto i = static_cast<size_t>(a), j = static_cast<size_t>(b);
    const double touching = beads_.radius_mm[i] + beads_.radius_mm[j];
    const glm::dvec3 d = between(beads_.at[i], beads_.at[j]);
    const double distance2 = glm::dot(d, d);
    if (distance2 >= touching * touching) continue;
    const double distance = std::sqrt(std::max(distance2, 1e-18)), depth = touching - distance;
    deepest = std::max(deepest, depth / touching);
    const glm::dvec3 normal = d / distance;
    const glm::dvec3 slid = (beads_.at[j] - before[j]) - (beads_.at[i] - before[i]);
    const glm::dvec3 sideways = slid - glm::dot(slid, normal) * normal;
    const double slip = glm::length(sideways);
    glm::dvec3 apart = depth * normal;
    if (slip > 0) apart -= std::min(1.0, friction_ * depth / slip) * sideways;
    beads_.at[i] -= 0.5 * apart;
    beads_.at[j] += 0.5 * apart;
  }
  return deepest;
}

}  // namespace loomlight
