#include "app/editor_image.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>

#include "render/gl/render_target.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float usual_height = 360;  // pixels, of a picture with text of the usual size
constexpr float least_scale = 0.5F, largest_scale = 12;

/// A Dear ImGui of its own, beside the window's.
class OwnImGui {
 public:
  OwnImGui(glm::ivec2 size, float scale, Theme theme)
      : before_(ImGui::GetCurrentContext()), own_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(own_);
    try {
      begin(size, scale, theme);
    } catch (...) {
      end();
      throw;
    }
  }
  ~OwnImGui() { end(); }
  OwnImGui(const OwnImGui&) = delete;
  OwnImGui& operator=(const OwnImGui&) = delete;

  void draw_into(const gl::RenderTarget& target) {
    ImGui::Render();
    const ImVec4 background = ImGui::ColorConvertU32ToFloat4(palette().window);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

 private:
  static void begin(glm::ivec2 size, float scale, Theme theme) {
    apply_style(scale, theme);
    ImGui::GetIO().DisplaySize = {float(size.x), float(size.y)};
    ImGui_ImplOpenGL3_Init("#version 450 core");
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
  }
  void end() {
    if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(own_);
    ImGui::SetCurrentContext(before_);
  }

  ImGuiContext *before_, *own_;
};

}  // namespace

Image editor_image(const Document& document, const EditorState& editor, const StudioInputs& inputs,
                   glm::ivec2 size, Theme theme) {
  const gl::RenderTarget target(size, false);
  OwnImGui gui(size, std::clamp(float(size.y) / usual_height, least_scale, largest_scale), theme);
  draw_editor_picture(document, editor, inputs, {float(size.x), float(size.y)});
  gui.draw_into(target);
  Image image = target.read_color();
  // Dear ImGui's first row is GL's last one
  for (int y = 0; y < size.y / 2; ++y)
    std::swap_ranges(&image.at(0, y), &image.at(0, y) + size.x, &image.at(0, size.y - 1 - y));
  return image;
}

}  // namespace crest
