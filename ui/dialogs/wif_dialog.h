#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/wif/wif_fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// After a weaving file was opened: whose sett and yarns the cloth has, and what was wrong in the file.
class WifDialog {
 public:
  struct Content {
    std::string summary;  ///< what was opened, in a line or two
    WifSett file, mine;
    std::string cut;  ///< what is left where the threads that the file does not name are cut off; empty: it names all
    std::vector<WifWarning> beyond;    ///< what the file's sizes ask for and the cloth cannot have
    std::vector<WifWarning> warnings;  ///< what is wrong in the file
  };
  void show(Content content);
  bool isOpen() const { return open_; }
  void close() { closing_ = true; }
  /// The choices, each time that one changes. At first the cloth has the file's sizes where it says any, and all
  /// threads.
  std::optional<WifChoices> draw(Ui& ui);

 private:
  bool open_ = false, opening_ = false, closing_ = false;
  Content content_;
  WifChoices choices_;
};

}  // namespace loomlight
