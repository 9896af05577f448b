#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/model/document.h"
#include "app/editor/model/settings.h"
#include "app/editor/services/file_service.h"
#include "render/colour/colour_cube.h"
#include "ui/dialogs/busy_dialog.h"

namespace loomlight {

/// What the window shows before there is a session: that the cloth is read with which the editor begins. Nothing is
/// seen of it where that is soon done; a large file or a slow disk does not keep the window away, and can be given up.
class FirstOpening {
 public:
  /// `files` reads it, and is left with it where it is given up. `otherwise`: the cloth to begin with then.
  FirstOpening(FileService& files, const std::string& file, Document otherwise, Settings settings);

  void frame(Ui& ui);
  bool isOver() const { return over_; }
  void askToQuit() { over_ = quits_ = true; }
  void drop(const std::vector<std::string>& files);
  bool wantsFullScreen() const { return false; }
  /// The display's profile is not known yet.
  std::shared_ptr<const ColourCube> displayCube() const { return nullptr; }
  const Settings& settings() const { return settings_; }
  std::string title() const { return "Loomlight"; }

  // Once it is over.
  bool quits() const { return quits_; }  ///< the program is to end instead
  Document takeDocument() { return std::move(document_); }
  const std::string& problem() const { return problem_; }  ///< why the file was not read; empty when all went well
  const std::vector<WifWarning>& warnings() const { return warnings_; }  ///< about the file that was read
  const std::vector<std::string>& dropped() const { return dropped_; }

 private:
  FileService& files_;
  std::string file_;
  Document document_;
  Settings settings_;
  BusyDialog busyDialog_;
  std::vector<std::string> dropped_;  ///< files for the session
  std::string problem_;
  std::vector<WifWarning> warnings_;
  bool over_ = false, quits_ = false;
};

}  // namespace loomlight
