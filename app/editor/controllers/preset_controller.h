#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/model/sample_fabric.h"
#include "app/editor/services/preset_service.h"
#include "ui/dialogs/preset_browser.h"
#include "ui/widgets/preset_list.h"

namespace loomlight {

/// What is kept at hand: the list below the draft, and the browser.
class PresetController {
 public:
  PresetController(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
      : service_(std::move(folder), driver, std::move(wake)) {}

  /// What the browser puts into the fabric. `yarn`, `fibre`: those looked at.
  struct Used {
    Fabric fabric;
    bool isWhole = false;  ///< another cloth altogether
  };
  std::optional<Used> drawBrowser(Ui& ui, const Fabric& now, int yarn, int fibre);
  void showBrowser();
  bool isOpen() const { return browser_.isOpen(); }

  /// `browse`: the browser is asked for instead.
  std::optional<PresetChoice> drawList(Ui& ui, bool& browse) {
    return presetList(ui, service_.names(), samples_, scroll_, browse);
  }
  /// Of a choice of the designer's own.
  std::string fileOf(const PresetChoice& choice) const { return service_.fileOf(service_.names()[choice.index]); }
  void keep(const Fabric& fabric) { service_.keep(PresetKind::fabrics, fabric, 0, 0); }

  struct Message {
    std::string title, text;
  };
  /// At the end of a frame. What came of a change, where the browser does not say it; `mayTell`: no other dialog is
  /// open.
  std::optional<Message> follow(bool mayTell);

 private:
  PresetService service_;
  PresetBrowser browser_;
  PageScroll scroll_;    ///< of the list
  std::string problem_;  ///< why the last change was not made
  const std::vector<std::string> samples_ = sampleNames();
};

}  // namespace loomlight
