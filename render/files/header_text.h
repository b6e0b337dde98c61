#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace crest {

/// The lines at the head of a file, and where they end.
class HeaderLines {
 public:
  /// `head`: the file's first bytes.
  explicit HeaderLines(std::string_view head) : text_(head) {}

  /// Takes the next line, without its end, which the last one need not have; false when none is left.
  bool next(std::string_view& line);
  std::size_t position() const { return position_; }  ///< bytes taken

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// Headers longer than this are refused: they are not headers.
inline constexpr std::size_t longest_header = std::size_t(1) << 20;

/// The first bytes of a file, at most `size`.
std::string read_head(const std::filesystem::path& path, std::size_t size);

std::string_view trim(std::string_view text);
std::string lower(std::string_view text);
std::vector<std::string> words(std::string_view text);

/// A library's message with its line ends and tabs as spaces.
std::string one_line(std::string_view text);

/// The files that "slice.%03d 1 93 1" (a printf pattern, first, last, step) names, in `folder`. Throws Error,
/// which begins with `name`, for a pattern that is not that.
std::vector<std::filesystem::path> files_of_pattern(std::string_view name,
                                                    const std::filesystem::path& folder,
                                                    const std::vector<std::string>& parts);

}  // namespace crest
