#pragma once

#include <string>

#include "ui/shapes.h"
#include "ui/studio_state.h"

namespace crest {

// The menus over the plot, which are also in the right-click menu. Each returns whether it changed the
// transfer function.

/// Adds a shape, in a colour of its own, and has its value typed.
bool add_shape(TransferFunction& tf, EditorState& editor, Shape shape, double value, double opacity,
               ValueRange visible);
/// A shape where there is most room.
bool add_shape(TransferFunction& tf, EditorState& editor, Shape shape, ValueRange visible);

/// All shapes to be added, and opacities over all values.
bool shapes_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange visible);
/// What can be done to several points; how points move.
bool points_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange volume,
                 ValueRange visible);

/// "Add spike": the action that does.
std::string adding(Shape shape);

/// The width that a new shape gets: as typed, or a share of what is in sight; a spike's is no wider than it
/// may be.
double new_width(const TransferFunction& tf, const EditorState& editor, Shape shape, ValueRange visible);

}  // namespace crest
