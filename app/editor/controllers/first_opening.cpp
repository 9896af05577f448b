#include "app/editor/controllers/first_opening.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "ui/widgets/keys.h"
#include "ui/words/file_words.h"

namespace loomlight {

FirstOpening::FirstOpening(FileService& files, const std::string& file, Document otherwise, Settings settings)
    : files_(files), file_(file), document_(std::move(otherwise)), settings_(std::move(settings)) {
  files_.open(FileService::Work::open, file, document_.fabric(), document_.state());
}

void FirstOpening::frame(Ui& ui) {
  if (auto read = files_.take()) {
    over_ = true;
    problem_ = std::move(read->problem);
    warnings_ = std::move(read->warnings);
    if (read->fabric) document_ = Document(std::move(*read->fabric), file_);
    return;
  }
  if (ImGui::GetIO().KeyCtrl && letterPressed('Q')) askToQuit();
  const std::string text = fmt::format(words::files::opening, std::filesystem::path(file_).filename().string());
  if (!busyDialog_.draw(ui, BusyWork{text, std::nullopt, files_.canCancel()})) return;
  files_.cancel();
  over_ = true;
}

void FirstOpening::drop(const std::vector<std::string>& files) {
  dropped_.insert(dropped_.end(), files.begin(), files.end());
}

}  // namespace loomlight
