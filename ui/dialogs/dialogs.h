#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "ui/dialogs/render_dialog.h"
#include "ui/viewport/snapshot_options.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Says something that must be read, with an answer or two.
class MessageDialog {
 public:
  /// Answers from left to right; Escape is the first. Enter is number `enter`, which stands out: one that loses
  /// nothing.
  void show(std::string title, std::string text, std::vector<std::string> answers, int enter);
  /// Index of the answer, once.
  std::optional<int> draw(Ui& ui);

 private:
  bool open_ = false, opening_ = false;
  std::string title_, text_;
  std::vector<std::string> answers_;
  int enter_ = 0;
};

/// Size, samples and format of a picture to be rendered to a file, then its progress.
class SnapshotDialog {
 public:
  struct Result {
    std::optional<RenderSettings> settings;  ///< edited
    bool chooseFile = false;
    bool start = false;
    bool cancel = false;
  };
  SnapshotDialog();
  void show(const RenderSettings& settings, std::string file);
  void setFile(std::string file) { dialog_.setFile(std::move(file)); }
  const std::string& file() const { return dialog_.file(); }
  const SnapshotOptions& options() const { return options_; }
  void setOptions(SnapshotOptions options) { options_ = std::move(options); }
  bool isOpen() const { return dialog_.isOpen(); }
  Result draw(Ui& ui, const ClothInView& seen, const RenderJob& job);

 private:
  RenderDialog dialog_;
  RenderSettings settings_;
  SnapshotOptions options_;
};

}  // namespace loomlight
