#include "render/volume/header_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "presets/error.h"
#include "render/volume/query.h"

namespace crest {

bool HeaderLines::next(std::string_view& line) {
  const std::size_t end = text_.find('\n', position_);
  if (end == std::string_view::npos) return false;
  line = text_.substr(position_, end - position_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  position_ = end + 1;
  return true;
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

std::vector<std::filesystem::path> files_of_pattern(std::string_view name,
                                                    const std::filesystem::path& folder,
                                                    const std::vector<std::string>& parts) {
  constexpr std::int64_t most_files = 1 << 20;
  static const std::regex pattern(R"(([^%]*)%(0?)(\d{0,2})[du]([^%]*))");
  std::smatch match;
  std::int64_t numbers[3] = {0, 0, 1};
  bool good = parts.size() >= 3 && std::regex_match(parts[0], match, pattern);
  for (std::size_t i = 0; good && i < std::min<std::size_t>(parts.size() - 1, 3); ++i) {
    const auto number = to_integer(parts[i + 1]);
    good = number && std::abs(*number) <= most_files;
    if (good) numbers[i] = *number;
  }
  const auto [first, last, step] = numbers;
  if (!good || step == 0 || (last - first) / step < 0) {
    throw Error(fmt::format("{}: its voxel files \"{}\" are not like \"slice.%03d 1 93 1\"", name,
                            fmt::join(parts, " ")));
  }
  const int width = match[3].length() > 0 ? std::stoi(match[3]) : 0;
  std::vector<std::filesystem::path> files;
  for (std::int64_t i = first; step > 0 ? i <= last : i >= last; i += step) {
    const std::string number =
        match[2].length() > 0 ? fmt::format("{:0{}}", i, width) : fmt::format("{:{}}", i, width);
    files.push_back(folder / (match[1].str() + number + match[4].str()));
  }
  return files;
}

}  // namespace crest
