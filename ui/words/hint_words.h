#pragma once

namespace loomlight::words {

/// Something to try, and what it brings.
struct HintLine {
  const char* what;
  const char* brings;
};

/// What a designer who is new here is told.
namespace hints {

inline constexpr const char* title = "Three things to try";
inline constexpr HintLine draw{"Click or drag in the draft", "The cloth is woven as you draw it."};
inline constexpr HintLine turn{"Drag the cloth to turn it", "The wheel goes in, down to fibres."};
inline constexpr HintLine set{"Drag a number on the right", "Twist, count, fibre: the yarn follows."};
inline constexpr const char* allKeys = "F1 lists all keys";
inline constexpr const char* close = "Got it";

}  // namespace hints
}  // namespace loomlight::words
