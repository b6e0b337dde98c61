#include "presets/exchange/script_text.h"

#include <fmt/core.h>

#include <iterator>

namespace crest {
namespace {

constexpr const char* tuple = "    ({}, {}, {}, {}, {}),\n";

}  // namespace

std::string python_points(const TransferFunction& tf, const std::vector<double>& values) {
  std::string text = "[  # value, red, green, blue, opacity\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& p = tf.points[i];
    fmt::format_to(std::back_inserter(text), tuple, values[i], p.color.r, p.color.g, p.color.b, p.opacity);
  }
  return text + "]\n";
}

std::string python_peaks(const std::vector<Peak>& peaks) {
  if (peaks.empty()) return "[]\n";
  std::string text = "[  # value, red, green, blue, opacity of one crossing\n";
  for (const Peak& p : peaks)
    fmt::format_to(std::back_inserter(text), tuple, p.value, p.color.r, p.color.g, p.color.b, p.opacity);
  return text + "]\n";
}

std::string python_string(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      literal += {'\\', c};
    else if (c >= 0 && c < ' ')
      fmt::format_to(std::back_inserter(literal), "\\x{:02x}", c);
    else
      literal += c;
  }
  return literal + "\"";
}

std::string shell_string(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c >= 0 && c < ' ') c = ' ';
  return text;
}

}  // namespace crest
