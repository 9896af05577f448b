#pragma once

#include <string>

namespace loomlight {

/// sRGB as a profile (ICC.1; IEC 61966-2-1), for files that carry one: the same bytes whenever it is made.
std::string sRgbProfile();

}  // namespace loomlight
