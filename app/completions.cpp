#include "app/completions.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace crest {
namespace {

/// Commands that are told of; the program without a command is `window`.
std::vector<const CommandRow*> commands_of(const OptionTable& table) {
  std::vector<const CommandRow*> commands;
  for (const CommandRow& command : table.commands)
    if (!command.group.empty()) commands.push_back(&command);
  return commands;
}

std::string in_quotes(const std::string& text) {
  return fmt::format("'{}'", std::regex_replace(text, std::regex("'"), R"('\'')"));
}

/// The first line of a help, up to its first end of a clause: completions have a line each.
std::string in_brief(const std::string& help) { return help.substr(0, help.find_first_of("\n;:")); }

// Bash: a function that knows the options of each command, and the words that each value may have.

std::string bash_values(const OptionRow& row) {
  std::string text;
  if (!row.words.empty())
    text += fmt::format("COMPREPLY+=($(compgen -W {} -- \"$cur\")); ",
                        in_quotes(fmt::format("{}", fmt::join(row.words, " "))));
  if (names_file(row.value_name)) text += "compopt -o filenames; COMPREPLY+=($(compgen -f -- \"$cur\")); ";
  if (names_folder(row.value_name)) text += "compopt -o filenames; COMPREPLY+=($(compgen -d -- \"$cur\")); ";
  return text;
}

std::string bash_command(const CommandRow& command) {
  std::string options, values, argument;
  for (const OptionRow& row : command.options) {
    if (row.is_argument()) {
      argument += bash_values(row);
      continue;
    }
    options += fmt::format("{} ", fmt::join(row.names, " "));
    if (!row.is_flag())
      values += fmt::format("        {}) {}return ;;\n", fmt::join(row.names, "|"), bash_values(row));
  }
  return fmt::format(
      "    {0}{1})\n      case $prev in\n{2}      esac\n      if [[ $cur == -* ]]; then COMPREPLY=($(compgen "
      "-W {3} -- \"$cur\")); "
      "return; fi\n      {4};;\n",
      command.name, command.name == "window" ? "|''" : "", values, in_quotes(options), argument);
}

std::string bash(const OptionTable& table) {
  std::string names, cases;
  for (const CommandRow* command : commands_of(table)) {
    names += command->name + " ";
    cases += bash_command(*command);
  }
  return fmt::format(R"(# Completions of crest for bash; written by: crest list completions --for bash
_crest_reply() {{
  local command= commands={0}
  if ((cword == 1)) && [[ $cur != -* ]]; then COMPREPLY=($(compgen -W "$commands" -- "$cur")); fi
  if ((cword > 1)) && [[ " $commands" == *" ${{words[1]}} "* ]]; then command=${{words[1]}}; fi
  case $command in
{1}  esac
}}
_crest() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} words=("${{COMP_WORDS[@]}}") cword=$COMP_CWORD
  COMPREPLY=()
  # A colon ends a word for bash, but not in builtin:NAME
  if declare -F _get_comp_words_by_ref >/dev/null; then _get_comp_words_by_ref -n : cur prev words cword; fi
  _crest_reply
  if declare -F __ltrim_colon_completions >/dev/null; then __ltrim_colon_completions "$cur"; fi
}}
complete -F _crest crest
)",
                     in_quotes(names), cases);
}

// Zsh: what _arguments takes, a list a command.

std::string zsh_text(const std::string& text) {
  return std::regex_replace(text, std::regex(R"([\[\]:\\])"), R"(\$&)");
}

// A blank before a function keeps _arguments from handing it options of its own.
std::string zsh_action(const OptionRow& row) {
  std::string words;
  for (const std::string& word : row.words) words += zsh_text(word) + " ";
  if (names_folder(row.value_name)) return "_files -/";
  if (!names_file(row.value_name)) return words.empty() ? " " : fmt::format("({})", words);
  return words.empty()
             ? "_files"
             : fmt::format(" _alternative \"words\\:name\\:({})\" \"files\\:file\\:_files\"", words);
}

std::string zsh_row(const OptionRow& row) {
  const std::string value =
      row.is_flag() ? "" : fmt::format(":{}:{}", zsh_text(row.value_name), zsh_action(row));
  if (row.is_argument())
    return fmt::format("      {}\n", in_quotes(fmt::format("{}{}", row.is_required ? "" : ":", value)));
  std::string text;
  for (const std::string& name : row.names)
    text += fmt::format("      {}\n", in_quotes(fmt::format("{}{}[{}]{}", row.may_repeat ? "*" : "", name,
                                                            zsh_text(in_brief(row.help)), value)));
  return text;
}

std::string zsh(const OptionTable& table) {
  std::string names, cases;
  for (const CommandRow* command : commands_of(table)) {
    names += fmt::format("    {}\n", in_quotes(command->name + ":" + zsh_text(in_brief(command->help))));
    cases += fmt::format("    {})\n      specs=(\n", command->name == "window" ? "window|*" : command->name);
    for (const OptionRow& row : command->options) cases += zsh_row(row);
    cases += "      ) ;;\n";
  }
  // The window's case takes every other word, and so comes last
  const std::string window = "    window|*)", end = "      ) ;;\n";
  const std::size_t begin = cases.find(window), length = cases.find(end, begin) + end.size() - begin;
  const std::string of_window = cases.substr(begin, length);
  cases.erase(begin, length);
  return fmt::format(R"(#compdef crest
# Completions of crest for zsh; written by: crest list completions --for zsh
_crest() {{
  local -a commands specs
  commands=(
{0}  )
  ((CURRENT == 2)) && [[ $words[2] != -* ]] && _describe command commands
  case $words[2] in
{1}{2}  esac
  [[ -n ${{commands[(r)$words[2]:*]}} ]] && {{ shift words; ((CURRENT--)); }}
  _arguments : "$specs[@]"
}}
if [ "$funcstack[1]" = _crest ]; then _crest "$@"; else compdef _crest crest; fi
)",
                     names, cases, of_window);
}

// Fish: a line an option.

std::string fish_row(const CommandRow& command, const OptionRow& row) {
  const std::string when =
      command.name == "window"
          ? "not __fish_seen_subcommand_from $__crest_commands; or __fish_seen_subcommand_from window"
          : "__fish_seen_subcommand_from " + command.name;
  std::string line = fmt::format("complete -c crest -n {}", in_quotes(when));
  if (!row.is_argument())
    for (const std::string& name : row.names)
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!row.words.empty())
    line += fmt::format(" -a {}", in_quotes(fmt::format("{}", fmt::join(row.words, " "))));
  if (!row.is_flag() && !row.is_argument()) line += " -r";
  if (names_file(row.value_name)) line += " -F";
  if (names_folder(row.value_name)) line += " -f -a '(__fish_complete_directories)'";
  if (!row.is_argument()) line += fmt::format(" -d {}", in_quotes(in_brief(row.help)));
  return line + "\n";
}

std::string fish(const OptionTable& table) {
  std::string names, lines;
  for (const CommandRow* command : commands_of(table)) {
    names += " " + command->name;
    lines += fmt::format("complete -c crest -n __fish_use_subcommand -a {} -d {}\n", command->name,
                         in_quotes(in_brief(command->help)));
    for (const OptionRow& row : command->options) lines += fish_row(*command, row);
  }
  return fmt::format(
      "# Completions of crest for fish; written by: crest list completions --for fish\nset -g "
      "__crest_commands{}\n{}",
      names, lines);
}

}  // namespace

std::string completions(const OptionTable& table, const std::string& shell) {
  return shell == "bash" ? bash(table) : shell == "zsh" ? zsh(table) : fish(table);
}

}  // namespace crest
