#pragma once

#include <cstdint>
#include <string>

#include "ui/widgets.h"

namespace crest {

/// A picture with two lines under it, as one button.
struct Card {
  std::string name;            ///< of the item, unique in its window
  std::uintptr_t picture = 0;  ///< an ImTextureID in the shape of a thumbnail, 4:3; 0: there is none
  std::string title;           ///< cut where it is too long
  std::string text;            ///< dim, in two lines; the rest is cut
  std::string tooltip;
};

/// Its size without the gap to the next one.
ImVec2 card_size();
/// Draws it at the cursor. Returns whether it was pressed.
bool card(WidgetState& state, const Card& what);

/// Where the i-th card of a row of them goes; moves the cursor there. `columns` as column_count() says.
int column_count();  ///< cards side by side in the room that there is, at least 1
void place_card(int index, int columns);

}  // namespace crest
