// What the program keeps of its own between two runs, and people may have edited.
#include <fmt/core.h>

#include <random>

#include "app/config_file.h"
#include "app/recovery_text.h"
#include "app/studio_settings.h"
#include "presets/number_text.h"
#include "presets/printable.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"
#include "tests/fuzz/volume_file.h"
#include "tests/presets/random_preset.h"

namespace crest::fuzz {
namespace {

bool has_digit(const std::string& text) { return text.find_first_of("0123456789") != text.npos; }

template <class T>
OptionRow row(const std::string& name, const std::string& value_name, T* value) {
  OptionRow row;
  row.names = {name};
  row.value_name = value_name;
  row.value = value;
  return row;
}

}  // namespace

void read_recovery(std::string_view input) {
  const KeptDocument kept = parse_recovery(input, "file");
  const std::string text = recovery_text(kept);
  require(recovery_text(parse_recovery(text, "again")) == text, "a document is kept as it is");
}

std::vector<std::string> recovery_seeds() {
  std::vector<std::string> seeds;
  std::mt19937 random(4);
  for (int i = 0; i < 6; ++i) {
    KeptDocument kept{.document = {}, .time = std::chrono::system_clock::time_point(std::chrono::hours(i))};
    kept.document.preset = random_preset(random);
    kept.document.volume_source = i % 2 ? "builtin:sphere?n=8" : "/a/head.nrrd?stride=2";
    kept.document.library_name = i % 3 ? "" : "onion";
    seeds.push_back(recovery_text(kept));
  }
  for (const char* time : {"9223372036854775806", "-1e300"}) {
    std::string text = seeds[0];
    const std::string field = "\"time\": ";
    const std::size_t begin = text.find(field) + field.size();
    seeds.push_back(text.replace(begin, text.find(',', begin) - begin, time));
  }
  return seeds;
}

void read_settings_file(std::string_view input) {
  const ReadSettings read = read_settings(write_scratch("settings.json", input));
  require(printable(read.problem) == read.problem, "what is wrong is one line for people");
  const double scale = read.settings.scale.value_or(1);
  require(why_outside(scale, scale_rule).empty(), "a scale is within its bounds");
  const std::string file = write_scratch("written.json", input);
  write_settings(file, read.settings);
  const ReadSettings again = read_settings(file);
  require(again.problem.empty(), "settings are right once they were written");
  require(again.settings == read.settings, "settings are the same when they are written and read again");
}

std::vector<std::string> settings_seeds() {
  return {R"({"theme": "light", "scale": 1.5, "data_values": true, "large_peak_table": false})",
          R"({"theme": "dark", "scale": "automatic", "another": [1, 2, {"a": null}]})"};
}

void read_config(std::string_view input) {
  std::string size = "512x512", mode = "PEAK_XOR_DVR", for_all = "a";
  std::vector<std::string> set;
  int frames = 1;
  bool json = false;
  OptionTable table;
  table.commands.resize(2);
  table.commands[0].options = {row("--theme", "T", &for_all)};
  table.commands[0].name = "window";
  table.commands[1].name = "render";
  table.commands[1].options = {row("--size", "S", &size), row("--mode", "M", &mode), row("--set", "F", &set),
                               row("--frames", "N", &frames), row("--json", "", &json)};
  table.commands[1].options[0].checks = {[](const std::string& text) -> std::string {
    return has_digit(text) ? "" : "there is no digit in it";
  }};
  apply_config(table, input, "config.json");
  require(has_digit(size), "a value is one that the option takes");
  for (const CommandRow& command : table.commands)
    for (const OptionRow& row : command.options)
      if (row.is_set) row.unset();
  require(
      size == "512x512" && mode == "PEAK_XOR_DVR" && set.empty() && frames == 1 && !json && for_all == "a",
      "what the file set can be taken back");
}

std::vector<std::string> config_seeds() {
  return {
      R"({"size": "20x10", "theme": "light", "render": {"mode": "DVR_ONLY", "json": true}})",
      R"({"render": {"set": ["rendering.step=2", "name=a"], "frames": 3, "size": 8}, "window": {"theme": "b"}})"};
}

}  // namespace crest::fuzz
