#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace crest::test {

/// What a run of the program left.
struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the real program in a folder of its own, which is gone afterwards.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// The program with these arguments, without a display. `shell_prefix` goes before it in the shell's line
  /// ("ulimit -f 1;"); a run of more than 600 seconds ends with exit code 124.
  Outcome run(const std::vector<std::string>& arguments, const std::string& shell_prefix = "") const;
  /// A line of the shell, run in the folder in the same way.
  Outcome run_shell(const std::string& line) const;
  /// A run that must succeed, and what it printed.
  std::string output_of(const std::vector<std::string>& arguments) const;
  nlohmann::json json_of(const std::vector<std::string>& arguments) const;
  /// A run that must fail with `exit_code`: one line on stderr with all `parts` in it, nothing on stdout, and
  /// the folder as it was.
  void expect_error(int exit_code, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& parts, const std::string& shell_prefix = "") const;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file in the folder and returns its path.
  std::string write(const std::string& name, const std::string& content) const;
  /// The names in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path folder_;
};

std::string content_of(const std::filesystem::path& file);

/// A shell's prefix for a run that gets Ctrl-C after so long.
std::string interrupted_after(int seconds);

/// `first` with `rest` behind it.
std::vector<std::string> operator+(std::vector<std::string> first, const std::vector<std::string>& rest);

}  // namespace crest::test
