#pragma once

#include <string>

namespace loomlight {

/// The same pages with an sRGB profile in them: what is drawn in red, green and blue without a profile of its own means
/// sRGB then, on every page and in every form, and the file says so as its output intent. A PDF of our own making.
std::string withSrgbProfile(const std::string& pdf);

}  // namespace loomlight
