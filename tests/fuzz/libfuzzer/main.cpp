// crest_fuzz --target=NAME [--seeds=FOLDER] [--words=FILE] [libFuzzer's own options and folders]: has
// libFuzzer look for inputs of one target. It may write its seeds first, and its words as a dictionary.
// Without a target it lists them.
#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace crest::fuzz {
namespace {

const Target* chosen = nullptr;  // libFuzzer's functions are given nothing of ours

/// What follows `option` in one of the words; empty where none begins with it.
std::string_view value_of(std::string_view option, int count, char** words) {
  for (int i = 1; i < count; ++i)
    if (const std::string_view word = words[i]; word.starts_with(option)) return word.substr(option.size());
  return {};
}

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : chosen->seeds())
    std::ofstream(folder / fmt::format("seed{}", number++), std::ios::binary) << seed;
}

/// Of libFuzzer's form: "\x00\xff", a line each.
void write_words(const std::filesystem::path& file) {
  std::ofstream out(file);
  for (const std::string& word : words_of(chosen->seeds())) {
    out << '"';
    for (const char byte : word) out << fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    out << "\"\n";
  }
}

void begin(int count, char** words) {
  const std::string_view name = value_of("--target=", count, words);
  for (const Target& target : targets()) {
    if (target.name == name) chosen = &target;
    if (name.empty()) fmt::print("{}\n", target.name);
  }
  if (!chosen) std::exit(name.empty() ? 0 : 2);
  if (const auto folder = value_of("--seeds=", count, words); !folder.empty()) write_seeds(folder);
  if (const auto file = value_of("--words=", count, words); !file.empty()) write_words(file);
}

}  // namespace
}  // namespace crest::fuzz

extern "C" {

int LLVMFuzzerInitialize(int* count, char*** words) {
  crest::fuzz::begin(*count, *words);
  return 0;
}

/// What the target should not throw ends the program, which libFuzzer takes for a find.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  crest::fuzz::run(*crest::fuzz::chosen, {reinterpret_cast<const char*>(data), size});
  return 0;
}
}
