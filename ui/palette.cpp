#include "ui/palette.h"

namespace crest {
namespace {

constexpr ImU32 rgb(int r, int g, int b, int a = 255) { return IM_COL32(r, g, b, a); }

constexpr Palette dark{
    .window = rgb(22, 24, 28),
    .bar = rgb(30, 33, 39),
    .title = rgb(38, 42, 50),
    .plot = rgb(15, 16, 19),
    .card = rgb(32, 35, 41),
    .field = rgb(38, 42, 50),
    .raised = rgb(54, 59, 70),
    .hovered = rgb(66, 73, 87),
    .pressed = rgb(72, 82, 98),
    .caution = rgb(66, 54, 26),
    .alarm = rgb(72, 32, 28),
    .on_picture = rgb(12, 13, 16, 210),
    .grid = rgb(255, 255, 255, 18),
    .frame = rgb(62, 66, 76),
    .edge = rgb(74, 80, 92),
    .histogram = rgb(54, 62, 76),
    .histogram_surface = rgb(70, 112, 150),
    .empty_cell = rgb(26, 28, 33),
    .curve = rgb(226, 230, 236, 230),
    .text = rgb(222, 226, 232),
    .secondary = rgb(170, 177, 188),
    .accent = rgb(106, 176, 240),
    .good = rgb(110, 214, 170),
    .warning = rgb(240, 194, 96),
    .error = rgb(255, 140, 122),
    .emphasis = rgb(255, 255, 255),
    .series = {rgb(86, 180, 233), rgb(240, 138, 60), rgb(62, 201, 160), rgb(221, 139, 203), rgb(230, 192, 74),
               rgb(143, 156, 245), rgb(214, 168, 120), rgb(255, 125, 166)},
};

constexpr Palette light{
    .window = rgb(240, 241, 244),
    .bar = rgb(250, 250, 252),
    .title = rgb(226, 229, 234),
    .plot = rgb(255, 255, 255),
    .card = rgb(252, 252, 253),
    .field = rgb(255, 255, 255),
    .raised = rgb(222, 225, 231),
    .hovered = rgb(208, 213, 222),
    .pressed = rgb(192, 200, 212),
    .caution = rgb(253, 240, 208),
    .alarm = rgb(253, 226, 222),
    .on_picture = rgb(250, 250, 252, 220),
    .grid = rgb(0, 0, 0, 24),
    .frame = rgb(186, 191, 200),
    .edge = rgb(166, 172, 183),
    .histogram = rgb(204, 210, 220),
    .histogram_surface = rgb(130, 170, 206),
    .empty_cell = rgb(236, 238, 242),
    .curve = rgb(40, 44, 52, 235),
    .text = rgb(26, 29, 34),
    .secondary = rgb(78, 84, 94),
    .accent = rgb(0, 92, 168),
    .good = rgb(0, 96, 70),
    .warning = rgb(124, 76, 0),
    .error = rgb(172, 36, 24),
    .emphasis = rgb(0, 0, 0),
    .series = {rgb(0, 114, 178), rgb(190, 82, 0), rgb(0, 122, 90), rgb(164, 72, 132), rgb(140, 104, 0),
               rgb(84, 92, 200), rgb(130, 84, 36), rgb(200, 36, 96)},
};

}  // namespace

const Palette& palette_of(Theme theme) { return theme == Theme::light ? light : dark; }

const Palette& palette() {
  // The context's own colours tell which theme it has: nothing else has to be kept
  const ImVec4 ground = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  return palette_of(ground.x + ground.y + ground.z > 1.5F ? Theme::light : Theme::dark);
}

ImU32 faded(ImU32 color, float alpha) {
  ImVec4 parts = ImGui::ColorConvertU32ToFloat4(color);
  parts.w *= alpha;
  return ImGui::ColorConvertFloat4ToU32(parts);
}

std::vector<TextOnGround> texts_on_grounds(const Palette& p) {
  std::vector<TextOnGround> pairs;
  const auto add = [&](std::string_view text, ImU32 color,
                       std::initializer_list<std::pair<std::string_view, ImU32>> grounds) {
    for (const auto& [ground, ground_color] : grounds) pairs.push_back({text, ground, color, ground_color});
  };
  add("text", p.text,
      {{"window", p.window},
       {"bar", p.bar},
       {"title", p.title},
       {"plot", p.plot},
       {"card", p.card},
       {"field", p.field},
       {"raised", p.raised},
       {"hovered", p.hovered},
       {"pressed", p.pressed},
       {"alarm", p.alarm},
       {"on_picture", p.on_picture}});
  add("secondary", p.secondary,
      {{"window", p.window},
       {"bar", p.bar},
       {"title", p.title},
       {"plot", p.plot},
       {"card", p.card},
       {"field", p.field},
       {"raised", p.raised}});
  const std::initializer_list<std::pair<std::string_view, ImU32>> panels = {
      {"window", p.window}, {"bar", p.bar}, {"plot", p.plot}};
  add("accent", p.accent, panels);
  add("good", p.good, panels);
  add("warning", p.warning, panels);
  add("warning", p.warning, {{"caution", p.caution}});
  add("error", p.error, panels);
  add("error", p.error, {{"field", p.field}, {"alarm", p.alarm}});
  for (const ImU32 color : p.series) add("series", color, {{"plot", p.plot}, {"bar", p.bar}});
  return pairs;
}

}  // namespace crest
