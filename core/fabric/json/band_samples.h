#pragma once

#include <cstddef>

#include "core/fabric/model/field_info.h"

/// What a spectrum's samples may be, for reader and schema alike.
namespace loomlight::band_samples {

inline constexpr FieldInfo kFrom_nm{{}, "", "", "", 100, 2000};
inline constexpr FieldInfo kStep_nm{{}, "", "", "", 0.1, 100};
inline constexpr size_t kFewest = 2, kMost = 1001;

}  // namespace loomlight::band_samples
