#pragma once

#include <imgui.h>

#include <array>
#include <string_view>
#include <vector>

#include "ui/theme.h"

namespace crest {

/// The colours of one theme.
struct Palette {
  // Grounds
  ImU32 window;  ///< what the window is cleared to
  ImU32 bar;     ///< of menus, popups, dialogs
  ImU32 title;   ///< of dialogs' titles and tables' headers
  ImU32 plot, card;
  ImU32 field, raised, hovered, pressed;  ///< of fields and buttons
  ImU32 caution, alarm;                   ///< of banners
  ImU32 on_picture;                       ///< behind words on a picture, nearly opaque
  // Lines and areas
  ImU32 grid, frame, edge;  ///< `edge` is around fields and buttons
  ImU32 histogram, histogram_surface, empty_cell;
  ImU32 curve;
  // Text and marks
  ImU32 text, secondary, accent, good, warning, error;
  ImU32 emphasis;  ///< of what must be seen before all: white or black
  /// What methods and the like are told apart by on a plot.
  std::array<ImU32, 8> series;
};

const Palette& palette_of(Theme theme);

/// Of the theme that apply_style() gave Dear ImGui's current context.
const Palette& palette();

/// The colour with its alpha times `alpha`.
ImU32 faded(ImU32 color, float alpha);

/// Which texts stand on which grounds, with their names, for those who check that they can be read.
struct TextOnGround {
  std::string_view text, ground;
  ImU32 text_color, ground_color;
};
std::vector<TextOnGround> texts_on_grounds(const Palette& palette);

}  // namespace crest
