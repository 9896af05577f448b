#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// What keys and mouse do, by what they do it to.
class KeysDialog {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  void draw(Ui& ui);

 private:
  bool open_ = false;
  bool opening_ = false;
};

}  // namespace loomlight
