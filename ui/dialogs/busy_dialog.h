#pragma once

#include <optional>
#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// What the window waits for.
struct BusyWork {
  std::string text;                ///< what is done
  std::optional<double> fraction;  ///< how much of it is; nothing where nobody knows
  bool canCancel = false;
};

/// Keeps the window waiting while a file is read or written, so that nothing is edited that would be lost. Nothing is
/// seen of it before that takes a while.
class BusyDialog {
 public:
  /// `work`: nothing when it is over. True when it is to be cancelled, which is offered only if it can.
  bool draw(Ui& ui, const std::optional<BusyWork>& work);

 private:
  bool open_ = false, opening_ = false;
  double since_ = 0;  ///< seconds
  BusyWork work_;     ///< the last
};

}  // namespace loomlight
