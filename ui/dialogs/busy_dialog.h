#pragma once

#include <optional>
#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// Keeps the window waiting while a file is read or written, so that nothing is edited that would be lost. Nothing is
/// seen of it before that takes a while.
class BusyDialog {
 public:
  /// `text`: what is done; nothing when it is over. True when it is to be cancelled, which is offered only if it can.
  bool draw(Ui& ui, const std::optional<std::string>& text, bool canCancel);

 private:
  bool open_ = false, opening_ = false;
  double since_ = 0;  ///< seconds
  std::string text_;
};

}  // namespace loomlight
