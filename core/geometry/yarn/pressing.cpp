#include "core/geometry/yarn/pressing.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace loomlight {
namespace {

constexpr double kSpunPacking = 0.5, kFilamentPacking = 0.7;
constexpr double kEased = 0.25;  // of the way to the free section

using StateRow = std::array<Yielding, kFloatStates>;
constexpr double kSquarer = 1.06;  // area of a superellipse of exponent 2.4 over that of the ellipse in it

using Finishes = std::array<StateRow, 3>;
constexpr Finishes kSpun = {{
    {{{{0.68, 1.08}, 0.68}, {{0.75, 1.05}, 0.75}, {{0.87, 0.95}, 1.20}}},  // washed
    {{{{0.65, 1.10}, 0.66}, {{0.69, 1.09}, 0.67}, {{0.72, 0.97}, 0.75}}},  // pressed
    {{{{0.59, 1.16}, 0.64}, {{0.63, 1.10}, 0.65}, {{0.69, 1.05}, 0.73}}},  // calendered
}};
constexpr Finishes kFilament = {{
    {{{{0.70, 1.29}, 0.70}, {{0.73, 1.24}, 0.73}, {{0.90, 1.05}, 1.20}}},
    {{{{0.69, 1.31}, 0.69}, {{0.72, 1.26}, 0.72}, {{0.84, 1.07}, 0.88}}},
    {{{{0.68, 1.33}, 0.68}, {{0.70, 1.29}, 0.70}, {{0.80, 1.12}, 0.84}}},
}};

double mix(double a, double b, double share) {
  return a + share * (b - a);
}
Yielding mix(const Yielding& a, const Yielding& b, double share) {
  return {{mix(a.section.up, b.section.up, share), mix(a.section.across, b.section.across, share)},
          mix(a.apart, b.apart, share)};
}

Yielding finished(const Finishes& of, double press, size_t state) {
  const double row = 2 * std::clamp(press, 0.0, 1.0);
  return row < 1 ? mix(of[0][state], of[1][state], row) : mix(of[1][state], of[2][state], row - 1);
}

}  // namespace

double packingAtCrossings(double packing, double felting) {
  const double pressed = std::clamp(packing, kSpunPacking, kFilamentPacking);
  return mix(pressed, std::min(packing, pressed), felting);
}

Yielding yieldingOf(double press, double packing, int floatState) {
  const auto state = static_cast<size_t>(floatState);
  const double filament = (packingAtCrossings(packing) - kSpunPacking) / (kFilamentPacking - kSpunPacking);
  Yielding yielding = mix(finished(kSpun, press, state), finished(kFilament, press, state), filament);
  yielding.apart = std::max(yielding.apart, yielding.section.up);
  yielding.section.across *= kSquarer;
  return yielding;
}

template <class Section>
Section SectionEasing<Section>::at(double share) const {
  const double onWay = glm::smoothstep(0.0, 1.0, share), sine = std::sin(kPi * share), eased = kEased * sine * sine;
  return {mix(mix(from_.up, to_.up, onWay), free_.up, eased),
          mix(mix(from_.across, to_.across, onWay), free_.across, eased)};
}

// Smoothstep has slopes up to 1.5 and second derivatives up to 6, the square of a sine up to pi and 2 pi^2.
template <class Section>
double SectionEasing<Section>::slope() const {
  const auto of = [this](double Section::* factor) {
    const double change = std::abs(to_.*factor - from_.*factor);
    const double far = std::max(std::abs(free_.*factor - from_.*factor), std::abs(free_.*factor - to_.*factor));
    return 1.5 * change + kEased * kPi * far;
  };
  return std::max(of(&Section::up), of(&Section::across));
}

template <class Section>
double SectionEasing<Section>::bend() const {
  const auto of = [this](double Section::* factor) {
    const double change = std::abs(to_.*factor - from_.*factor);
    const double far = std::max(std::abs(free_.*factor - from_.*factor), std::abs(free_.*factor - to_.*factor));
    return 6 * change + kEased * (2 * kPi * kPi * far + 2 * kPi * 1.5 * change);
  };
  return std::max(of(&Section::up), of(&Section::across));
}

template <class Section>
double SectionEasing<Section>::largest() const {
  return std::max({from_.up, to_.up, free_.up, from_.across, to_.across, free_.across});
}

template class SectionEasing<SectionOutline>;
template class SectionEasing<SectionScale>;

}  // namespace loomlight
