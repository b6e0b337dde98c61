#include "ui/style.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace crest {
namespace {

constexpr TextSize sizes[] = {TextSize::body, TextSize::heading, TextSize::title};

ImVec4 color(ImU32 packed) { return ImGui::ColorConvertU32ToFloat4(packed); }

bool add_font(const char* file, float pixels) {
  for (const char* folder :
       {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/", "/usr/share/fonts/dejavu/"}) {
    std::error_code ignored;
    const std::string path = std::string(folder) + file;
    if (!std::filesystem::is_regular_file(path, ignored)) continue;
    ImFontConfig config;
    config.OversampleH = 2;
    if (ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), pixels, &config)) return true;
  }
  return false;
}

/// One font for each of `sizes`, in their order.
void load_fonts(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  for (const TextSize size : sizes) {
    const float pixels = std::round(pixels_of(size) * scale);
    if (add_font(size == TextSize::body ? "DejaVuSans.ttf" : "DejaVuSans-Bold.ttf", pixels)) continue;
    ImFontConfig config;
    config.SizePixels = pixels;
    fonts.AddFontDefault(&config);
  }
}

void set_colors(ImVec4* colors, const Palette& p) {
  const ImVec4 accent = color(p.accent);
  const auto with_alpha = [](ImVec4 c, float alpha) { return ImVec4(c.x, c.y, c.z, alpha); };
  const ImVec4 raised = color(p.raised), hovered = color(p.hovered);
  colors[ImGuiCol_Text] = color(p.text);
  colors[ImGuiCol_TextDisabled] = color(p.secondary);
  colors[ImGuiCol_WindowBg] = color(p.window);
  colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_PopupBg] = color(p.bar);
  // Dimming the whole window costs a software renderer as much as everything else.
  colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_Border] = color(p.edge);
  colors[ImGuiCol_FrameBg] = color(p.field);
  colors[ImGuiCol_FrameBgHovered] = raised;
  colors[ImGuiCol_FrameBgActive] = hovered;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = color(p.title);
  colors[ImGuiCol_MenuBarBg] = color(p.bar);
  colors[ImGuiCol_Button] = raised;
  colors[ImGuiCol_ButtonHovered] = hovered;
  colors[ImGuiCol_ButtonActive] = color(p.pressed);
  colors[ImGuiCol_Header] = with_alpha(accent, 0.25f);
  colors[ImGuiCol_HeaderHovered] = with_alpha(accent, 0.32f);
  colors[ImGuiCol_HeaderActive] = with_alpha(accent, 0.42f);
  colors[ImGuiCol_CheckMark] = accent;
  colors[ImGuiCol_SliderGrab] = with_alpha(accent, 0.8f);
  colors[ImGuiCol_SliderGrabActive] = accent;
  colors[ImGuiCol_Separator] = color(p.frame);
  colors[ImGuiCol_SeparatorHovered] = colors[ImGuiCol_SeparatorActive] = accent;
  colors[ImGuiCol_Tab] = color(p.window);
  colors[ImGuiCol_TabHovered] = hovered;
  colors[ImGuiCol_TabActive] = raised;
  colors[ImGuiCol_TabUnfocused] = color(p.window);
  colors[ImGuiCol_TabUnfocusedActive] = raised;
  colors[ImGuiCol_TableHeaderBg] = color(p.title);
  colors[ImGuiCol_TableBorderLight] = with_alpha(color(p.frame), 0.6F);
  colors[ImGuiCol_TableBorderStrong] = color(p.frame);
  colors[ImGuiCol_TextSelectedBg] = with_alpha(accent, 0.40f);
  colors[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_ScrollbarGrab] = color(p.edge);
  colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = accent;
  colors[ImGuiCol_NavHighlight] = accent;
}

}  // namespace

void apply_style(float scale, Theme theme) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.ScrollbarSize = 12;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = style.FrameBorderSize = 1;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
  style.PopupRounding = style.WindowRounding = 4;
  style.WindowTitleAlign = {0.5f, 0.5f};
  set_colors(style.Colors, palette_of(theme));
  style.ScaleAllSizes(scale);
  load_fonts(scale);
  ImGui::GetIO().IniFilename = nullptr;
}

ImFont* font_of(TextSize size) {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  return fonts[std::min(int(size), fonts.Size - 1)];
}

}  // namespace crest
