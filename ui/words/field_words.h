#pragma once

/// What fields say, whatever they are of.
namespace loomlight::words::fields {

inline constexpr const char* offOn[] = {"Off", "On"};
inline constexpr const char* doubtfulComma = "A comma before three digits may mean either: write a point, or no comma";
inline constexpr const char* expected = "Expected a number from {:g} to {:g}{}{}{}{}";
inline constexpr const char* orOtherwise = ", or ";

}  // namespace loomlight::words::fields
