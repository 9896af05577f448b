#include "ui/dialogs/file_browser.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/file_words.h"

namespace loomlight {
namespace fs = std::filesystem;

namespace {

/// A folder is looked at no further than this: the list must stay quick to make and to draw, whatever else lies there.
constexpr int kMostLookedAt = 20'000;
constexpr float kPreviewWidth = 216;

}  // namespace

void FileBrowser::show(Purpose purpose, std::string title, std::vector<std::string> extensions, const fs::path& start,
                       std::vector<Bookmark> bookmarks) {
  purpose_ = purpose;
  title_ = std::move(title);
  extensions_ = std::move(extensions);
  bookmarks_ = std::move(bookmarks);
  open_ = opening_ = true;
  filter_.clear();
  std::error_code ignored;
  const bool isFolder = purpose == Purpose::open || fs::is_directory(start, ignored);
  enterNearest(isFolder ? start : start.parent_path());
  typed_ = isFolder ? std::string() : start.filename().string();
}

bool FileBrowser::accepts(const fs::path& file) const {
  const std::string extension = lowerExtension(file.string());
  return std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end();
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  std::vector<Entry> found;
  int looked = 0;
  for (fs::directory_iterator it(absolute, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end; it.increment(error)) {
    if (++looked > kMostLookedAt) break;
    const std::string name = it->path().filename().string();
    if (name.empty() || name.front() == '.') continue;
    std::error_code ignored;
    const bool isFolder = it->is_directory(ignored);
    if (isFolder || accepts(it->path())) found.push_back({name, lowerCase(name), isFolder});
  }
  problem_ = error ? error.message() + ": " + absolute.string() : std::string();
  toReplace_.clear();
  if (error) return;
  std::sort(found.begin(), found.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
  if (folder_ != absolute) filter_.clear();
  folder_ = absolute;
  entries_ = std::move(found);
  isCut_ = looked > kMostLookedAt;
}

/// The root of all folders holds nobody's work.
void FileBrowser::enterNearest(fs::path folder) {
  do {
    enter(folder);
    folder = folder.parent_path();
  } while (!problem_.empty() && folder.has_relative_path());
  for (size_t i = 0; i < bookmarks_.size() && !problem_.empty(); ++i) enter(bookmarks_[i].path);
}

fs::path FileBrowser::named() const {
  return folder_ / typed_;  // an absolute path stays what it is
}

void FileBrowser::step(int direction) {
  std::vector<const std::string*> files;
  const std::string filter = lowerCase(filter_);
  for (const Entry& entry : entries_)
    if (!entry.folder && entry.passes(filter)) files.push_back(&entry.name);
  if (files.empty()) return;
  const auto last = static_cast<int>(files.size()) - 1;
  const auto now = std::find_if(files.begin(), files.end(), [&](const std::string* name) { return *name == typed_; });
  const int next = now == files.end() ? (direction > 0 ? 0 : last) : static_cast<int>(now - files.begin()) + direction;
  typed_ = *files[static_cast<size_t>(std::clamp(next, 0, last))];
  toReplace_.clear();
  reveals_ = true;
}

void FileBrowser::drawHead(Ui& ui) {
  const float gap = ui.px(16), left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const float width = std::min(ui.px(kPreviewWidth), 0.5f * room), path = room - width - gap;
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.fonts.small);
  textLine(ui, "browser.folder", folder_.string(), ui.theme.textQuiet, path);
  ImGui::PopFont();
  ImGui::SameLine(left + path + gap);
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint("##filter", words::files::filter, &filter_);
  ui.probe.recordItem("browser.filter");
}

void FileBrowser::drawBookmarks(Ui& ui, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ImGui::GetStyle().WindowPadding.y));
  ImGui::BeginChild("places", ImVec2(width, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  std::optional<fs::path> chosen;
  for (const Bookmark& bookmark : bookmarks_) {
    if (ImGui::Selectable(bookmark.name.c_str(), bookmark.path == folder_)) chosen = bookmark.path;
    ui.probe.recordItem("browser.place/" + bookmark.name);
  }
  ImGui::EndChild();
  if (chosen) enter(*chosen);
}

bool FileBrowser::drawEntries(Ui& ui, float width, float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.field);
  ImGui::PushStyleColor(ImGuiCol_Header, ui.theme.accent);
  ImGui::BeginChild("entries", ImVec2(width, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  bool decided = false;
  std::optional<fs::path> into;
  if (folder_.has_parent_path() && folder_ != folder_.root_path() && ImGui::Selectable(words::files::up))
    into = folder_.parent_path();
  if (isCut_) textLine(ui, "browser.cut", fmt::format(words::files::tooManyHere, kMostLookedAt), ui.theme.textQuiet);
  std::vector<const Entry*> shown;
  const std::string filter = lowerCase(filter_);
  for (const Entry& entry : entries_)
    if (entry.passes(filter)) shown.push_back(&entry);
  if (std::exchange(reveals_, false)) {
    const auto at = std::find_if(shown.begin(), shown.end(), [&](const Entry* entry) { return entry->name == typed_; });
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float y = ImGui::GetCursorPosY() + row * static_cast<float>(at - shown.begin()) - ImGui::GetScrollY();
    if (y < 0 || y + row > height) ImGui::SetScrollFromPosY(y);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Entry& entry = *shown[static_cast<size_t>(i)];
      const std::string label = entry.folder ? entry.name + "/" : entry.name;
      const bool isChosen = !entry.folder && entry.name == typed_;
      std::string cut;
      const std::string id = "browser.entry/" + entry.name;
      const std::string fits = fitted(ui, id, label.c_str(), ImGui::GetContentRegionAvail().x, cut);
      ImGui::PushStyleColor(ImGuiCol_Text, isChosen ? ui.theme.onAccent : ui.theme.text);
      ImGui::PushStyleColor(ImGuiCol_HeaderHovered, isChosen ? ui.theme.accent : ui.theme.fieldHover);
      const bool pressed =
          ImGui::Selectable((fits + "##" + entry.name).c_str(), isChosen, ImGuiSelectableFlags_AllowDoubleClick);
      ImGui::PopStyleColor(2);
      ui.probe.recordItem(id);
      tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), cut.c_str());
      if (pressed) {
        if (entry.folder) {
          into = folder_ / entry.name;
        } else {
          typed_ = entry.name;
          toReplace_.clear();
          decided = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
      }
    }
  }
  const char* const none = purpose_ == Purpose::folder ? words::files::noFolderHere : words::files::nothingHere;
  if (shown.empty()) hint(ui, entries_.empty() ? none : words::common::nothingCalledThat);
  ImGui::EndChild();
  ImGui::PopStyleColor(2);
  if (into) enter(*into);
  return decided;
}

std::optional<std::string> FileBrowser::decideFolder() {
  const fs::path folder = typed_.empty() ? folder_ : named();
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_directory(folder, ignored)) return folder.string();
  problem_ = fmt::format(words::files::isNoFolder, folder.filename().string());
  return std::nullopt;
}

std::optional<std::string> FileBrowser::decide(bool mayReplace) {
  if (purpose_ == Purpose::folder) return decideFolder();
  if (typed_.empty()) {
    problem_ = words::files::noName;
    return std::nullopt;
  }
  fs::path file = named();
  std::error_code error;
  if (fs::is_directory(file, error)) {
    enter(file);
    typed_.clear();
    return std::nullopt;
  }
  if (purpose_ == Purpose::save && !accepts(file)) file += extensions_.front();
  if (purpose_ == Purpose::open && !fs::exists(file, error)) {
    problem_ = error ? error.message() + ": " + file.string() : fmt::format(words::files::isNotThere, file.string());
    return std::nullopt;
  }
  if (purpose_ == Purpose::save && fs::exists(file, error) && (toReplace_ != file.string() || !mayReplace)) {
    toReplace_ = file.string();
    problem_ = fmt::format(words::common::existsAlready, file.filename().string());
    return std::nullopt;
  }
  return file.string();
}

void FileBrowser::drawName(Ui& ui, bool begin, bool& decided) {
  ImGui::SetNextItemWidth(-1);
  if (begin) focusNextItem();
  const std::string before = typed_;
  // The arrows go through the list from where the name is typed.
  const auto onArrow = [](ImGuiInputTextCallbackData* data) {
    if (data->EventFlag != ImGuiInputTextFlags_CallbackHistory) return 0;
    FileBrowser& browser = *static_cast<FileBrowser*>(data->UserData);
    browser.typed_.assign(data->Buf, static_cast<size_t>(data->BufTextLen));
    browser.step(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, browser.typed_.c_str());
    return 0;
  };
  std::string text = typed_;
  decided |= ImGui::InputTextWithHint(
      "##name", purpose_ == Purpose::folder ? words::files::folderOrPath : words::files::nameOrPath, &text,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory, onArrow, this);
  typed_ = text;
  if (typed_ != before) toReplace_.clear();
  ui.probe.recordItem("browser.name");
}

std::optional<std::string> FileBrowser::draw(Ui& ui, const FilePreview& preview) {
  const bool begin = opening_;
  if (!open_ || !beginModal(ui, title_.c_str(), ImVec2(ui.px(960), ui.px(560)), open_, opening_)) return std::nullopt;
  drawHead(ui);
  const float row = ImGui::GetFrameHeightWithSpacing(), gap = ui.px(16);
  const float height = ImGui::GetContentRegionAvail().y - 3 * row;
  drawBookmarks(ui, ui.px(160), height);
  ImGui::SameLine();
  constexpr float kLeastList = 320;  // names come first where there is little room
  const float room = ImGui::GetContentRegionAvail().x, list = room - ui.px(kPreviewWidth) - gap;
  const bool previews = purpose_ != Purpose::folder && list >= ui.px(kLeastList);
  bool decided = drawEntries(ui, previews ? list : room, height);
  if (previews) {
    ImGui::SameLine(0, gap);
    drawFilePreview(ui, preview, ui.px(kPreviewWidth), height);
  }
  drawName(ui, begin, decided);
  textLine(ui, "browser.problem", problem_, ui.theme.warning);
  const float width = ui.px(112);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  const bool close = button(ui, "browser.cancel", words::common::cancel, width) || modalCancelled(ui);
  ImGui::SameLine();
  const char* does = purpose_ == Purpose::open     ? words::files::open
                     : purpose_ == Purpose::folder ? words::files::take
                     : toReplace_.empty()          ? words::common::save
                                                   : words::common::replace;
  const bool pressed = mainButton(ui, "browser.ok", does, width);
  decided |= modalConfirmed(ui);
  std::optional<std::string> file;
  if (!close && (decided || pressed)) file = decide(pressed);
  if (file || close) closeModal(open_);
  endModal();
  return file;
}

}  // namespace loomlight
