#include "tests/gpu/reading/test_output.h"

namespace crest::gpu {
namespace {

/// What follows `tag` in a line that begins with it: a test's name, without its time.
std::string name_after(std::string_view line, std::string_view tag) {
  std::string_view name = line.substr(tag.size());
  return std::string(name.substr(0, name.find_first_of(" ,")));
}

}  // namespace

void TestOutput::add(const TestOutput& other) {
  passed += other.passed;
  skipped += other.skipped;
  failed.insert(failed.end(), other.failed.begin(), other.failed.end());
  unfinished.insert(unfinished.end(), other.unfinished.begin(), other.unfinished.end());
}

TestOutput read_test_output(std::string_view text) {
  constexpr std::string_view run = "[ RUN      ] ", ok = "[       OK ] ", failed = "[  FAILED  ] ",
                             skipped = "[  SKIPPED ] ";
  TestOutput all;
  std::string running, output;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.starts_with(run)) {
      running = name_after(line, run);
      output.clear();
    } else if (running.empty()) {
      continue;
    } else if (line.starts_with(ok) && name_after(line, ok) == running) {
      ++all.passed;
      running.clear();
    } else if (line.starts_with(skipped) && name_after(line, skipped) == running) {
      ++all.skipped;
      running.clear();
    } else if (line.starts_with(failed) && name_after(line, failed) == running) {
      all.failed.push_back({running, tail_of(output)});
      running.clear();
    } else {
      output.append(line).append("\n");
    }
  }
  if (!running.empty()) all.unfinished.push_back({running, tail_of(output)});
  return all;
}

std::string tail_of(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return std::string(text);
  text.remove_prefix(text.size() - most_bytes);
  const std::size_t line = text.find('\n');
  return std::string(line == text.npos ? text : text.substr(line + 1));
}

}  // namespace crest::gpu
