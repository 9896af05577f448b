#pragma once

#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace loomlight {

/// Hard spheres along strands, in a box that repeats in x and y.
struct Beads {
  std::vector<glm::dvec3> at;  ///< mm
  std::vector<double> radius_mm;
  std::vector<int> strand;  ///< beads of one strand do not touch
  glm::dvec2 period{1};     ///< mm
};

/// Pairs of beads that touch or may soon.
class Contacts {
 public:
  Contacts(Beads& beads, double friction) : beads_(beads), friction_(friction) {}
  /// Those within half a radius of touching.
  void find();
  /// Pushes apart what overlaps, half each, and holds back what slid since `before`, as far as friction does. The
  /// deepest overlap that there was, over the sum of both radii.
  double sweep(const std::vector<glm::dvec3>& before);

 private:
  glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b) const;  ///< to the nearest copy

  Beads& beads_;
  double friction_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace loomlight
