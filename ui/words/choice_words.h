#pragma once

/// What is called what among things of a kind, in the order of the enumerators.
namespace loomlight::words::choices {

inline constexpr const char* lights[] = {"Sunny sky",  "Overcast",    "Window",    "Light booth",   "White dome",
                                         "All around", "From behind", "Headlight", "One direction", "Picture"};
inline constexpr const char* drapes[] = {"Flat", "Cylinder", "Sphere", "Folds", "Cushion", "Skirt", "Mesh"};
inline constexpr const char* fibreSections[] = {"Round", "Kidney", "Triangle", "Trilobal", "Serrated", "Polygon"};
inline constexpr const char* twists[] = {"S", "Z"};
inline constexpr const char* fibreLayouts[] = {"Random", "Packed"};
inline constexpr const char* illuminants[] = {
    "D65, daylight",  "D55, sunlight",     "D50, print booth", "A, light bulb",  "E, equal energy",
    "F2, cool white", "F7, daylight tube", "F11, shop (TL84)", "LED-B1, 2700 K", "LED-B2, 3000 K",
    "LED-B3, 4100 K", "LED-B4, 5100 K",    "LED-B5, 6600 K",   "Black body",     "Measured lamp"};
inline constexpr const char* methods[] = {"Volume", "Fibres"};
inline constexpr const char* estimators[] = {"None", "Report", "Loomlight"};
inline constexpr const char* eventLaws[] = {"Projected", "Report"};

// Lamps that have no short name of the trade
inline constexpr const char* blackBody = "a black body";
inline constexpr const char* ownLamp = "a measured lamp";

}  // namespace loomlight::words::choices
