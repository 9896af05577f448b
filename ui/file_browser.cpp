#include "ui/file_browser.h"

#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/fields.h"
#include "ui/modal.h"

namespace loomlight {
namespace fs = std::filesystem;

namespace {

/// A folder with more than this is cut: the list must stay quick to make and to draw.
constexpr size_t kMostEntries = 5000;

}  // namespace

void FileBrowser::show(Purpose purpose, std::string title, std::vector<std::string> extensions, fs::path start,
                       std::vector<Place> places) {
  purpose_ = purpose;
  title_ = std::move(title);
  extensions_ = std::move(extensions);
  places_ = std::move(places);
  open_ = opening_ = true;
  std::error_code ignored;
  if (fs::is_directory(start, ignored)) {
    enter(start);
    typed_.clear();
  } else {
    enter(start.parent_path());
    typed_ = start.filename().string();
  }
}

bool FileBrowser::accepts(const fs::path& file) const {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end();
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  std::vector<Entry> found;
  for (fs::directory_iterator it(absolute, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end && found.size() < kMostEntries; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.empty() || name.front() == '.') continue;
    std::error_code ignored;
    const bool isFolder = it->is_directory(ignored);
    if (isFolder || accepts(it->path())) found.push_back({name, isFolder});
  }
  problem_ = error ? error.message() + ": " + absolute.string() : std::string();
  toReplace_.clear();
  if (error) return;
  std::sort(found.begin(), found.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
  folder_ = absolute;
  entries_ = std::move(found);
}

void FileBrowser::drawPlaces(Ui& ui, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ImGui::GetStyle().WindowPadding.y));
  ImGui::BeginChild("places", ImVec2(width, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  std::optional<fs::path> chosen;
  for (const Place& place : places_)
    if (ImGui::Selectable(place.name.c_str(), place.path == folder_)) chosen = place.path;
  ImGui::EndChild();
  if (chosen) enter(*chosen);
}

bool FileBrowser::drawEntries(Ui& ui, float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.field);
  ImGui::BeginChild("entries", ImVec2(0, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  bool decided = false;
  std::optional<fs::path> into;
  if (folder_.has_parent_path() && folder_ != folder_.root_path() && ImGui::Selectable("\xE2\x86\x91  Up"))
    into = folder_.parent_path();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Entry& entry = entries_[static_cast<size_t>(i)];
      const std::string label = entry.folder ? entry.name + "/" : entry.name;
      if (ImGui::Selectable(label.c_str(), !entry.folder && entry.name == typed_,
                            ImGuiSelectableFlags_AllowDoubleClick)) {
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
  if (entries_.empty()) hint(ui, "Nothing here that this dialog can use.");
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (into) enter(*into);
  return decided;
}

std::optional<std::string> FileBrowser::decide(bool mayReplace) {
  if (typed_.empty()) {
    problem_ = "Type a name, or choose a file.";
    return std::nullopt;
  }
  fs::path file = fs::path(typed_).is_absolute() ? fs::path(typed_) : folder_ / typed_;
  std::error_code error;
  if (fs::is_directory(file, error)) {
    enter(file);
    typed_.clear();
    return std::nullopt;
  }
  if (purpose_ == Purpose::save && !accepts(file)) file += extensions_.front();
  if (purpose_ == Purpose::open && !fs::exists(file, error)) {
    problem_ = "There is no " + file.string();
    return std::nullopt;
  }
  if (purpose_ == Purpose::save && fs::exists(file, error) && (toReplace_ != file.string() || !mayReplace)) {
    toReplace_ = file.string();
    problem_ = file.filename().string() + " exists already.";
    return std::nullopt;
  }
  return file.string();
}

std::optional<std::string> FileBrowser::draw(Ui& ui) {
  const bool begin = opening_;
  if (!open_ || !beginModal(ui, title_.c_str(), ImVec2(ui.px(760), ui.px(520)), open_, opening_)) return std::nullopt;
  const float row = ImGui::GetFrameHeightWithSpacing();
  ImGui::PushFont(ui.fonts.small);
  ImGui::TextDisabled("%s", shortened(folder_.string(), ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
  const float height = ImGui::GetContentRegionAvail().y - 3 * row;
  drawPlaces(ui, ui.px(160), height);
  ImGui::SameLine();
  bool decided = drawEntries(ui, height);
  ImGui::SetNextItemWidth(-1);
  if (begin) ImGui::SetKeyboardFocusHere();
  const std::string before = typed_;
  decided |= ImGui::InputTextWithHint("##name", "File name or path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
  if (typed_ != before) toReplace_.clear();
  ui.probe.recordItem("browser.name");
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
  ImGui::TextUnformatted(problem_.empty() ? " " : shortened(problem_, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  const float width = ui.px(112);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  bool close = button(ui, "browser.cancel", "Cancel", width) || modalCancelled();
  ImGui::SameLine();
  const char* does = purpose_ == Purpose::open ? "Open" : toReplace_.empty() ? "Save" : "Replace";
  const bool pressed = mainButton(ui, "browser.ok", does, width);
  std::optional<std::string> file;
  if (decided || pressed) file = decide(pressed);
  if (file || close) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return file;
}

}  // namespace loomlight
