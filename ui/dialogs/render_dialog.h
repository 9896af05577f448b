#pragma once

#include <functional>
#include <string>
#include <utility>

#include "core/fabric/model/glossary.h"
#include "ui/dialogs/render_job.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A dialog in which something is rendered to a file: rows of its own, the row of that file, and progress. In a low
/// window its own rows scroll, and all that stands below them stays in sight.
class RenderDialog {
 public:
  /// Widgets are named after `id`, the row of the file `id`.`field`; `file`: what that row says.
  RenderDialog(const char* id, const char* title, const char* field, const Word& file)
      : id_(id), title_(title), field_(field), fileWord_(file) {}
  void show(std::string file);
  bool isOpen() const { return open_; }
  void setFile(std::string file) { file_ = std::move(file); }
  const std::string& file() const { return file_; }

  struct Answer {
    bool chooseFile = false, start = false, cancel = false;
  };
  /// Draws it while it is open.
  Answer draw(Ui& ui, const RenderJob& job, const std::function<void()>& rows) { return draw(ui, job, file_, rows); }
  /// The same, with `replaced`: the file that would be written over, where that is another than the one that is named.
  Answer draw(Ui& ui, const RenderJob& job, const std::string& replaced, const std::function<void()>& rows);

 private:
  bool open_ = false, opening_ = false;
  std::string id_;
  const char* title_;
  const char* field_;
  Word fileWord_;
  std::string file_;
};

}  // namespace loomlight
