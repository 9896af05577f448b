#pragma once

#include <string>
#include <string_view>

namespace loomlight {

/// Without blanks on both sides.
std::string_view trimmed(std::string_view text);
/// Letters A to Z only, whatever the language of the system.
std::string lowerCase(std::string_view text);
/// The ending of a file's name with its dot, in small letters; empty where it has none.
std::string lowerExtension(const std::string& file);

}  // namespace loomlight
