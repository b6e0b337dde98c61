#include "app/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "app/keyboard_layout.h"
#include "app/room_to_draw.h"
#include "presets/error.h"
#include "ui/style.h"

namespace crest {
namespace {

GLFWwindow* create_window(const std::string& title, int width, int height, std::optional<double> scale) {
  require_room_to_draw();
  if (!glfwInit())
    throw Error("no display to open a window on (set DISPLAY, or use crest compare for pictures)");
  int x = 0, y = 0, available_width = width, available_height = height;
  float monitor_scale = 1;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    glfwGetMonitorWorkarea(monitor, &x, &y, &available_width, &available_height);
    glfwGetMonitorContentScale(monitor, &monitor_scale, nullptr);
  }
  const double times = scale.value_or(double(monitor_scale));
  width = int(times * width);
  height = int(times * height);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* window = glfwCreateWindow(std::min(width, available_width), std::min(height, available_height),
                                        title.c_str(), nullptr, nullptr);
  if (!window) {
    glfwTerminate();
    throw Error("the graphics driver gives no window with OpenGL 4.5 core");
  }
  return window;
}

WindowInput& input_of(GLFWwindow* window) {
  return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

void note_input(GLFWwindow* window) { input_of(window).any = true; }

/// Dear ImGui's callbacks are installed later, and call these.
void note_all_input(GLFWwindow* window, WindowInput& input) {
  glfwSetWindowUserPointer(window, &input);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { note_input(w); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int action, int) {
    note_input(w);
    glm::dvec2 place;
    glfwGetCursorPos(w, &place.x, &place.y);
    if (action == GLFW_PRESS) input_of(w).pressed_at = place;
    if (action == GLFW_RELEASE) input_of(w).released = true;
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { note_input(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { note_input(w); });
  glfwSetWindowRefreshCallback(window, note_input);
  glfwSetWindowCloseCallback(window, note_input);
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    note_input(w);
    for (int i = 0; i < count; ++i) input_of(w).dropped.emplace_back(paths[i]);
  });
}

/// By the present layout; one that goes up is what it went down as.
int counted_key(WindowInput& input, int key, int scancode, int action) {
  if (action == GLFW_RELEASE) {
    const auto held = input.held.extract(scancode);
    return held.empty() ? key : held.mapped();
  }
  const bool is_printable = key >= GLFW_KEY_APOSTROPHE && key <= GLFW_KEY_WORLD_2;
  const int counted = is_printable ? key_on_cap(key, glfwGetKeyName(key, scancode)) : key;
  return input.held.try_emplace(scancode, counted).first->second;
}

/// Keys and what they type are kept until the next frame, instead of going to Dear ImGui at once.
void queue_keys(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    note_input(w);
    WindowInput& input = input_of(w);
    input.keys.push_back({counted_key(input, key, scancode, action), scancode, action, mods});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    note_input(w);
    input_of(w).keys.push_back({0, 0, GLFW_REPEAT, 0, character});
  });
}

/// Whether a key only types its character, where a field is open. It needs no frame of its own.
bool is_text(const KeyEvent& event) {
  const bool printable = (event.key >= GLFW_KEY_SPACE && event.key <= GLFW_KEY_GRAVE_ACCENT) || event.key < 0;
  return printable && (event.mods & ~GLFW_MOD_SHIFT) == 0 && ImGui::GetIO().WantTextInput;
}

/// Tells Dear ImGui of the keys: all that went down, up to the first that goes up after it, which waits for
/// the next frame. So a key that is pressed and released within a slow frame is not lost, nor the Ctrl that
/// was held with it. Keys of text wait with going up alone, so that a text does not take a frame a letter.
void tell_keys(GLFWwindow* window, std::deque<KeyEvent>& keys) {
  std::deque<KeyEvent> ups;
  std::set<int> text_keys;  // that went down in this frame
  for (bool pressed = false; !keys.empty(); keys.pop_front()) {
    const KeyEvent event = keys.front();
    if (event.character != 0) {
      ImGui_ImplGlfw_CharCallback(window, event.character);
    } else if (event.action == GLFW_RELEASE && text_keys.contains(event.key)) {
      ups.push_back(event);
    } else {
      if (pressed && event.action == GLFW_RELEASE) break;
      if (event.action == GLFW_PRESS) {
        if (is_text(event))
          text_keys.insert(event.key);
        else
          pressed = true;
      }
      ImGui_ImplGlfw_KeyCallback(window, event.key, event.scancode, event.action, event.mods);
    }
  }
  keys.insert(keys.begin(), ups.begin(), ups.end());
}

}  // namespace

Window::Window(const std::string& title, int width, int height, std::optional<double> scale)
    : window_(create_window(title, width, height, scale)), title_(title) {
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  note_all_input(window_, input_);
  ImGui::CreateContext();
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGui::GetIO().IniFilename = nullptr;  // the layout is ours; nothing is left in the folder
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  queue_keys(window_);
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::poll_events(bool wait, double seconds) {
  if (wait)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

void Window::set_style(float scale, Theme theme) {
  // The first frame makes the texture itself
  const bool has_texture = ImGui::GetIO().Fonts->TexID != nullptr;
  if (has_texture) ImGui_ImplOpenGL3_DestroyFontsTexture();
  apply_style(scale, theme);
  if (has_texture) ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Window::begin_frame() {
  // What a mouse button ends is over before the keys count that came after it. One that went down and up
  // since the last frame ends in the second from now.
  const bool goes_up = ImGui::IsAnyMouseDown() && !is_mouse_down();
  if (!std::exchange(input_.released, false) && !goes_up) tell_keys(window_, input_.keys);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // A press counts where it was, however far the mouse has come since
  if (const auto place = std::exchange(input_.pressed_at, std::nullopt))
    ImGui::GetIO().MousePos = ImVec2(float(place->x), float(place->y));
  ImGui::NewFrame();
}

void Window::end_frame() {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);  // else it bounds the clear, where something left it on
  const ImVec4 background = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
  glClearColor(background.x, background.y, background.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

bool Window::take_close_request() {
  const bool requested = glfwWindowShouldClose(window_);
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return requested;
}

std::vector<std::string> Window::take_dropped() { return std::exchange(input_.dropped, {}); }

bool Window::had_input() { return std::exchange(input_.any, !input_.keys.empty()); }

bool Window::is_mouse_down() const {
  for (const int button : {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_MIDDLE})
    if (glfwGetMouseButton(window_, button) == GLFW_PRESS) return true;
  return false;
}

float Window::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x;
}

void Window::set_title(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

bool has_display() {
  const char* display = std::getenv("DISPLAY");
  return display && *display && glfwInit();  // a display that does not answer is none
}

}  // namespace crest
