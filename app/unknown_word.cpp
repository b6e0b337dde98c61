#include "app/unknown_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "presets/nearest_word.h"

namespace crest {
namespace {

/// The long names of a command's options.
std::vector<std::string_view> option_names(const CommandRow& command) {
  std::vector<std::string_view> names;
  for (const OptionRow& row : command.options)
    if (!row.is_argument()) names.push_back(row.long_name());
  return names;
}

/// The commands that have this option.
std::vector<std::string_view> commands_with(const OptionTable& table, const std::string& option) {
  std::vector<std::string_view> commands;
  for (const CommandRow& command : table.commands)
    if (!command.name.empty() && !command.group.empty() &&
        std::ranges::count(option_names(command), option) > 0)
      commands.push_back(command.name);
  return commands;
}

}  // namespace

std::string meant_command(const OptionTable& table, const std::string& word) {
  std::vector<std::string_view> names;
  for (const CommandRow& command : table.commands)
    if (!command.group.empty()) names.push_back(command.name);
  return did_you_mean(word, names);
}

std::string about_extra_word(const OptionTable& table, const CommandRow& command, const std::string& word,
                             const std::string& argument) {
  std::error_code ignored;
  if (!argument.empty() && !std::filesystem::exists(argument, ignored))
    if (const std::string meant = meant_command(table, argument); !meant.empty())
      return fmt::format("{}: there is no such command{}", argument, meant);
  if (!word.starts_with('-')) return fmt::format("{}: one word too many", word);
  const std::string name = word.substr(0, word.find('='));
  const std::string meant = did_you_mean(name, option_names(command));
  const auto others = commands_with(table, name);
  if (meant.empty() && !others.empty())
    return fmt::format("{}: an option of {}, which {} has not", name, fmt::join(others, ", "),
                       command.name.empty() ? "the window" : command.name);
  return fmt::format("{}: there is no such option{}", name, meant);
}

std::string why_not_one_of(const std::string& word, const std::vector<std::string>& words) {
  if (std::ranges::find(words, word) != words.end()) return {};
  const std::vector<std::string_view> known(words.begin(), words.end());
  return fmt::format("'{}' is not one of {}{}", word, fmt::join(words, ", "), did_you_mean(word, known));
}

}  // namespace crest
