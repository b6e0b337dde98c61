#include "presets/number_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace crest {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

TypedNumber refused(std::string_view text, std::string_view why) {
  return {std::nullopt, fmt::format("\"{}\" {}", text.substr(0, 40), why)};
}

/// Whether a comma may divide thousands: "1,000", but not "0,125".
bool may_divide_thousands(std::string_view text, std::size_t comma) {
  const std::string_view before = text.substr(text.find_first_of("0123456789,"));
  const std::size_t digits = text.find_first_not_of("0123456789", comma + 1);
  const std::size_t after = (digits == std::string_view::npos ? text.size() : digits) - comma - 1;
  return after == 3 && before.front() != '0' && before.front() != ',';
}

/// A number without a fraction's bar.
TypedNumber read_plain(std::string_view typed) {
  std::string text(trimmed(typed));
  if (text.starts_with('+')) text.erase(0, 1);
  if (const std::size_t comma = text.find(','); comma != std::string::npos) {
    if (text.find_first_of(",.", comma + 1) != std::string::npos || text.find('.') < comma)
      return refused(typed, "has more than one decimal point");
    if (may_divide_thousands(text, comma))
      return refused(typed, "can be read in two ways: type a point, or no comma");
    text[comma] = '.';
  }
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  if (stop != end || fault == std::errc::invalid_argument) return refused(typed, "is not a number");
  if (fault == std::errc::result_out_of_range) return refused(typed, "is beyond what a number can be");
  if (!std::isfinite(number)) return refused(typed, "is not a number");
  return {number, {}};
}

}  // namespace

TypedNumber read_number(std::string_view text) {
  const std::string_view typed = trimmed(text);
  if (typed.empty()) return refused(typed, "is not a number");
  const std::size_t bar = typed.find('/');
  if (bar == std::string_view::npos) return read_plain(typed);
  const TypedNumber over = read_plain(typed.substr(0, bar)), under = read_plain(typed.substr(bar + 1));
  if (!over.number || !under.number) return refused(typed, "is not a fraction like 1/2");
  if (*under.number == 0) return refused(typed, "divides by zero");
  const double quotient = *over.number / *under.number;
  if (!std::isfinite(quotient)) return refused(typed, "is beyond what a number can be");
  return {quotient, {}};
}

double NumberEdit::operator()(double before) const {
  switch (operation) {
    case '+':
      return without_noise(before + number, std::max(std::abs(before), std::abs(number)));
    case '-':
      return without_noise(before - number, std::max(std::abs(before), std::abs(number)));
    case '*':
      return without_noise(before * number, std::abs(before * number));
    case '/':
      return without_noise(before / number, std::abs(before / number));
    default:
      return number;
  }
}

TypedEdit read_edit(std::string_view text) {
  std::string_view rest = trimmed(text);
  NumberEdit edit;
  if (rest.size() >= 2 && rest[1] == '=' &&
      std::string_view("+-*/").find(rest[0]) != std::string_view::npos) {
    edit.operation = rest[0];
    rest.remove_prefix(2);
  }
  const TypedNumber typed = read_number(rest);
  if (!typed.number) return {std::nullopt, typed.wrong};
  if (edit.operation == '/' && *typed.number == 0) return {std::nullopt, "nothing can be divided by zero"};
  edit.number = *typed.number;
  return {edit, {}};
}

std::string why_outside(double value, const FieldRule& rule) {
  const bool inside = (rule.open_min ? value > rule.min : value >= rule.min) &&
                      (rule.open_max ? value < rule.max : value <= rule.max);
  if (inside) return {};
  if (rule.max == any_value.max && rule.min != any_value.min)
    return fmt::format("is not {} {}", rule.open_min ? "greater than" : "at least", rule.min);
  return fmt::format("is not in {}{}, {}{}", rule.open_min ? '(' : '[', rule.min, rule.max,
                     rule.open_max ? ')' : ']');
}

std::string exact_text(double value) {
  char text[32];
  const auto [end, fault] = std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value);
  return {text, end};
}

double without_noise(double value, double scale) {
  if (!std::isfinite(value) || !(scale > 1e-280) || !std::isfinite(scale)) return value;
  const int decimals = 14 - int(std::floor(std::log10(scale)));
  if (decimals < 0) return value;
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  double tidy = value;
  std::from_chars(text.data(), text.data() + text.size(), tidy);
  return tidy;
}

}  // namespace crest
