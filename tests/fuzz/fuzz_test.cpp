// The targets, without a fuzzer: their seeds, and some thousand changes of them, the same in each run. What
// libFuzzer makes of them, which takes longer, is run.sh's.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <ostream>
#include <random>

#include <fmt/core.h>

#include "presets/error.h"
#include "presets/printable.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/target.h"

namespace crest::fuzz {

/// The name that ctest shows.
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

class EveryTarget : public testing::TestWithParam<Target> {};

/// Of this thread: another program's work does not count.
double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// What was found, if the input is one.
std::string find_in(const Target& target, const std::string& input) {
  constexpr double longest_s = 10;  // sanitizers and all
  const double began = processor_seconds();
  try {
    run(target, input);
    if (processor_seconds() - began < longest_s) return "";
    return fmt::format("it took longer than {} s\nreading: {}", longest_s, printable(input, 4000));
  } catch (const std::exception& find) {
    return fmt::format("{}\nreading: {}", find.what(), printable(input, 4000));
  }
}

TEST_P(EveryTarget, ReadsItsSeeds) {
  const std::vector<std::string> seeds = GetParam().seeds();
  EXPECT_GE(seeds.size(), 2u);
  for (const std::string& seed : seeds) {
    try {
      GetParam().read(seed);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\nreading: " << printable(seed, 4000);
    }
  }
}

// CREST_FUZZ_ROUNDS=1000 tries so many times as many, and says how many those were.
TEST_P(EveryTarget, ReadsOrRefusesWhatIsDamaged) {
  const char* rounds = std::getenv("CREST_FUZZ_ROUNDS");
  const int count = GetParam().mutations * (rounds ? std::atoi(rounds) : 1);
  const std::vector<std::string> seeds = GetParam().seeds(), words = words_of(seeds);
  std::mt19937 random(15);
  for (int i = 0; i < count; ++i) {
    const std::string found = find_in(GetParam(), mutated(seeds, words, random));
    ASSERT_EQ(found, "") << "mutation " << i;
  }
  EXPECT_EQ(find_in(GetParam(), ""), "");
  if (rounds) fmt::print("{} {}\n", GetParam().name, count);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryTarget, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace crest::fuzz
