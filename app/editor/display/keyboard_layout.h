#pragma once

namespace loomlight {

/// The key that a letter's shortcut is meant by, as GLFW numbers keys: by the letter that the user's keyboard has
/// there, where GLFW itself goes by the place that it has on an American one. `name`: what glfwGetKeyName() says, which
/// may be null. Keys that have no letter from A to Z stay what they are.
inline int keyOnLayout(int key, const char* name) {
  if (!name || !name[0] || name[1]) return key;
  const char letter = name[0];
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  return letter >= 'A' && letter <= 'Z' ? letter : key;
}

}  // namespace loomlight
