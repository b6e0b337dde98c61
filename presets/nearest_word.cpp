#include "presets/nearest_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace crest {
namespace {

constexpr std::size_t least_beginning = 3;  ///< letters from which a word's beginning says which one is meant
constexpr std::size_t longest_word = 64;    ///< what is longer is no word, and would take long

char small(char c) { return char(std::tolower(static_cast<unsigned char>(c))); }

bool begins_with(std::string_view whole, std::string_view beginning) {
  return beginning.size() >= least_beginning && whole.size() >= beginning.size() &&
         edit_distance(whole.substr(0, beginning.size()), beginning) == 0;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between the beginnings of both words: two back, the last one, this one
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = int(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = int(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = small(a[i - 1]) == small(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) && small(a[i - 2]) == small(b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
  if (word.size() > longest_word) return {};
  const auto begun = std::ranges::find_if(known, [&](std::string_view k) { return begins_with(k, word); });
  if (begun != known.end()) return *begun;
  std::string_view nearest;
  int least = int(word.size()) / 3 + 1;  // a word within a third is nearer
  for (const std::string_view candidate : known) {
    const int distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearest_word(word, known);
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

}  // namespace crest
