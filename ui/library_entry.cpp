#include "ui/library_entry.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace crest {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

}  // namespace

bool matches(const LibraryEntry& entry, const std::string& search) {
  std::string all = entry.title + "\n" + entry.notes;
  for (const std::string& tag : entry.tags) all += "\n" + tag;
  all = lower(all);
  std::istringstream words(lower(search));
  for (std::string word; words >> word;)
    if (all.find(word) == all.npos) return false;
  return true;
}

}  // namespace crest
