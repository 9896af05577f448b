#pragma once

#include <optional>
#include <string_view>

namespace loomlight {

/// The count of a yarn as spinners write it, in tex: "19.7 tex", "30/2 Ne", "2/60 Nm", "150 den", "167 dtex". A plied
/// indirect count is singles over plies ("30/2": two plies of 30), metric ones are often written plies first ("2/60").
/// nullopt when it is none of these.
std::optional<double> texFromText(std::string_view text);

}  // namespace loomlight
