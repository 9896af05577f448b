#include "ui/inspector/colour_book.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "core/base/text.h"
#include "core/fabric/model/glossary.h"
#include "ui/words/fibre_words.h"

namespace loomlight {
namespace {

constexpr float kChip = 26;   // of a side, in pixels of a display of ordinary density
constexpr int kMostRows = 5;  // that are shown at a time

bool contains(std::string_view text, std::string_view part) {
  return lowerCase(text).find(lowerCase(part)) != std::string::npos;
}

}  // namespace

const BookColour* ColourBook::named(std::string_view wanted) const {
  const auto found = std::find_if(colours.begin(), colours.end(), [&](const BookColour& colour) {
    return colour.name.size() == wanted.size() && contains(colour.name, wanted);
  });
  return found == colours.end() ? nullptr : &*found;
}

void BookShelf::take(const std::string& file) {
  files.erase(std::remove(files.begin(), files.end(), file), files.end());
  files.insert(files.begin(), file);
  if (files.size() > kMostBooks) files.resize(kMostBooks);
  open = 0;
}

void BookShelf::forget(int index) {
  files.erase(files.begin() + index);
  if (open == index)
    open = -1;
  else if (open > index)
    --open;
}

void bookRow(Ui& ui, BookShelf& shelf) {
  std::vector<std::string> names;
  for (const std::string& file : shelf.files) names.push_back(std::filesystem::path(file).stem().string());
  const bool isOpen = shelf.open >= 0;
  if (isOpen) {
    names.push_back(words::bookRows::none);
    names.push_back(fmt::format(words::bookRows::forget, names[static_cast<size_t>(shelf.open)]));
  }
  const std::vector<const char*> choices = choicesOf(names);
  int chosen = shelf.open;
  const char* const otherwise = shelf.files.empty() ? words::bookRows::dropHere : words::bookRows::none;
  if (!choiceField(ui, {"book.choice", words::colourBook}, choices, chosen, otherwise)) return;
  const int count = static_cast<int>(shelf.files.size());
  if (chosen < count)
    shelf.wanted = chosen;
  else if (chosen == count)
    shelf.wanted = -1;
  else
    shelf.remove = shelf.open;
}

const BookColour* colourBookRows(Ui& ui, const ColourBook& book, std::string& search) {
  textField(ui, {"book.search", words::findColour}, search, book.name.c_str());
  std::vector<const BookColour*> found;
  for (const BookColour& colour : book.colours)
    if (contains(colour.name, search)) found.push_back(&colour);
  ui.probe.fact("book.found", fmt::format("{} of {}", found.size(), book.colours.size()));
  const float chip = ui.px(kChip);
  const int columns = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x - ui.px(12)) / chip));
  const auto rowsOf = [columns](size_t colours) { return (static_cast<int>(colours) + columns - 1) / columns; };
  const int rows = rowsOf(found.size());
  const BookColour* chosen = nullptr;
  // As many rows as the whole book takes, up to a few, so that a search moves nothing below; of a book of thousands
  // only those that are seen are drawn.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("book", ImVec2(0, chip * static_cast<float>(std::min(rowsOf(book.colours.size()), kMostRows))));
  if (found.empty()) hint(ui, fmt::format(words::bookRows::nothingFound, book.name));
  ImGuiListClipper clipper;
  clipper.Begin(rows, chip);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      for (int i = row * columns; i < std::min((row + 1) * columns, static_cast<int>(found.size())); ++i) {
        if (i > row * columns) ImGui::SameLine();
        const BookColour& colour = *found[static_cast<size_t>(i)];
        const std::string id = fmt::format("book.{}", i);
        const WhiteLab& lab = colour.lab;
        const std::string said = fmt::format(words::bookRows::colour, colour.name, lab.L, lab.a, lab.b, lab.illuminant,
                                             lab.observer_degrees);
        if (swatch(ui, id.c_str(), toDisplayColour(colour.linear), chip, false, said.c_str())) chosen = &colour;
      }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  return chosen;
}

}  // namespace loomlight
