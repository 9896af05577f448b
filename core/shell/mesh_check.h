#pragma once

#include <string>

namespace loomlight {

/// OpenMesh's readers trust what they read: counts decide how much memory they take, an index that does not exist or a
/// coordinate that is no number shifts or ends the program, and material files are opened wherever they lie. So the
/// text is checked before they see it. Each throws InputError, naming the line; `content` is the whole file, and is
/// changed only where it must not be looked at.
void checkObj(const std::string& file, std::string& content);
void checkPly(const std::string& file, const std::string& content);
void checkOff(const std::string& file, std::string& content);

/// Corners a polygon may have.
inline constexpr int kMaxCorners = 1000;

}  // namespace loomlight
