#pragma once

#include <fmt/format.h>

#include <vector>

#include "core/fabric/wif/wif_sections.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {

/// Calls visit(n, entry) for the lines "n=..." of a section, 1 <= n <= most, in file order; where a number comes twice,
/// for both of them, and the last one is to count. `what` is what the lines are numbered by: "end", "pick", "treadle";
/// `first` what the file gives the first of them, 0 or 1.
template <class Visit>
void forEachNumbered(const WifSection* section, int first, int most, const char* what, WifWarnings& warnings,
                     Visit&& visit) {
  if (!section) return;
  std::vector<bool> seen(static_cast<size_t>(most) + 1, false);
  for (const WifEntry& entry : section->entries) {
    const std::optional<int> number = wifWhole(entry.key);
    if (!number || *number < first || *number > most - 1 + first) {
      warnings.add(entry.line, section->name, entry.key,
                   fmt::format("There are {}s {} to {} only; what is said of others is passed over.", what, first,
                               most - 1 + first));
      continue;
    }
    const int counted = *number - first + 1;
    if (seen[counted])
      warnings.add(entry.line, section->name, entry.key,
                   fmt::format("Each {} should be named once; the last line of it counts.", what));
    seen[counted] = true;
    visit(counted, entry);
  }
}

}  // namespace loomlight
