#pragma once

#include <string>

#include "tests/headless/editor/headless_editor.h"

namespace loomlight {

/// Until a message is up that says so.
inline void untilSaid(HeadlessEditor& editor, const std::string& said) {
  editor.until("the editor says: " + said, [&] { return editor.fact("message").find(said) != std::string::npos; });
}

/// The same; and it is answered, and nothing else is asked.
inline void answerOnceSaid(HeadlessEditor& editor, const std::string& said) {
  untilSaid(editor, said);
  editor.answer();
}

}  // namespace loomlight
