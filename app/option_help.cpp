#include "app/option_help.h"

#include <fmt/format.h>

#include <algorithm>

#include "presets/json.h"
#include "presets/json_text.h"
#include "render/volume/query.h"

namespace crest {
namespace {

constexpr std::size_t width = 80, text_column = 26;

/// `text` wrapped; its first line goes on where `line` ends, the others are indented.
std::string wrapped(std::string line, const std::string& text, std::size_t indent) {
  std::string lines;
  const auto end_line = [&] {
    lines += line + "\n";
    line = std::string(indent, ' ');
  };
  for (const std::string_view paragraph : split(text, '\n')) {
    if (line.size() > indent) end_line();
    line.resize(std::max(line.size(), indent), ' ');
    for (const std::string_view word : split(paragraph, ' ')) {
      if (line.size() > indent && line.size() + 1 + word.size() > width) end_line();
      if (line.size() > indent) line += ' ';
      line += word;
    }
  }
  return lines + line + "\n";
}

std::string option_lines(const OptionRow& row) {
  const std::string names = "  " + option_text(row);
  if (names.size() + 2 > text_column) return names + "\n" + wrapped("", option_meaning(row), text_column);
  return wrapped(fmt::format("{:{}}", names, text_column), option_meaning(row), text_column);
}

/// The groups of commands, in their order.
std::vector<std::string> groups_of(const OptionTable& table) {
  std::vector<std::string> groups;
  for (const CommandRow& command : table.commands)
    if (!command.group.empty() && std::ranges::find(groups, command.group) == groups.end())
      groups.push_back(command.group);
  return groups;
}

std::string cell_text(std::string text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : c == '\n' ? "<br>" : std::string(1, c);
  return cell;
}

}  // namespace

bool names_file(const std::string& value_name) {
  return value_name.starts_with("FILE") || value_name == "PRESET" || value_name == "VOLUME" ||
         value_name == "PICTURE";
}
bool names_folder(const std::string& value_name) { return value_name == "DIR"; }

std::vector<const OptionRow*> in_order(const CommandRow& command) {
  std::vector<const OptionRow*> rows;
  for (const OptionRow& row : command.options) rows.push_back(&row);
  const auto rank = [](const OptionRow* row) {
    const std::string& name = row->long_name();
    return row->is_argument() ? 0 : name == "--help" || name == "--no-config" || name == "--version" ? 2 : 1;
  };
  std::ranges::stable_sort(rows, {}, rank);
  return rows;
}

std::string option_text(const OptionRow& row) {
  if (row.is_argument()) return row.long_name();
  return fmt::format("{}{}{}", fmt::join(row.names, ", "), row.is_flag() ? "" : " ", row.value_name);
}

std::string option_meaning(const OptionRow& row) {
  std::string text = row.help;
  if (!row.has_other_values) text += fmt::format(": {}", fmt::join(row.words, ", "));
  if (row.may_repeat) text += "; may be given again";
  if (!row.default_text.empty()) text += fmt::format(" [{}]", row.default_text);
  return text;
}

std::string usage_line(const CommandRow& command) {
  std::string line = command.name.empty() ? "crest" : "crest " + command.name;
  for (const OptionRow& row : command.options)
    if (row.is_argument())
      line += row.is_required ? " " + row.long_name() : fmt::format(" [{}]", row.long_name());
  for (const OptionRow& row : command.options)
    if (!row.is_argument() && row.is_required)
      line += fmt::format(" {} {}", row.names.front(), row.value_name);
  return line + " [OPTIONS]";
}

std::string program_help(const OptionTable& table) {
  std::string text = table.description + "\n\n" + table.usage;
  for (const std::string& group : groups_of(table)) {
    text += fmt::format("{}:\n", group);
    for (const CommandRow& command : table.commands)
      if (command.group == group) text += fmt::format("  {:<10} {}\n", command.name, command.help);
  }
  return text + "crest COMMAND --help tells a command's options; crest --version the version.\n";
}

std::string command_help(const CommandRow& command) {
  std::string text = fmt::format("{}\n{}.\n\n", usage_line(command), command.help);
  for (const OptionRow* row : in_order(command)) text += option_lines(*row);
  if (!command.examples.empty()) text += "\nExamples:\n";
  for (const std::string& example : command.examples) text += fmt::format("  {}\n", example);
  return text;
}

std::string manual_page(const OptionTable& table) {
  std::string text =
      "# The options of each command\n\n"
      "This page is what `crest list options` prints: the table that the program itself reads its command "
      "line "
      "by.\n";
  for (const CommandRow& command : table.commands) {
    if (command.group.empty()) continue;
    text += fmt::format("\n## crest {}\n\n{}.\n\n    {}\n\n| Option | Meaning |\n|---|---|\n", command.name,
                        command.help, usage_line(command));
    for (const OptionRow* row : in_order(command))
      text += fmt::format("| `{}` | {} |\n", cell_text(option_text(*row)), cell_text(option_meaning(*row)));
    if (!command.examples.empty()) text += "\nExamples:\n\n";
    for (const std::string& example : command.examples) text += fmt::format("    {}\n", example);
  }
  return text;
}

std::string options_json(const OptionTable& table) {
  Json commands = Json::array();
  for (const CommandRow& command : table.commands) {
    if (command.group.empty()) continue;
    Json options = Json::array();
    for (const OptionRow* row : in_order(command)) {
      Json option = {{"names", row->names}, {"help", row->help}};
      if (!row->is_flag() && !row->is_argument()) option["value"] = row->value_name;
      if (!row->words.empty()) option[row->has_other_values ? "offers" : "one_of"] = row->words;
      if (!row->default_text.empty()) option["default"] = row->default_text;
      if (row->is_required) option["required"] = true;
      if (row->may_repeat) option["may_repeat"] = true;
      options.push_back(std::move(option));
    }
    commands.push_back({{"name", command.name},
                        {"help", command.help},
                        {"group", command.group},
                        {"examples", command.examples},
                        {"options", std::move(options)}});
  }
  return pretty(commands) + "\n";
}

}  // namespace crest
