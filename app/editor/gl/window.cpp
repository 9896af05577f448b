#include "app/editor/gl/window.h"

#define GLFW_INCLUDE_NONE
#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/display/frame_digest.h"
#include "app/editor/display/interface_scale.h"
#include "app/editor/display/keyboard_layout.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/units.h"
#include "ui/widgets/keys.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace {

std::string lastError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : words::errors::noReason;
}

/// Pixels per unit of the interface. Where the system scales windows itself, coordinates are scaled already.
float monitorScale(GLFWwindow* window) {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  int windowWidth = 1, windowHeight = 1, pixelWidth = 1, pixelHeight = 1;
  glfwGetWindowSize(window, &windowWidth, &windowHeight);
  glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
  const float system = windowWidth > 0 ? static_cast<float>(pixelWidth) / static_cast<float>(windowWidth) : 1.0f;
  return std::clamp(x / std::max(system, 1.0f), 0.75f, 4.0f);
}

}  // namespace

Window::Window(const std::string& title, int width, int height, float scale) {
  if (!glfwInit()) throw InputError(fmt::format(words::errors::noWindow, lastError()));
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // By this name desktops know which entry of their menu a window belongs to (StartupWMClass; the entry's own name).
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "loomlight");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "loomlight");
#ifdef GLFW_WAYLAND_APP_ID  // since GLFW 3.4
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "loomlight");
#endif
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = lastError();
    glfwTerminate();
    throw InputError(fmt::format(words::errors::noOpenGl, reason));
  }
  glfwSetWindowSizeLimits(window_, 960, 600, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    auto* self = static_cast<Window*>(glfwGetWindowUserPointer(window));
    self->dropped_.insert(self->dropped_.end(), paths, paths + count);
  });

  noticeInput();

  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // a sleeping editor would not blink it
  io.MouseDragThreshold = 3;
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  if constexpr (!kAsksForTheLayout)
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int mods) {
      const int meant = keyOnLayout(key, glfwGetKeyName(key, scancode));
      ImGui_ImplGlfw_KeyCallback(window, meant, scancode, action, mods);
    });
  ImGui_ImplOpenGL3_Init("#version 330 core");
  givenScale_ = scale;
  scale_ = wantedScale();
  fonts_ = loadFonts(*io.Fonts, scale_);
  setTheme(theme_);
}

Window::~Window() {
  displayPass_.reset();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::setTheme(const Theme& theme) {
  theme_ = theme;
  theme.apply(ImGui::GetStyle(), scale_);
}

void Window::setDisplayCube(std::shared_ptr<const ColourCube> cube) {
  if (displayPass_->use(std::move(cube))) drawAnew();
}

void Window::setTitle(const std::string& title) {
  if (title == shownTitle_) return;
  shownTitle_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

/// Dear ImGui calls these in turn from its own, so they must be there before it.
void Window::noticeInput() {
  static constexpr auto seen = [](GLFWwindow* window) {
    static_cast<Window*>(glfwGetWindowUserPointer(window))->inputSeen_ = true;
  };
  static constexpr auto counted = [](GLFWwindow* window) {
    seen(window);
    ++static_cast<Window*>(glfwGetWindowUserPointer(window))->inputCount_;
  };
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { counted(window); });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { counted(window); });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { counted(window); });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int, int, int, int) { counted(window); });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned) { seen(window); });
  static constexpr auto placed = [](GLFWwindow* window, int, int) {
    seen(window);
    auto* self = static_cast<Window*>(glfwGetWindowUserPointer(window));
    self->pixels_per_mm_.reset();
    self->drawAnew();
  };
  glfwSetWindowSizeCallback(window_, placed);
  glfwSetWindowPosCallback(window_, placed);
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) {
    seen(window);
    static_cast<Window*>(glfwGetWindowUserPointer(window))->drawAnew();
  });
}

bool Window::waitForEvents(double seconds) {
  inputSeen_ = false;
  if (seconds <= 0) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(seconds);
  }
  return inputSeen_;
}

void Window::wake() {
  glfwPostEmptyEvent();
}

float Window::wantedScale() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return interfaceScale(interfaceSize_ * (givenScale_ > 0 ? givenScale_ : monitorScale(window_)), width, height);
}

void Window::setInterfaceSize(float factor) {
  interfaceSize_ = factor;
}

void Window::followScale() {
  const float scale = wantedScale();
  if (std::abs(scale - scale_) < 0.01f) return;
  scale_ = scale;
  fonts_ = loadFonts(*ImGui::GetIO().Fonts, scale_);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  setTheme(theme_);
}

GLFWmonitor* Window::monitor() const {
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetWindowPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  int count = 0;
  GLFWmonitor* const* const monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const int inX = x + width / 2 - left, inY = y + height / 2 - top;
    if (mode && inX >= 0 && inX < mode->width && inY >= 0 && inY < mode->height) return monitors[i];
  }
  return glfwGetPrimaryMonitor();
}

double Window::pixels_per_mm() {
  if (!pixels_per_mm_) pixels_per_mm_ = askDisplay_per_mm();
  return *pixels_per_mm_;
}

double Window::askDisplay_per_mm() const {
  constexpr double kUsual = 96 / kMmPerInch;
  GLFWmonitor* const monitor = this->monitor();
  const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  int width_mm = 0, height_mm = 0;
  if (monitor) glfwGetMonitorPhysicalSize(monitor, &width_mm, &height_mm);
  if (!mode || width_mm <= 0) return kUsual;
  const double said = static_cast<double>(mode->width) / width_mm;
  return said > 1 && said < 40 ? said : kUsual;  // projectors and virtual displays say anything
}

void Window::beginFrame() {
  followScale();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

bool Window::endFrame(const Theme& theme, uint64_t pictureChanges) {
  ImGui::Render();
  const uint64_t frame = hashCombine(digestOf(*ImGui::GetDrawData()), pictureChanges);
  if (onScreen_ == frame) return false;
  onScreen_ = frame;
  ++drawnCount_;
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  displayPass_->begin(width, height);
  glViewport(0, 0, width, height);
  glClearColor(theme.window.x, theme.window.y, theme.window.z, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  displayPass_->end();
  glfwSwapBuffers(window_);
  return true;
}

bool Window::closeWanted() const {
  return glfwWindowShouldClose(window_);
}

void Window::refuseClose() {
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

void Window::setFullScreen(bool on) {
  if (on == fullScreen_) return;
  GLFWmonitor* const monitor = this->monitor();
  if (!monitor) return;
  if (on) {
    glfwGetWindowPos(window_, &windowedX_, &windowedY_);
    glfwGetWindowSize(window_, &windowedWidth_, &windowedHeight_);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else {
    glfwSetWindowMonitor(window_, nullptr, windowedX_, windowedY_, windowedWidth_, windowedHeight_, GLFW_DONT_CARE);
  }
  fullScreen_ = on;
}

ImVec2 Window::sizeInWindow() const {
  int width = windowedWidth_, height = windowedHeight_;
  if (!fullScreen_) glfwGetWindowSize(window_, &width, &height);
  return ImVec2(static_cast<float>(width), static_cast<float>(height));
}

std::vector<std::string> Window::takeDroppedFiles() {
  return std::exchange(dropped_, {});
}

}  // namespace loomlight
