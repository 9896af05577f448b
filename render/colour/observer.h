#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "core/base/spectrum.h"

namespace loomlight {

/// The wavelengths that colour is summed over: every nm from 360 to 780, as ASTM E308 does.
inline constexpr int kFirstVisible_nm = 360, kLastVisible_nm = 780;
inline constexpr size_t kVisible = kLastVisible_nm - kFirstVisible_nm + 1;
template <class Value>
using PerNm = std::array<Value, kVisible>;

/// The colour matching functions x, y and z of an observer (CIE 15:2018; ISO/CIE 11664-1), at every nm.
const PerNm<glm::dvec3>& matchingFunctions(Observer observer);

}  // namespace loomlight
