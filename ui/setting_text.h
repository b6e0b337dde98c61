#pragma once

#include <array>
#include <string>
#include <string_view>

#include "presets/names.h"
#include "ui/widgets.h"

namespace crest {

/// What a setting's value is called for people, and what it means, in one sentence; `name_of` is what it is
/// called in files.
struct ValueText {
  std::string_view title, meaning;
};
ValueText text_of(Mode mode);
ValueText text_of(Engine engine);
ValueText text_of(Placement placement);
ValueText text_of(Sampling sampling);
ValueText text_of(ClassificationMethod method);
ValueText text_of(PeakForm form);
ValueText text_of(Filter filter);
ValueText text_of(Shading shading);
ValueText text_of(Gradient gradient);
ValueText text_of(BlendMode mode);

/// One of the entries of a combo box.
struct TitledChoice {
  std::string_view title, name, meaning;  ///< `name` as in files; it is in the tooltip
};
/// As choice(), by titles. Items are noted by the names in files.
bool titled_choice(WidgetState& state, const char* name, int& value, std::span<const TitledChoice> choices,
                   float width);

template <NamedEnum Enum>
TitledChoice titled(Enum value) {
  const ValueText text = text_of(value);
  return {text.title, name_of(value), text.meaning};
}

template <NamedEnum Enum>
bool titled_choice(WidgetState& state, const char* name, Enum& value, float width) {
  constexpr std::size_t count = std::size(EnumNames<Enum>::table);
  std::array<TitledChoice, count> choices;
  int index = 0;
  for (std::size_t i = 0; i < count; ++i) {
    choices[i] = titled(EnumNames<Enum>::table[i].value);
    if (EnumNames<Enum>::table[i].value == value) index = int(i);
  }
  if (!titled_choice(state, name, index, choices, width)) return false;
  value = EnumNames<Enum>::table[std::size_t(index)].value;
  return true;
}

}  // namespace crest
