#include "program.h"
#include "presets/json.h"
#include "tests/paths.h"

#include <fmt/core.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

namespace crest::test {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string inner;
  for (const char c : text) inner += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return fmt::format("'{}'", inner);
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "crest-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  return name;
}

/// The files of a folder with their sizes and times.
std::map<std::string, std::pair<std::uintmax_t, fs::file_time_type>> state_of(const fs::path& folder) {
  std::map<std::string, std::pair<std::uintmax_t, fs::file_time_type>> state;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool is_file = entry.is_regular_file() && !entry.is_symlink();
    state[entry.path().string()] = {is_file ? entry.file_size() : 0,
                                    is_file ? entry.last_write_time() : fs::file_time_type()};
  }
  return state;
}

}  // namespace

ProgramTest::ProgramTest() : folder_(new_folder()) {}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome ProgramTest::run(const std::vector<std::string>& arguments, const std::string& shell_prefix) const {
  std::string words = quoted(crest_program().string());
  for (const std::string& argument : arguments) words += fmt::format(" {}", quoted(argument));
  return run_shell(fmt::format("{} exec timeout 600 {}", shell_prefix, words));
}

Outcome ProgramTest::run_shell(const std::string& line) const {
  const fs::path streams = new_folder();
  const std::string whole = fmt::format(
      "cd {} && unset DISPLAY && export XDG_CONFIG_HOME={}/config && ({}) >{} 2>{}", quoted(folder_.string()),
      quoted(streams.string()), line, quoted((streams / "out").string()), quoted((streams / "err").string()));
  const int status = std::system(whole.c_str());
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(streams / "out"),
                  content_of(streams / "err")};
  fs::remove_all(streams);
  return outcome;
}

std::string ProgramTest::output_of(const std::vector<std::string>& arguments) const {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

nlohmann::json ProgramTest::json_of(const std::vector<std::string>& arguments) const {
  const auto json = nlohmann::json::parse(output_of(arguments), nullptr, false);
  EXPECT_TRUE(json.is_object());
  return json;
}

void ProgramTest::expect_error(int exit_code, const std::vector<std::string>& arguments,
                               const std::vector<std::string>& parts, const std::string& shell_prefix) const {
  std::string line;
  for (const std::string& argument : arguments) line += fmt::format(" {}", argument);
  SCOPED_TRACE("crest" + line);
  const auto before = state_of(folder_);
  const Outcome outcome = run(arguments, shell_prefix);
  EXPECT_EQ(outcome.exit_code, exit_code);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("crest: ")) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("\n")) << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.find(".crest-"), std::string::npos) << "names a temporary file: " << outcome.err;
  for (const std::string& part : parts)
    EXPECT_NE(outcome.err.find(part), std::string::npos) << '"' << part << "\" is not in: " << outcome.err;
  EXPECT_EQ(state_of(folder_), before) << "the files of the folder changed";
}

std::string ProgramTest::write(const std::string& name, const std::string& content) const {
  std::ofstream(folder_ / name, std::ios::binary) << content;
  return path(name);
}

std::vector<std::string> ProgramTest::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string interrupted_after(int seconds) {
  return fmt::format("self=$(exec sh -c 'echo $PPID'); (sleep {}; kill -INT $self) &", seconds);
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> operator+(std::vector<std::string> first, const std::vector<std::string>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace crest::test
