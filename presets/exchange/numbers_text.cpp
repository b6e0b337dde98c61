#include "presets/exchange/numbers_text.h"

#include <charconv>
#include <cmath>
#include <string>

namespace crest {

std::optional<std::vector<double>> to_numbers(std::string_view text) {
  constexpr std::string_view separators = " \t\r\n\v\f,;";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    std::size_t begin = at;
    if (text[begin] == '+') ++begin;
    double number = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || stop != text.data() + end || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    at = text.find_first_not_of(separators, end);
  }
  return numbers;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace crest
