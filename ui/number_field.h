#pragma once

#include <functional>
#include <optional>
#include <span>

#include "presets/number_text.h"
#include "ui/widgets.h"

namespace crest {

// Fields for numbers, shown and taken with full precision, as read_edit() reads them. Enter, Tab, a click
// elsewhere and the keys of WidgetState::take_typed take what was typed; Escape does not. What cannot be
// taken stays in the field, in red, with the reason under it. `name` is the field's ID (give it "##"); it is
// noted as an item, where its text was refused as "NAME/refused", and while one types in it as "typing".

/// Opens the field that comes next, to be typed in. What is typed until it is ready is not lost.
void open_next_field(WidgetState& state, const char* name);

/// Hands a field what was typed before it was ready. To be called just before it is drawn.
void keep_typed_ahead(TypedAhead& ahead, ImGuiID id);

/// A field that shows `shown`. Returns what was typed, if `why_not` has nothing against it.
std::optional<NumberEdit> number_entry(WidgetState& state, const char* name, const std::string& shown,
                                       const std::function<std::string(const NumberEdit&)>& why_not,
                                       float width);

/// Returns whether the value changed.
bool number_field(WidgetState& state, const char* name, double& value, const FieldRule& rule, float width);
bool integer_field(WidgetState& state, const char* name, int& value, int least, int most, float width);

/// A field that is dragged from side to side, too: a click without a drag types. `dragged` tells the number
/// that is so many pixels from one; it is kept within the rule.
bool drag_field(WidgetState& state, const char* name, double& value, const FieldRule& rule, float width,
                const std::function<double(double from, double pixels)>& dragged);

/// Several values in a field of this width: the one that they have, or their range.
std::string numbers_text(std::span<const double> values, float width);
/// A field for all of them, each of which must stay within the rule. Returns what is to be done to each.
std::optional<NumberEdit> numbers_field(WidgetState& state, const char* name, std::span<const double> values,
                                        const FieldRule& rule, float width);

}  // namespace crest
