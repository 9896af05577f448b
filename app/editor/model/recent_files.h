#pragma once

#include <string>
#include <vector>

#include "ui/recent_menu.h"

namespace loomlight {

/// As many as a menu holds.
inline constexpr size_t kMostRecentFiles = 12;

/// Puts a file first, where it was not yet; the last one goes when there are too many.
void remember(std::vector<RecentFile>& files, const std::string& file);
void forget(std::vector<RecentFile>& files, const std::string& file);
/// Looks which are still there.
void lookFor(std::vector<RecentFile>& files);

}  // namespace loomlight
