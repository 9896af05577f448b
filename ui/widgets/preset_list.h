#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/panel_controls.h"

namespace loomlight {

struct PresetChoice {
  bool isSample = false;
  size_t index = 0;  ///< in the list it is from
};

/// At scale 1; less has no use.
inline constexpr float kLowestPresetList = 110;

/// The cloths kept at hand: the designer's own, then those that came with the program. Returns the one that was
/// clicked. Where less than kLowestPresetList is left a button stands in for the list, and `browse` is true when the
/// browser of presets is asked for.
std::optional<PresetChoice> presetList(Ui& ui, const std::vector<std::string>& own,
                                       const std::vector<std::string>& samples, PageScroll& scroll, bool& browse);

}  // namespace loomlight
