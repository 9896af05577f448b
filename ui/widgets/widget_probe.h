#pragma once

#include <imgui.h>

#include <map>
#include <string>

namespace loomlight {

/// Where the named widgets of the last frame are on the screen, and what the editor says of itself: the eyes of the
/// tests that drive the real window. Handed to every panel; costs a branch when nobody watches.
class WidgetProbe {
 public:
  struct Rect {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool operator==(const Rect&) const = default;
  };
  struct Snapshot {
    std::map<std::string, Rect> widgets;
    std::map<std::string, std::string> facts;
    bool operator==(const Snapshot&) const = default;
  };

  explicit WidgetProbe(bool watching) : watching_(watching) {}
  bool watching() const { return watching_; }

  void beginFrame() { now_ = {}; }
  void record(const std::string& name, ImVec2 min, ImVec2 max) {
    if (watching_) now_.widgets[name] = {min.x, min.y, max.x, max.y};
  }
  /// The item that ImGui has just laid out.
  void recordItem(const std::string& name) {
    if (watching_) record(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  void fact(const std::string& name, std::string value) {
    if (watching_) now_.facts[name] = std::move(value);
  }
  const Snapshot& snapshot() const { return now_; }

 private:
  bool watching_;
  Snapshot now_;
};

}  // namespace loomlight
