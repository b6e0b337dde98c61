#include "app/config_file.h"

#include <fmt/core.h>

#include <charconv>

#include "app/user_folders.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/nearest_word.h"

namespace crest {
namespace {

constexpr std::size_t largest_config = 1 << 20;  // bytes
constexpr std::string_view window = "window";    ///< the section of the program without a command

bool has_default(const OptionRow& row) {
  if (row.is_argument() || row.is_required) return false;
  return std::visit([](const auto* value) { return value != nullptr; }, row.value);
}

std::string key_of(const OptionRow& row) { return row.long_name().substr(2); }

OptionRow* find_row(CommandRow& command, std::string_view key) {
  for (OptionRow& row : command.options)
    if (has_default(row) && key_of(row) == key) return &row;
  return nullptr;
}

std::vector<std::string> keys_of(const CommandRow& command) {
  std::vector<std::string> keys;
  for (const OptionRow& row : command.options)
    if (has_default(row)) keys.push_back(key_of(row));
  return keys;
}

/// What is wrong with a value; nothing where it is right.
std::string why_not(const OptionRow& row, const std::string& value) {
  for (const auto& check : row.checks)
    if (const std::string why = check(value); !why.empty()) return why;
  return {};
}

/// A value as the command line would give it.
std::string text_of(const Json& json, const OptionRow& row, const std::string& path) {
  if (!json.is_string() && !json.is_number())
    throw Error(fmt::format("{}: {} is neither a text nor a number", path, summary_of(json)));
  const std::string text = json.is_string() ? json.get<std::string>() : json.dump();
  if (const std::string why = why_not(row, text); !why.empty()) throw Error(fmt::format("{}: {}", path, why));
  return text;
}

void set(bool& value, const Json& json, const OptionRow&, const std::string& path) {
  if (!json.is_boolean())
    throw Error(fmt::format("{}: {} is neither true nor false", path, summary_of(json)));
  value = json.get<bool>();
}
void set(std::string& value, const Json& json, const OptionRow& row, const std::string& path) {
  value = text_of(json, row, path);
}
void set(int& value, const Json& json, const OptionRow& row, const std::string& path) {
  const std::string text = text_of(json, row, path);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size())
    throw Error(fmt::format("{}: {} is not a whole number", path, text));
}
void set(std::vector<std::string>& values, const Json& json, const OptionRow& row, const std::string& path) {
  if (!json.is_array()) throw Error(fmt::format("{}: {} is not an array of texts", path, summary_of(json)));
  values.clear();
  for (const Json& element : json) values.push_back(text_of(element, row, path));
}

void set_row(OptionRow& row, const Json& json, const std::string& path) {
  std::visit(
      [&](auto* value) {
        if (!row.is_set) row.unset = [value, before = *value] { *value = before; };
        set(*value, json, row, path);
      },
      row.value);
  row.is_set = true;
}

[[noreturn]] void fail_unknown(const std::string& path, const std::string& key,
                               const std::vector<std::string>& known) {
  throw Error(
      fmt::format("{}: there is no such option{}", path, did_you_mean(key, {known.begin(), known.end()})));
}

void apply_section(CommandRow& command, const Json& section, const std::string& path) {
  if (!section.is_object()) throw Error(fmt::format("{}: {} is not an object", path, summary_of(section)));
  for (const auto& item : section.items()) {
    const std::string field = join_path(path, item.key());
    OptionRow* row = find_row(command, item.key());
    if (!row) fail_unknown(field, item.key(), keys_of(command));
    set_row(*row, item.value(), field);
  }
}

/// Whether the key is a command's name: its section was applied.
bool is_section(const OptionTable& table, const std::string& key) {
  return !key.empty() && std::ranges::find(table.commands, key, &CommandRow::name) != table.commands.end();
}

void apply_to_all(OptionTable& table, const Json& json) {
  std::vector<std::string> known;
  for (const CommandRow& command : table.commands) {
    if (!command.name.empty()) known.push_back(command.name);
    for (const std::string& key : keys_of(command)) known.push_back(key);
  }
  for (const auto& item : json.items()) {
    if (is_section(table, item.key())) continue;
    bool is_known = false;
    for (CommandRow& command : table.commands)
      if (OptionRow* row = find_row(command, item.key())) {
        set_row(*row, item.value(), item.key());
        is_known = true;
      }
    if (!is_known) fail_unknown(item.key(), item.key(), known);
  }
}

}  // namespace

std::filesystem::path config_file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "config.json";
}

void apply_config(OptionTable& table, std::string_view text, const std::string& source) {
  try {
    const Json json = parse_json(text);
    if (!json.is_object()) throw Error(fmt::format("{} is not an object", summary_of(json)));
    apply_to_all(table, json);
    // A section is nearer than what stands for all
    for (CommandRow& command : table.commands) {
      const std::string name = command.name.empty() ? std::string(window) : command.name;
      if (json.contains(name)) apply_section(command, json[name], name);
    }
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {} (--no-config passes over this file)", source, error.what()));
  }
}

void read_config_file(OptionTable& table) {
  const std::filesystem::path file = config_file();
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return;
  apply_config(table, read_file(file, largest_config), file.string());
}

std::vector<std::string> values_of(const OptionRow& row) {
  struct Visitor {
    std::vector<std::string> operator()(const std::string* text) const { return {*text}; }
    std::vector<std::string> operator()(const int* number) const { return {std::to_string(*number)}; }
    std::vector<std::string> operator()(const bool* flag) const {
      return *flag ? std::vector<std::string>{"true"} : std::vector<std::string>{};
    }
    std::vector<std::string> operator()(const std::vector<std::string>* texts) const { return *texts; }
  };
  return std::visit(Visitor(), row.value);
}

}  // namespace crest
