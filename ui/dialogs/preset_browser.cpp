#include "ui/dialogs/preset_browser.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "core/base/text.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/picture_card.h"
#include "ui/words/common_words.h"
#include "ui/words/menu_words.h"
#include "ui/words/preset_words.h"

namespace loomlight {
namespace {

constexpr float kCardWidth = 168, kPictureHeight = 120, kCardGap = 12;

}  // namespace

bool matchesSearch(const std::string& text, const std::string& search) {
  std::istringstream wanted(lowerCase(search));
  for (std::string beginning; wanted >> beginning;) {
    std::istringstream all(lowerCase(text));
    bool found = false;
    for (std::string word; all >> word;) found |= word.compare(0, beginning.size(), beginning) == 0;
    if (!found) return false;
  }
  return true;
}

void PresetBrowser::head(Ui& ui) {
  ImGui::BeginChild("kind", ImVec2(ui.px(400), ImGui::GetFrameHeight()));
  if (segmentField(ui, {"presets.kind", words::presets::kind, true}, words::presets::kinds, kind_)) chosen_.reset();
  ImGui::EndChild();
  ImGui::SameLine(0, ui.px(24));
  textField(ui, {"presets.search", words::presets::search, true}, search_);
}

void PresetBrowser::renamed(const std::string& name) {
  if (!chosen_) chosen_ = {true, newName_ = name};
}

void PresetBrowser::card(Ui& ui, const PresetCard& card) {
  const bool isChosen = chosen_ && chosen_->is(card);
  const std::string about =
      card.tags.empty() ? card.about : card.about + fmt::format(words::presets::tagsBelow, card.tags);
  const DrawnCard drawn = pictureCard(ui, {.id = "presets.card/" + card.name,
                                           .picture = ImVec2(ui.px(kCardWidth), ui.px(kPictureHeight)),
                                           .texture = card.picture,
                                           .name = card.name.c_str(),
                                           .isChosen = isChosen,
                                           .isQuiet = !card.own,
                                           .about = about});
  if (!drawn.isPressed || isChosen) return;
  chosen_ = {card.own, card.name};
  newName_ = card.name;
  newTags_ = card.tags;
}

void PresetBrowser::grid(Ui& ui, const std::vector<PresetCard>& cards, PresetBrowserEdit& edit) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(kCardGap), ui.px(kCardGap)));
  const float room = ImGui::GetContentRegionAvail().x + ui.px(kCardGap);
  const int perLine = std::max(1, static_cast<int>(room / ui.px(kCardWidth + kCardGap)));
  int shown = 0;
  for (size_t i = 0; i < cards.size(); ++i) {
    if (!matchesSearch(cards[i].name + " " + cards[i].about + " " + cards[i].tags, search_)) continue;
    if (shown++ % perLine != 0) ImGui::SameLine();
    ImGui::PushID(static_cast<int>(i));
    card(ui, cards[i]);
    ImGui::PopID();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) edit.use = i;
  }
  ImGui::PopStyleVar();
  if (shown == 0) hint(ui, cards.empty() ? words::presets::coming : words::common::nothingCalledThat);
}

void PresetBrowser::actions(Ui& ui, const std::vector<PresetCard>& cards, const std::string& lastChange,
                            PresetBrowserEdit& edit) {
  const auto found =
      std::find_if(cards.begin(), cards.end(), [&](const PresetCard& card) { return chosen_ && chosen_->is(card); });
  const bool any = found != cards.end(), own = any && found->own;
  const auto index = static_cast<size_t>(found - cards.begin());
  ui.probe.fact("presets.removable", own ? "yes" : "no");
  const float width = ui.px(96);
  const ImVec2 field(0.5f * (ImGui::GetContentRegionAvail().x - ui.px(24)) - ui.px(8) - width, ImGui::GetFrameHeight());
  ImGui::BeginChild("name", field);
  textField(ui, {"presets.name", words::presets::name, true}, newName_);
  ImGui::EndChild();
  ImGui::SameLine();
  if (button(ui, "presets.rename", words::presets::rename, width,
             own && !newName_.empty() && newName_ != found->name)) {
    edit.rename = {index, newName_};
    chosen_.reset();  // until it is known which name it gets
  }
  ImGui::SameLine(0, ui.px(24));
  ImGui::BeginChild("tags", field);
  textField(ui, {"presets.tags", words::presets::tags, true}, newTags_);
  ImGui::EndChild();
  ImGui::SameLine();
  if (button(ui, "presets.tag", words::presets::tag, width, any && newTags_ != found->tags))
    edit.tag = {index, newTags_};
  const bool enter = any && modalConfirmed(ui);
  if (mainButton(ui, "presets.use", words::presets::use.label, width, any, words::presets::use.help) || enter)
    edit.use = index;
  ImGui::SameLine();
  if (button(ui, "presets.keep", words::presets::keep.label, width, true, words::presets::keep.help)) edit.keep = true;
  ImGui::SameLine();
  if (button(ui, "presets.duplicate", words::presets::duplicate, width, any)) edit.duplicate = index;
  ImGui::SameLine();
  if (button(ui, "presets.remove", words::common::remove, width, own)) edit.remove = index;
  ImGui::SameLine();
  if (button(ui, "presets.undo", words::menu::undo.label, width, !lastChange.empty(), lastChange.c_str()))
    edit.undo = true;
  ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(16) - width);
  if (button(ui, "presets.close", words::common::close, width) || modalCancelled(ui) || edit.use) closeModal(open_);
}

PresetBrowserEdit PresetBrowser::draw(Ui& ui, const std::vector<PresetCard>& cards, const std::string& lastChange,
                                      const std::string& problem) {
  PresetBrowserEdit edit;
  if (!open_ || !beginModal(ui, words::presets::title, ImVec2(ui.px(756), ui.px(600)), open_, opening_)) return edit;
  head(ui);
  const float below = 2 * ImGui::GetFrameHeightWithSpacing() + ui.px(28);
  ImGui::BeginChild("grid", ImVec2(0, ImGui::GetContentRegionAvail().y - below));
  grid(ui, cards, edit);
  ImGui::EndChild();
  hint(ui, problem.empty() ? lastChange.empty() ? " " : lastChange : problem);
  ui.probe.fact("presets.problem", problem);
  actions(ui, cards, lastChange, edit);
  endModal();
  return edit;
}

}  // namespace loomlight
