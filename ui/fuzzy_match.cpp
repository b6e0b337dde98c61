#include "ui/fuzzy_match.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace crest {
namespace {

constexpr int at_word_start = 8, after_the_last = 5, at_all = 1, none = -1;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }
int lower(char c) { return std::tolower(static_cast<unsigned char>(c)); }

int worth(std::string_view text, std::size_t i) {
  const bool begins = is_word(text[i]) && (i == 0 || !is_word(text[i - 1]));
  return at_all + (begins ? at_word_start : 0);
}

/// The best of all ways to find the letters of a word: `best[i]` is that of its beginning whose last letter
/// is found at i.
int word_score(std::string_view word, std::string_view text) {
  std::vector<int> best(text.size(), none), before;
  for (std::size_t letter = 0; letter < word.size(); ++letter) {
    before = std::exchange(best, std::vector<int>(text.size(), none));
    int earlier = letter == 0 ? 0 : none;  // the best at some place before i - 1
    for (std::size_t i = 0; i < text.size(); ++i) {
      const int last = letter > 0 && i > 0 && before[i - 1] != none ? before[i - 1] + after_the_last : none;
      const int so_far = std::max(earlier, last);
      if (lower(text[i]) == lower(word[letter]) && so_far != none) best[i] = so_far + worth(text, i);
      if (i > 0 && letter > 0) earlier = std::max(earlier, before[i - 1]);
    }
  }
  return text.empty() ? none : std::ranges::max(best);
}

}  // namespace

std::optional<int> match_score(std::string_view typed, std::string_view text) {
  int score = 0;
  for (std::size_t at = 0; at < typed.size();) {
    const std::size_t end = std::min(typed.find(' ', at), typed.size());
    if (end > at) {
      const int of_word = word_score(typed.substr(at, end - at), text);
      if (of_word == none) return std::nullopt;
      score += of_word;
    }
    at = end + 1;
  }
  return score;
}

}  // namespace crest
