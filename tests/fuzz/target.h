#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crest::fuzz {

/// What reads bytes that anyone may have made. Reading them ends, within moderate time and memory, or throws
/// crest::Error; all else is a find.
struct Target {
  std::string_view name;
  void (*read)(std::string_view input);
  std::vector<std::string> (*seeds)();  ///< inputs that are right, made by code
  int mutations;                        ///< of the seeds that the test tries: as many as take about a second
};

std::span<const Target> targets();

/// A promise that was not kept.
struct Find : std::logic_error {
  using std::logic_error::logic_error;
};
void require(bool holds, std::string_view promise);

/// Has the target read the input. Throws Find, or what else the target should not.
void run(const Target& target, std::string_view input);

/// The words, numbers and marks that the seeds are made of, and numbers at the edges of types. Sorted.
std::vector<std::string> words_of(const std::vector<std::string>& seeds);

}  // namespace crest::fuzz
