#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <cctype>

namespace crest::fuzz {
namespace {

/// In [0, count). Not std::uniform_int_distribution, which is another one in each standard library.
std::size_t below(std::size_t count, std::mt19937& random) { return count == 0 ? 0 : random() % count; }

const std::string& any_of(const std::vector<std::string>& texts, std::mt19937& random) {
  return texts[below(texts.size(), random)];
}

struct Part {
  std::size_t begin = 0, length = 0;
};

/// Most are short.
Part any_part(const std::string& text, std::mt19937& random) {
  const std::size_t begin = below(text.size(), random), left = text.size() - begin;
  const std::size_t most = random() % 4 == 0 ? left : std::min<std::size_t>(left, 16);
  return {begin, below(most + 1, random)};
}

/// The letters and digits about a place.
Part word_about(const std::string& text, std::size_t at) {
  const auto is_word = [&](std::size_t i) {
    return std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '-' || text[i] == '.';
  };
  std::size_t begin = at, end = at;
  while (begin > 0 && is_word(begin - 1)) --begin;
  while (end < text.size() && is_word(end)) ++end;
  return {begin, end - begin};
}

void change(std::string& text, const std::vector<std::string>& seeds, const std::vector<std::string>& words,
            std::mt19937& random) {
  if (text.empty()) text = any_of(words, random);
  const std::size_t at = below(text.size(), random);
  const Part part = any_part(text, random);
  switch (random() % 10) {
    case 0:
      text[at] = char(text[at] ^ 1 << random() % 8);
      break;
    case 1:
      text[at] = char(random());
      break;
    case 2:
      text.erase(part.begin, part.length);
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      text.insert(at, text.substr(part.begin, part.length));
      break;
    case 5: {
      const std::string& other = any_of(seeds, random);
      const Part theirs = any_part(other, random);
      text.replace(part.begin, part.length, other, theirs.begin, theirs.length);
      break;
    }
    case 6:
      text.insert(at, any_of(words, random));
      break;
    case 7: {  // as in binary headers
      const std::string& word = any_of(words, random);
      text.replace(at, word.size(), word);
      break;
    }
    default: {
      const Part word = word_about(text, at);
      text.replace(word.begin, word.length, any_of(words, random));
    }
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
                    std::mt19937& random) {
  std::string text = any_of(seeds, random);
  const auto changes = random() % 3 == 0 ? 1 + random() % 6 : 1;
  for (auto i = changes; i > 0; --i) change(text, seeds, words, random);
  return text;
}

}  // namespace crest::fuzz
