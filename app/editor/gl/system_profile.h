#pragma once

#include <string>

namespace loomlight {

/// The colour profile (ICC) that the window system has for the first display, as the ICC Profiles in X Specification
/// has it: the property _ICC_PROFILE of the root window. Empty where none is set, and under Wayland, which offers none.
std::string systemDisplayProfile();

}  // namespace loomlight
