#include "tests/headless/editor/headless_editor.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "app/editor/display/interface_scale.h"
#include "app/editor/model/user_folders.h"
#include "core/fabric/json/fabric_json.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

constexpr float kFrame_s = 1.0f / 60;
/// As the real window draws after an event: ImGui answers a click a frame late, and layout settles after it.
constexpr int kFramesPerEvent = 6;
/// Between the parts of a gesture.
constexpr int kFramesHeld = 2;

fs::path freshHome() {
  std::string name = (fs::path(testing::TempDir()) / "loomlight-headless-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no folder could be made for " + name);
  setenv("HOME", name.c_str(), 1);
  for (const char* kind : {"DATA", "STATE", "CONFIG", "CACHE"})
    setenv(fmt::format("XDG_{}_HOME", kind).c_str(), (fs::path(name) / kind).c_str(), 1);
  return name;
}

bool operator==(const HeadlessEditor::Rect& a, const ImVec4& b) {
  return a.x0 == b.x && a.y0 == b.y && a.x1 == b.z && a.y1 == b.w;
}

}  // namespace

HeadlessEditor::HeadlessEditor(Screen screen) : home_(freshHome()), screen_(screen), context_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  input_ = HeadlessInput();
  io.IniFilename = nullptr;
  io.DisplaySize = this->screen();
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigInputTextCursorBlink = false;
  io.MouseDragThreshold = 3;
  settings_.hintsSeen = true;  // somebody who has been here before
  settings_.limits.samples = screen.samples;
}

HeadlessEditor::~HeadlessEditor() {
  session_.reset();
  ImGui::DestroyContext(context_);
  std::error_code ignored;
  fs::remove_all(home_, ignored);
}

std::string HeadlessEditor::start(const Fabric& cloth, const std::string& name) {
  const std::string file = homeFile(name);
  writeFabric(cloth, file);
  startOn(file);
  return file;
}

void HeadlessEditor::startWithoutFile(Fabric cloth) {
  begin(Document(std::move(cloth)));
  untilDrawn();
}

void HeadlessEditor::startOn(const std::string& file) {
  WifImport cloth = FileService::readCloth(file, Fabric{});
  begin(Document(std::move(cloth.fabric), file));
  session_->sayLooksOtherwise(file, cloth.warnings);
  untilDrawn();
}

void HeadlessEditor::begin(Document document) {
  session_ = std::make_unique<Session>(std::move(document), settings_, driver_, wakes_.callback(), 0);
  session_->startProfiles("");
  session_->offerRecovery();
}

void HeadlessEditor::untilDrawn() {
  until("the panels are drawn", [this] { return shows("viewport"); });
}

void HeadlessEditor::crash() {
  session_.reset();
}

void HeadlessEditor::closeWindow() {
  session_->askToQuit();
  settle();
}

void HeadlessEditor::leave() {
  key("ctrl+q");
  if (!session_->isOver() && fact("dirty") == "yes") click("message.answer_1");
  until("the session is over", [this] { return session_->isOver(); });
  session_->close();
  writeSettings(settingsFile(), session_->settingsToKeep());
  settings_ = readSettings(settingsFile());
  session_.reset();
}

HeadlessEditor::Rect HeadlessEditor::rect(const std::string& widget) const {
  const auto found = snapshot().widgets.find(widget);
  if (found == snapshot().widgets.end()) throw Vain(widget + " is not on the screen; " + plight());
  return found->second;
}

std::string HeadlessEditor::fact(const std::string& name) const {
  const auto found = snapshot().facts.find(name);
  return found == snapshot().facts.end() ? std::string() : found->second;
}

uint64_t HeadlessEditor::number(const std::string& name) const {
  const std::string text = fact(name);
  return text.empty() ? 0 : std::stoull(text);
}

std::string HeadlessEditor::plight() const {
  std::string text = "facts:";
  for (const auto& [name, value] : snapshot().facts) text += fmt::format(" {}={};", name, value);
  return text;
}

std::vector<HeadlessEditor::Drawn> HeadlessEditor::drawnIn(const std::string& widget) const {
  const Rect within = rect(widget);
  std::vector<Drawn> pictures;
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int l = 0; l < drawn.CmdListsCount; ++l) {
    const ImDrawList& list = *drawn.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const Pixels8* picture = command.ElemCount > 0 ? driver_.picture(command.GetTexID()) : nullptr;
      if (!picture) continue;
      Rect place{1e9f, 1e9f, -1e9f, -1e9f};
      for (unsigned i = command.IdxOffset; i < command.IdxOffset + command.ElemCount; ++i) {
        const unsigned corner = list.IdxBuffer[static_cast<int>(i)] + command.VtxOffset;
        const ImVec2 at = list.VtxBuffer[static_cast<int>(corner)].pos;
        place = {std::min(place.x0, at.x), std::min(place.y0, at.y), std::max(place.x1, at.x),
                 std::max(place.y1, at.y)};
      }
      const ImVec4& clip = command.ClipRect;
      place = {std::max(place.x0, clip.x), std::max(place.y0, clip.y), std::min(place.x1, clip.z),
               std::min(place.y1, clip.w)};
      const float x = 0.5f * (place.x0 + place.x1), y = 0.5f * (place.y0 + place.y1);
      const bool inside = within.x0 <= x && x <= within.x1 && within.y0 <= y && y <= within.y1;
      if (inside && place.x0 < place.x1 && place.y0 < place.y1) pictures.push_back({picture, place});
    }
  }
  return pictures;
}

const Pixels8* HeadlessEditor::pictureIn(const std::string& widget) const {
  const std::vector<Drawn> pictures = drawnIn(widget);
  return pictures.empty() ? nullptr : pictures.back().picture;
}

void HeadlessEditor::frame() {
  frameOf(kFrame_s);
}

void HeadlessEditor::frameOf(float length_s) {
  ImGuiIO& io = ImGui::GetIO();
  theme_ = session_->settings().darkTheme ? Theme::dark() : Theme::light();
  const float wanted = session_->settings().interfaceSize * screen_.scale;
  const float scale = interfaceScale(wanted, screen_.width, screen_.height);
  if (scale != shownScale_) {
    shownScale_ = scale;
    fonts_ = loadFonts(*io.Fonts, scale);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  theme_.apply(ImGui::GetStyle(), scale);
  io.DeltaTime = length_s;
  time_s_ += length_s;
  ImGui::NewFrame();
  probe_.beginFrame();
  Ui ui{theme_, fonts_, probe_, memory_, scale, time_s_};
  session_->frame(ui);
  ImGui::Render();
  wakeIn_s_ = ui.wakeIn;
}

/// Between the parts of a gesture: until ImGui has seen what was done.
void HeadlessEditor::settle() {
  for (int i = 0; i < kFramesHeld; ++i) frame();
}

/// After a gesture: long enough that the next is none of a double click. What it brings about settles in the frames
/// after that time.
void HeadlessEditor::pause() {
  frameOf(1.2f * ImGui::GetIO().MouseDoubleClickTime);
  for (int i = 0; i < kFramesPerEvent; ++i) frame();
}

void HeadlessEditor::until(const std::string& what, const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + Wakes::kHangs;
  for (;;) {
    for (int i = 0; i < kFramesPerEvent; ++i) {
      if (condition()) return;
      frame();
    }
    if (std::chrono::steady_clock::now() > end) throw Vain("waited in vain until " + what + "; " + plight());
    // As long as the real window sleeps, and the frame after it knows.
    const double sleep_s = std::min(wakeIn_s_, 5.0);
    if (!wakes_.wait(std::chrono::duration<double>(sleep_s))) frameOf(static_cast<float>(sleep_s));
  }
}

void HeadlessEditor::edits(const std::string& what, const std::function<void()>& act) {
  const uint64_t before = number("revision");
  act();
  until(what, [&] { return number("revision") > before; });
}

void HeadlessEditor::untilPictured() {
  until("the picture follows the fabric", [this] {
    return number("generation") > 0 && number("shown_generation") == number("generation") &&
           fact("shown_sketch") == "no";
  });
}

ImVec2 HeadlessEditor::centre(const std::string& widget) {
  ImVec4 last(-1, -1, -1, -1);
  until(widget + " is on the screen, and rests", [&] {
    const auto found = snapshot().widgets.find(widget);
    if (found == snapshot().widgets.end()) return false;
    const Rect now = found->second;
    const bool rests = now == last;
    last = ImVec4(now.x0, now.y0, now.x1, now.y1);
    return rests;
  });
  return ImVec2(0.5f * (last.x + last.z), 0.5f * (last.y + last.w));
}

void HeadlessEditor::move(ImVec2 place) {
  input_.move(place);
  settle();
}

void HeadlessEditor::press(int button) {
  input_.button(button, true);
  settle();
}

void HeadlessEditor::release(int button) {
  input_.button(button, false);
  settle();
}

void HeadlessEditor::clickAt(ImVec2 place, int button) {
  move(place);
  press(button);
  release(button);
  pause();
}

void HeadlessEditor::drag(ImVec2 start, ImVec2 end, int button, int steps) {
  move(start);
  press(button);
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(steps);
    move(ImVec2(start.x + t * (end.x - start.x), start.y + t * (end.y - start.y)));
  }
  release(button);
  pause();
}

void HeadlessEditor::dragWidget(const std::string& widget, float dx, float dy) {
  const ImVec2 from = centre(widget);
  drag(from, ImVec2(from.x + dx, from.y + dy));
}

void HeadlessEditor::wheelAt(ImVec2 place, float clicks) {
  move(place);
  input_.wheel(clicks);
  settle();
}

void HeadlessEditor::hold(const std::string& key) {
  input_.key(key, true);
  settle();
}

void HeadlessEditor::let(const std::string& key) {
  input_.key(key, false);
  settle();
}

void HeadlessEditor::key(const std::string& combination) {
  std::vector<std::string> parts;
  for (size_t from = 0; from <= combination.size();) {
    const size_t to = std::min(combination.find('+', from), combination.size());
    parts.push_back(combination.substr(from, to - from));
    from = to + 1;
  }
  for (const std::string& part : parts) hold(part);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) let(*part);
  settle();
}

void HeadlessEditor::character(const std::string& utf8) {
  input_.character(utf8);
  settle();
}

void HeadlessEditor::type(const std::string& text) {
  until("a text field listens", [this] { return fact("text_input") == "yes"; });
  input_.type(text);
  settle();
}

void HeadlessEditor::enter(const std::string& field, const std::string& text) {
  click(field);
  until("the field listens", [this] { return fact("text_input") == "yes"; });
  key("ctrl+a");
  type(text);
  key("Return");
}

void HeadlessEditor::choose(const std::string& list, const std::string& choice) {
  click(list);
  click(list + "/" + choice);
}

void HeadlessEditor::drop(const std::string& file) {
  session_->drop({file});
  frame();
}

void HeadlessEditor::nameFile(const std::string& file) {
  enter("browser.name", file);
}

void HeadlessEditor::answer(int index) {
  click(fmt::format("message.answer_{}", index));
  untilNoDialogIsOpen();
}

Fabric HeadlessEditor::saved() {
  const std::string file = fact("file");
  key("ctrl+s");
  until("the cloth is saved", [this] { return fact("dirty") == "no" && fact("dialog") == "none"; });
  return readFabric(file);
}

Fabric HeadlessEditor::savedAs(const std::string& file) {
  key("ctrl+shift+s");
  nameFile(file);
  until("the cloth is saved as " + file, [&] { return fact("file") == file && fact("dialog") == "none"; });
  return readFabric(file);
}

PictureSpread spreadOf(const Pixels8& picture) {
  double sum = 0, squares = 0;
  for (const uint8_t byte : picture.bytes) {
    const double value = byte / 255.0;
    sum += value;
    squares += value * value;
  }
  const double count = static_cast<double>(std::max<size_t>(1, picture.bytes.size()));
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

}  // namespace loomlight
