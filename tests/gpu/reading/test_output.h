#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crest::gpu {

struct FailedTest {
  std::string name, output;  ///< the end of what it printed
};

/// What a GoogleTest program told before it ended, or was ended.
struct TestOutput {
  int passed = 0, skipped = 0;
  std::vector<FailedTest> failed;
  std::vector<FailedTest> unfinished;  ///< the test that ran at the end of the output

  void add(const TestOutput& other);
};

/// Reads the lines "[ RUN      ] name", "[       OK ] name", ... and what lies between them.
TestOutput read_test_output(std::string_view text);

/// The last lines of a text, of at most so many bytes.
std::string tail_of(std::string_view text, std::size_t most_bytes = 4000);

}  // namespace crest::gpu
