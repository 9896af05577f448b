#pragma once

namespace loomlight::words {

/// What keys and mouse do, as the list of them says it.
struct KeyLine {
  const char* keys;
  const char* meaning;
};

namespace keys {

inline constexpr const char* clothTitle = "On the cloth";
inline constexpr const char* draftTitle = "In the draft";
inline constexpr const char* numbersTitle = "On numbers";
inline constexpr const char* everywhereTitle = "Everywhere";

inline constexpr KeyLine onTheCloth[] = {
    {"Drag", "Turn"},
    {"Shift or Space + drag", "Move, as the middle button does"},
    {"Wheel", "Nearer and further"},
    {"Click", "Choose the yarn that is there"},
    {"F or Ctrl+0, Ctrl+1", "Fit the cloth, actual size"},
    {"1, 2, 3", "From above, aslant, low"},
    {"K", "Keep this view below"},
    {"L", "Truth lens; Esc closes"},
    {"J, Shift+J", "Next booth lamp, all at once"},
    {"N", "Denoised preview"},
    {"Y, Shift+Y", "Soft proof, gamut warning"},
    {"Esc", "From flat cloth to its drape"},
};
inline constexpr KeyLine inTheDraft[] = {
    {"Click, drag", "Turn crossings over"},
    {"Right drag", "Weft over"},
    {"Shift + drag", "Keep to a line"},
    {"Space + drag", "Move, as the middle button does"},
    {"Wheel", "Nearer and further"},
    {"Shift+F", "Fit the draft"},
    {"[, ], X", "Another yarn to paint with, swap"},
    {"Ctrl + drag", "Select"},
    {"Right click while selecting", "What can be done"},
    {"Ctrl+A, Ctrl+D", "Select the repeat, deselect"},
    {"Ctrl+C, Ctrl+X, Ctrl+V", "Copy, cut, paste crossings"},
    {"Ctrl+Shift+V", "Fill with the copy"},
    {"Delete, arrows, Ctrl+I", "Weft over, shift, invert"},
};
inline constexpr KeyLine onNumbers[] = {
    {"Drag", "Change; Shift fine, Ctrl coarse"},
    {"Click", "Type; Enter takes, Esc restores"},
    {"Tab, Shift+Tab", "The next one, the one before"},
};
inline constexpr KeyLine everywhere[] = {
    {"Ctrl+N, Ctrl+O", "New, open"},
    {"Ctrl+S, Ctrl+Shift+S", "Save, save as"},
    {"Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"},
    {"Ctrl+P", "Snapshot"},
    {"Ctrl+E", "Texture tile"},
    {"Ctrl+B", "Presets, by pictures"},
    {"P, F11", "Hide panels, full screen"},
    {"F1, ?", "This list"},
    {"Ctrl+Q", "Quit"},
};

}  // namespace keys
}  // namespace loomlight::words
