#include "ui/inspector/colour_book.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/fabric/model/glossary.h"

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

const BookColour* colourBookRows(Ui& ui, const ColourBook& book, std::string& search) {
  textField(ui, {"book.search", words::colourBook.label, words::colourBook.help}, search, book.name.c_str());
  std::vector<const BookColour*> found;
  for (const BookColour& colour : book.colours)
    if (contains(colour.name, search)) found.push_back(&colour);
  ui.probe.fact("book.found", fmt::format("{} of {}", found.size(), book.colours.size()));
  if (found.empty()) {
    hint(ui, "No colour of " + book.name + " has this in its name.");
    return nullptr;
  }
  const float chip = ui.px(kChip);
  const int columns = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x - ui.px(12)) / chip));
  const int rows = (static_cast<int>(found.size()) + columns - 1) / columns;
  const BookColour* chosen = nullptr;
  // Few rows at a time, so that what is below stays where it is; of a book of thousands only those that are seen are
  // drawn.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("book", ImVec2(0, chip * static_cast<float>(std::min(rows, kMostRows))));
  ImGuiListClipper clipper;
  clipper.Begin(rows, chip);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      for (int i = row * columns; i < std::min((row + 1) * columns, static_cast<int>(found.size())); ++i) {
        if (i > row * columns) ImGui::SameLine();
        const BookColour& colour = *found[static_cast<size_t>(i)];
        const std::string id = fmt::format("book.{}", i);
        if (swatch(ui, id.c_str(), toDisplayColour(colour.linear), chip, false, colour.name.c_str())) chosen = &colour;
      }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  return chosen;
}

}  // namespace loomlight
