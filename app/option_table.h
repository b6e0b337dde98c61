#pragma once

#include <deque>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace crest {

/// One option, flag or argument of a command: all that the parser, the help, the manual, the man page,
/// completions and the config file know of it.
struct OptionRow {
  std::vector<std::string> names;  ///< "-o", "--output"; "VOLUME", without dashes, is an argument
  std::string help;
  std::string value_name;          ///< what its value is called; empty for a flag, which takes none
  std::string default_text;        ///< where the help tells it
  std::vector<std::string> words;  ///< values that it may have; completions offer them
  bool has_other_values = true;    ///< beside `words`
  bool is_required = false, may_repeat = false;
  bool is_set = false;               ///< by the config file
  std::function<void()> unset = {};  ///< to the value without the config file

  /// Where its value goes.
  std::variant<std::string*, int*, bool*, std::vector<std::string>*> value;
  /// Each tells what is wrong with a value; nothing where it is right.
  std::vector<std::function<std::string(const std::string& value)>> checks;

  bool is_argument() const { return !names.front().starts_with('-'); }
  bool is_flag() const { return value_name.empty(); }
  /// "--output", "VOLUME".
  const std::string& long_name() const { return names.back(); }
};

struct CommandRow {
  std::string name;   ///< empty for what the program takes without a command
  std::string help;   ///< a line
  std::string group;  ///< under which the program's help lists it; a command without one is not listed
  std::vector<std::string> examples;
  std::deque<OptionRow> options;  ///< whose places stay while it grows
};

/// The whole command line. The first row is the program's own, without a command.
struct OptionTable {
  std::string description, usage;  ///< of the program, for its help
  std::deque<CommandRow> commands;

  const CommandRow& program() const { return commands.front(); }
};

/// The name of a value that is a file; so that completions offer files.
bool names_file(const std::string& value_name);
bool names_folder(const std::string& value_name);

}  // namespace crest
