#include "ui/style.h"

#include <cmath>
#include <filesystem>

namespace crest {
namespace {

constexpr float font_pixels = 14;

ImVec4 color(ImU32 packed) { return ImGui::ColorConvertU32ToFloat4(packed); }

void load_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  const float pixels = std::round(font_pixels * scale);
  for (const char* path : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                           "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"}) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) continue;
    ImFontConfig config;
    config.OversampleH = 2;
    if (fonts.AddFontFromFileTTF(path, pixels, &config)) return;
  }
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  fonts.AddFontDefault(&config);
}

void set_colors(ImVec4* colors) {
  const ImVec4 accent = color(palette::accent);
  const auto with_alpha = [](ImVec4 c, float alpha) { return ImVec4(c.x, c.y, c.z, alpha); };
  const ImVec4 field = color(IM_COL32(40, 44, 52, 255)), raised = color(IM_COL32(54, 59, 70, 255)),
               hovered = color(IM_COL32(66, 73, 87, 255)), pressed = color(IM_COL32(72, 82, 98, 255));
  colors[ImGuiCol_Text] = color(palette::text);
  colors[ImGuiCol_TextDisabled] = color(palette::dim);
  colors[ImGuiCol_WindowBg] = color(palette::window);
  colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_PopupBg] = color(IM_COL32(30, 33, 39, 255));
  // Dimming the whole window costs a software renderer as much as everything else.
  colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_Border] = color(palette::frame);
  colors[ImGuiCol_FrameBg] = field;
  colors[ImGuiCol_FrameBgHovered] = raised;
  colors[ImGuiCol_FrameBgActive] = hovered;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = color(IM_COL32(38, 42, 50, 255));
  colors[ImGuiCol_MenuBarBg] = color(IM_COL32(30, 33, 39, 255));
  colors[ImGuiCol_Button] = raised;
  colors[ImGuiCol_ButtonHovered] = hovered;
  colors[ImGuiCol_ButtonActive] = pressed;
  colors[ImGuiCol_Header] = with_alpha(accent, 0.25f);
  colors[ImGuiCol_HeaderHovered] = with_alpha(accent, 0.32f);
  colors[ImGuiCol_HeaderActive] = with_alpha(accent, 0.42f);
  colors[ImGuiCol_CheckMark] = accent;
  colors[ImGuiCol_SliderGrab] = with_alpha(accent, 0.8f);
  colors[ImGuiCol_SliderGrabActive] = accent;
  colors[ImGuiCol_Separator] = color(palette::frame);
  colors[ImGuiCol_SeparatorHovered] = colors[ImGuiCol_SeparatorActive] = accent;
  colors[ImGuiCol_Tab] = color(palette::window);
  colors[ImGuiCol_TabHovered] = hovered;
  colors[ImGuiCol_TabActive] = raised;
  colors[ImGuiCol_TabUnfocused] = color(palette::window);
  colors[ImGuiCol_TabUnfocusedActive] = raised;
  colors[ImGuiCol_TableHeaderBg] = color(IM_COL32(34, 37, 44, 255));
  colors[ImGuiCol_TableBorderLight] = color(IM_COL32(44, 48, 56, 255));
  colors[ImGuiCol_TableBorderStrong] = color(palette::frame);
  colors[ImGuiCol_NavHighlight] = accent;
  colors[ImGuiCol_TextSelectedBg] = with_alpha(accent, 0.40f);
  colors[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_ScrollbarGrab] = raised;
}

}  // namespace

void apply_style(float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.ScrollbarSize = 12;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
  style.PopupRounding = style.WindowRounding = 4;
  style.WindowTitleAlign = {0.5f, 0.5f};
  set_colors(style.Colors);
  style.ScaleAllSizes(scale);
  load_font(scale);
  ImGui::GetIO().IniFilename = nullptr;
}

}  // namespace crest
