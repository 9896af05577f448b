#pragma once

#include <cstddef>
#include <span>

namespace loomlight {

/// The fewest samples that sprague() takes.
inline constexpr size_t kSpragueSamples = 6;

/// A value between equally spaced samples, as CIE 15 (7.2.1) recommends for the spectra of colour: Sprague's polynomial
/// of fifth degree, exact at the samples and smooth across them. `at` counts samples, in [0, samples - 1].
double sprague(std::span<const double> samples, double at);

}  // namespace loomlight
