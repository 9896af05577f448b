#include "app/editor/controllers/first_opening.h"
#include "ui/widgets/keys.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

namespace loomlight {

FirstOpening::FirstOpening(FileService& files, const std::string& file, Document otherwise, Settings settings)
    : files_(files), file_(file), document_(std::move(otherwise)), settings_(std::move(settings)) {
  files_.open(FileService::Work::open, file, document_.fabric(), document_.state());
}

void FirstOpening::frame(Ui& ui) {
  if (auto read = files_.take()) {
    over_ = true;
    problem_ = std::move(read->problem);
    if (read->fabric) document_ = Document(std::move(*read->fabric), file_);
    return;
  }
  if (ImGui::GetIO().KeyCtrl && letterPressed('Q')) askToQuit();
  const std::string text = fmt::format("Opening {}\xE2\x80\xA6", std::filesystem::path(file_).filename().string());
  if (!busyDialog_.draw(ui, text, files_.canCancel())) return;
  files_.cancel();
  over_ = true;
}

void FirstOpening::drop(const std::vector<std::string>& files) {
  dropped_.insert(dropped_.end(), files.begin(), files.end());
}

}  // namespace loomlight
