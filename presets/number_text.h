#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "presets/fields.h"

namespace crest {

// Numbers as people type and read them: in the fields of a window and on a command line.

/// What was typed: a number, or why it is none, in words.
struct TypedNumber {
  std::optional<double> number;
  std::string wrong;
};

/// "0.5", ".5", "1e-4", "1/2", and "0,5" with a decimal comma. A text that can be read in two ways ("1,000")
/// is refused, and so is what a double cannot hold.
TypedNumber read_number(std::string_view text);

/// A change of a number as it is typed: a new one, or "+=2", "-=2", "*=2", "/=2".
struct NumberEdit {
  char operation = '=';  ///< or one of + - * /
  double number = 0;
  double operator()(double before) const;
};
struct TypedEdit {
  std::optional<NumberEdit> edit;
  std::string wrong;
};
TypedEdit read_edit(std::string_view text);

/// Why a field does not take this number; empty where it does.
std::string why_outside(double value, const FieldRule& rule);

/// The shortest text that reads back as exactly this number.
std::string exact_text(double value);

/// `value` without the digits that a calculation with numbers as large as `scale` gets wrong: to the 15th
/// digit of `scale`. 0.1 + 0.2 is 0.3.
double without_noise(double value, double scale);

}  // namespace crest
