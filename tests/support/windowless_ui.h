#pragma once

#include <functional>

#include "ui/widgets/ui.h"

namespace loomlight::test {

/// Dear ImGui without a window, for tests of a panel or two.
class WindowlessUi {
 public:
  explicit WindowlessUi(ImVec2 display) : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = display;
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    fonts_ = loadFonts(*io.Fonts, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~WindowlessUi() { ImGui::DestroyContext(context_); }
  WindowlessUi(const WindowlessUi&) = delete;
  WindowlessUi& operator=(const WindowlessUi&) = delete;

  /// A frame that shows this, a 60th of a second after the one before.
  void frame(const Theme& theme, const std::function<void(Ui&)>& content) {
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    probe_.beginFrame();
    Ui ui{theme, fonts_, probe_, memory_, 1, 0};
    content(ui);
    ImGui::Render();
  }
  const WidgetProbe& probe() const { return probe_; }

 private:
  ImGuiContext* context_;
  Fonts fonts_;
  WidgetProbe probe_{true};
  FieldMemory memory_;
};

}  // namespace loomlight::test
