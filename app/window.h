#pragma once

#include <deque>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/theme.h"

struct GLFWwindow;

namespace crest {

/// A key that went down or up, as GLFW tells it but by what is on its cap; or a character that was typed.
struct KeyEvent {
  int key, scancode, action, mods;
  unsigned character = 0;  ///< then the others have no meaning
};

/// What came in since it was last asked for.
struct WindowInput {
  bool any = true;
  std::vector<std::string> dropped;      ///< files
  std::deque<KeyEvent> keys;             ///< not yet told to Dear ImGui
  std::map<int, int> held;               ///< by scancode: as which key it went down
  std::optional<glm::dvec2> pressed_at;  ///< where a mouse button went down
  bool released = false;                 ///< a mouse button went up
};

/// The studio's window: GLFW with an OpenGL 4.5 core context, and Dear ImGui in it.
class Window {
 public:
  /// At most as large as the screen; `width` and `height` are for `scale` 1, and without a scale for the
  /// monitor's. Throws Error when there is no display, or no such context.
  Window(const std::string& title, int width, int height, std::optional<double> scale);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Handles what came in; with `wait`, sleeps until something does (at most `seconds`).
  void poll_events(bool wait, double seconds);
  /// The style of what is drawn, from the next frame on.
  void set_style(float scale, Theme theme);
  void begin_frame();
  void end_frame();

  bool take_close_request();                ///< true once after the close button was pressed
  std::vector<std::string> take_dropped();  ///< files dropped since the last call
  bool had_input();                         ///< since the last call
  bool is_mouse_down() const;
  float content_scale() const;  ///< 2 on a screen of twice the usual density
  void set_title(const std::string& title);

 private:
  GLFWwindow* window_ = nullptr;
  WindowInput input_;
  std::string title_;
};

/// Whether there is a display that a window could open on.
bool has_display();

}  // namespace crest
