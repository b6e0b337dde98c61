#include "render/files/header_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <sstream>

#include "presets/error.h"
#include "render/volume/query.h"

namespace crest {

bool HeaderLines::next(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  line = text_.substr(position_, end - position_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  position_ = std::min(end + 1, text_.size());
  return true;
}

std::string read_head(const std::filesystem::path& path, std::size_t size) {
  std::string head(size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), std::streamsize(size));
  head.resize(std::size_t(file.gcount()));
  return head;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

std::vector<std::string> words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::string one_line(std::string_view text) {
  std::string line(trim(text));
  std::ranges::replace_if(
      line, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return line;
}

namespace {

/// A name with one number in it, as printf would write it: "slice.%03d".
struct NumberedName {
  std::string before, after;
  std::size_t width = 0;
  bool zeros = false;

  std::string at(std::int64_t number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < width) digits.insert(0, width - digits.size(), zeros ? '0' : ' ');
    return before + digits + after;
  }
};

std::optional<NumberedName> parse_numbered_name(const std::string& text) {
  const std::size_t percent = text.find('%'), end = text.find_first_not_of("0123456789", percent + 1);
  if (percent == std::string::npos || end == std::string::npos || (text[end] != 'd' && text[end] != 'u')) {
    return std::nullopt;
  }
  const std::string width = text.substr(percent + 1, end - percent - 1);
  if (width.size() > 2 || text.find('%', end) != std::string::npos) return std::nullopt;
  return NumberedName{text.substr(0, percent), text.substr(end + 1), width.empty() ? 0 : std::stoul(width),
                      width.starts_with('0')};
}

}  // namespace

std::vector<std::filesystem::path> files_of_pattern(std::string_view name,
                                                    const std::filesystem::path& folder,
                                                    const std::vector<std::string>& parts) {
  constexpr std::int64_t most_files = 1 << 20;
  const auto number = [&](std::size_t i) { return i < parts.size() ? to_integer(parts[i]) : std::nullopt; };
  const auto pattern = parts.empty() ? std::nullopt : parse_numbered_name(parts[0]);
  const auto first = number(1), last = number(2), step = parts.size() > 3 ? number(3) : 1;
  const auto fits = [](std::optional<std::int64_t> n) { return n && *n >= -most_files && *n <= most_files; };
  if (!pattern || !fits(first) || !fits(last) || !fits(step) || *step == 0) {
    throw Error(fmt::format("{}: its voxel files \"{}\" are not like \"slice.%03d 1 93 1\"", name,
                            fmt::join(parts, " ")));
  }
  std::vector<std::filesystem::path> files;
  for (std::int64_t i = *first; *step > 0 ? i <= *last : i >= *last; i += *step)
    files.push_back(folder / pattern->at(i));
  return files;
}

}  // namespace crest
