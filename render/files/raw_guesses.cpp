#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "render/files/header_text.h"
#include "render/files/raw_layout.h"

namespace crest {
namespace {

constexpr std::size_t most_guesses = 12;
constexpr std::uint64_t longest_raw_header = 4096;  ///< that a guess takes for one, in bytes
constexpr int longest_axis = 1 << 16;               ///< of a guess

/// A type for each size of values that files often have, the most frequent first.
constexpr std::array usual_types{ScalarType::uint8, ScalarType::uint16, ScalarType::float32,
                                 ScalarType::float64};

struct TypeWord {
  std::string_view word;
  ScalarType type;
};
constexpr TypeWord type_words[] = {
    {"uint8", ScalarType::uint8},     {"uchar", ScalarType::uint8},    {"ubyte", ScalarType::uint8},
    {"u8", ScalarType::uint8},        {"8bit", ScalarType::uint8},     {"int8", ScalarType::int8},
    {"uint16", ScalarType::uint16},   {"ushort", ScalarType::uint16},  {"u16", ScalarType::uint16},
    {"16bit", ScalarType::uint16},    {"int16", ScalarType::int16},    {"short", ScalarType::int16},
    {"s16", ScalarType::int16},       {"uint32", ScalarType::uint32},  {"int32", ScalarType::int32},
    {"uint64", ScalarType::uint64},   {"int64", ScalarType::int64},    {"float32", ScalarType::float32},
    {"float", ScalarType::float32},   {"f32", ScalarType::float32},    {"real", ScalarType::float32},
    {"float64", ScalarType::float64}, {"double", ScalarType::float64}, {"f64", ScalarType::float64}};

/// The runs of letters and digits in a name, in small letters; "256x256x128" is three, with "x" between.
struct NameParts {
  std::vector<int> numbers;  ///< the first three that stand together, or none
  std::optional<ScalarType> type;
};

NameParts parts_of(const std::string& stem) {
  NameParts parts;
  const std::string text = lower(stem);
  std::string word;
  std::vector<int> run;
  const auto end_word = [&] {
    for (const TypeWord& one : type_words)
      if (!parts.type && word == one.word) parts.type = one.type;
    if (word.empty()) return;
    // The parts of 256x256x128, or of 256_256_128
    bool is_size = true;
    for (const std::string_view piece : split(word, 'x')) {
      const auto number = to_integer(piece);
      is_size = is_size && number && *number >= 2 && *number <= longest_axis;
      if (is_size) run.push_back(int(*number));
    }
    if (run.size() >= 3 && parts.numbers.empty()) parts.numbers.assign(run.begin(), run.begin() + 3);
    if (!is_size) run.clear();
    word.clear();
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      word += c;
    else
      end_word();
  }
  end_word();
  return parts;
}

class Guesses {
 public:
  explicit Guesses(std::uint64_t bytes) : bytes_(bytes) {}

  /// Adds it where it fits, if need be with a header before it that is no longer than `header`.
  void add(glm::ivec3 size, ScalarType type, std::uint64_t header, std::string why) {
    const std::uint64_t needed =
        std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z) * size_of(type);
    if (needed > bytes_ || bytes_ - needed > header || found_.size() >= most_guesses) return;
    RawGuess guess;
    guess.layout.size = size;
    guess.layout.type = type;
    guess.layout.offset = bytes_ - needed;
    if (guess.layout.offset > 0) why += fmt::format(", after {} bytes", guess.layout.offset);
    guess.why = std::move(why);
    const auto is_same = [&](const RawGuess& one) { return one.layout == guess.layout; };
    if (std::ranges::none_of(found_, is_same)) found_.push_back(std::move(guess));
  }
  std::vector<RawGuess> take() { return std::move(found_); }

 private:
  std::uint64_t bytes_;
  std::vector<RawGuess> found_;
};

void add_cube(Guesses& guesses, std::uint64_t bytes, ScalarType type) {
  const auto side = std::uint64_t(std::cbrt(double(bytes / size_of(type))) + 1e-6);
  if (side < 2 || side > std::uint64_t(longest_axis)) return;
  guesses.add(glm::ivec3(int(side)), type, 0, "a cube");
  // A header is likelier before a cube of a round size
  if (side % 8 == 0) guesses.add(glm::ivec3(int(side)), type, longest_raw_header, "a cube");
}

void add_stacks(Guesses& guesses, std::uint64_t bytes, ScalarType type) {
  for (const int side : {512, 256, 1024, 128, 64, 2048, 32}) {
    const std::uint64_t slice = std::uint64_t(side) * std::uint64_t(side) * size_of(type);
    const std::uint64_t depth = bytes / slice;
    if (bytes % slice == 0 && depth >= std::uint64_t(side) / 16 && depth >= 2 &&
        depth <= 4 * std::uint64_t(side))
      guesses.add({side, side, int(depth)}, type, 0, "square slices");
  }
}

}  // namespace

std::vector<RawGuess> likely_layouts(const std::filesystem::path& path, std::uint64_t file_bytes) {
  Guesses guesses(file_bytes);
  const NameParts parts = parts_of(path.stem().string());
  std::vector<ScalarType> likely(usual_types.begin(), usual_types.end());
  if (parts.type) likely.insert(likely.begin(), *parts.type);
  if (parts.numbers.size() == 3) {
    const glm::ivec3 size(parts.numbers[0], parts.numbers[1], parts.numbers[2]);
    for (const ScalarType type : likely) guesses.add(size, type, 0, "from the name");
    for (const ScalarType type : likely) guesses.add(size, type, longest_raw_header, "from the name");
  }
  for (const ScalarType type : likely) add_cube(guesses, file_bytes, type);
  for (const ScalarType type : likely) add_stacks(guesses, file_bytes, type);
  return guesses.take();
}

}  // namespace crest
