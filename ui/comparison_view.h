#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Keeps the document's preset to be compared with; the newest 16 stay.
std::shared_ptr<const OtherPreset> take_snapshot(ViewsState& views, const Preset& preset);

/// The preset of this file for the part of the views that a file dialog was opened for; what is wrong with it
/// goes to ViewsState::error.
void take_other_preset(ViewsState& views, const std::string& file);

/// Whether the view is the one that is compared.
bool compares_view(const ViewsState& views, int index);

/// Compares the view with something else, in the way that is chosen; `follows` is Comparison::follows.
void choose_other(ViewsState& views, int index, const ViewContent& with, std::optional<int> follows = {});

/// Chooses what a view is compared with, and how. To be called in a popup.
void comparison_menu(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset);

/// Moves the line between both pictures with the mouse. `is_active`: the view's picture is held. Returns
/// whether the mouse belongs to the line.
bool move_divider(ViewsState& views, bool is_hovered, bool is_active, ImVec2 low, ImVec2 size);

/// Both pictures in the place of the view's, and what is to be known of them. Says whether it drew: without a
/// picture to compare with it does not.
bool draw_comparison(StudioState& state, const StudioInputs& inputs, ImVec2 low, ImVec2 size);

}  // namespace crest
