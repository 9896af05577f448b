// How light gets its colour (path_light.h), for every type of number. It is text, to be included inside of a namespace
// that has exponential() of these numbers:
//
//   path_light.cpp    one light:   its three primaries, and then four of its bands at a time, are computed side by side
//   light_lanes.cpp   many lights: one in each lane of a register, primary after primary and band after band
//
// Either way each number is made by the same operations in the same order, so that both give the same colours to the
// bit. What the formulas read is given by the class Lights:
//
//   Number, Bands        the type of a number of a light, and of what it has in kSideBySide bands
//   of(rgb, c)           primaries from c on, or
//   of(spectrum, j)      bands from j on: of dyes and of the eye, and so the same for all lights
//   radiance(c)          primaries from c on of PathLight::arriving()
//   isWithin()           whether the path has gone inside of fibres; isWithin(k) of material k, length_mm(k)
//   sender()             that of PathLight; where it is a fibre, mode(p), traverse_mm() and internalReflectance() are
//                        those of PathLight, too
//   apart(primaries)     each primary by itself
//   sum(partial)         of the partial sums over every fourth band
//
// Light comes in primaries, each with a spectrum of its own; fibres known in bands dim each band by an exponential of
// the lengths that the path has gone in them. The eye's response says what a primary has in each band, and what that
// adds to each channel, so that the colour is the sum over primaries and bands.

constexpr size_t kPartialSums = 4;
static_assert(kBands % kPartialSums == 0);

/// What all modes of a fibre send on together, of which this much is left after one traverse.
template <class Lights>
[[gnu::always_inline]] inline typename Lights::Bands sentOn(const Lights& lights, typename Lights::Bands traverse) {
  const auto residual = traverse * traverse * traverse * (1.0f - lights.internalReflectance()) /
                        (1.0f - lights.internalReflectance() * traverse);
  return lights.mode(0) + traverse * (lights.mode(1) + traverse * lights.mode(2)) + residual * lights.mode(3);
}

/// Light in primaries from c on, of which the fibres known by three numbers have taken their part.
template <class Lights>
[[gnu::always_inline]] inline typename Lights::Bands inPrimaries(const Lights& lights, const Colouring& colouring,
                                                                 size_t c) {
  using Bands = typename Lights::Bands;
  const std::vector<Rgb>& absorption_per_mm = colouring.primaries_per_mm;
  Bands left = lights.radiance(c);
  const bool isAllInBands = static_cast<size_t>(std::popcount(colouring.knownInBands)) == absorption_per_mm.size();
  if (lights.isWithin() && !isAllInBands) {
    Bands exponent = broadcast<Bands>(0.0f);
    for (size_t k = 0; k < absorption_per_mm.size(); ++k)
      exponent = exponent - Lights::of(absorption_per_mm[k], c) * lights.length_mm(k);
    left = left * exponential(exponent);
  }
  if (lights.sender() == PathLight::kNoFibre) return left;
  const auto sender = static_cast<size_t>(lights.sender());
  if (colouring.isSpectral(sender)) return left;
  return left * sentOn(lights, exponential(Lights::of(absorption_per_mm[sender], c) * -lights.traverse_mm()));
}

/// What Lights have in all bands.
template <class Lights>
using InAllBands = std::array<typename Lights::Bands, kBands / Lights::kSideBySide>;

/// -sum sigma_k L_k of the fibres known in bands.
template <class Lights>
[[gnu::always_inline]] inline void findExponents(const Lights& lights, const Colouring& colouring,
                                                 InAllBands<Lights>& exponents) {
  for (auto& exponent : exponents) exponent = broadcast<typename Lights::Bands>(0.0f);
  for (uint64_t rest = colouring.knownInBands; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<size_t>(std::countr_zero(rest));
    if (!lights.isWithin(k)) continue;
    const Spectrum& own_per_mm = colouring.bands_per_mm[k];
    const typename Lights::Number length_mm = lights.length_mm(k);
    for (size_t i = 0; i < exponents.size(); ++i)
      exponents[i] = exponents[i] - Lights::of(own_per_mm, i * Lights::kSideBySide) * length_mm;
  }
}

/// The colour of light in primaries of which the bands are dimmed too.
template <class Lights>
[[gnu::always_inline]] inline std::array<typename Lights::Number, 3> inBands(
    const Lights& lights, const std::array<typename Lights::Number, 3>& primaries, const Colouring& colouring) {
  using Bands = typename Lights::Bands;
  const EyeResponse& eye = colouring.eye;
  const bool isSent =
      lights.sender() != PathLight::kNoFibre && colouring.isSpectral(static_cast<size_t>(lights.sender()));
  const Spectrum* const sender_per_mm =
      isSent ? &colouring.bands_per_mm[static_cast<size_t>(lights.sender())] : nullptr;
  InAllBands<Lights> exponents;
  if (lights.isWithin()) findExponents(lights, colouring, exponents);
  std::array<std::array<Bands, kPartialSums / Lights::kSideBySide>, 3> channels;
  for (size_t i = 0; i < channels[0].size(); ++i) {
    Bands r = broadcast<Bands>(0.0f), g = r, b = r;
    for (size_t j = i; j < kBands; j += kPartialSums) {
      Bands left = broadcast<Bands>(1.0f);
      if (lights.isWithin()) left = left * exponential(exponents[j / Lights::kSideBySide]);
      if (isSent) left = left * sentOn(lights, exponential(Lights::of(*sender_per_mm, j) * -lights.traverse_mm()));
      left = left * (Lights::of(eye.primaries[0], j) * primaries[0] + Lights::of(eye.primaries[1], j) * primaries[1] +
                     Lights::of(eye.primaries[2], j) * primaries[2]);
      r = r + left * Lights::of(eye.channels[0], j);
      g = g + left * Lights::of(eye.channels[1], j);
      b = b + left * Lights::of(eye.channels[2], j);
    }
    channels[0][i] = r;
    channels[1][i] = g;
    channels[2][i] = b;
  }
  return {Lights::sum(channels[0]), Lights::sum(channels[1]), Lights::sum(channels[2])};
}

/// The colour that light brings to the eye.
template <class Lights>
[[gnu::always_inline]] inline std::array<typename Lights::Number, 3> colourOf(const Lights& lights,
                                                                              const Colouring& colouring) {
  std::array<typename Lights::Bands, (3 + Lights::kSideBySide - 1) / Lights::kSideBySide> groups;
  for (size_t i = 0; i < groups.size(); ++i) groups[i] = inPrimaries(lights, colouring, i);
  const std::array<typename Lights::Number, 3> primaries = Lights::apart(groups);
  if (colouring.isSpectral()) return inBands(lights, primaries, colouring);
  if (!colouring.eye.whole) return primaries;
  const glm::mat3& eye = *colouring.eye.whole;
  std::array<typename Lights::Number, 3> channels;
  for (int o = 0; o < 3; ++o)
    channels[static_cast<size_t>(o)] = eye[0][o] * primaries[0] + eye[1][o] * primaries[1] + eye[2][o] * primaries[2];
  return channels;
}
