#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/option_table.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace crest {

/// A command line that is wrong: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// `option` is what is wrong: "--size", "VOLUME".
  UsageError(const std::string& option, const std::string& text) : std::runtime_error(option + ": " + text) {}
};

/// One option of a command, to be described further.
class Option {
 public:
  Option(CLI::Option* option, OptionRow* row) : option_(option), row_(row) {}

  Option& required();
  Option& type_name(const std::string& name);  ///< what the help calls its value
  Option& shows_default();                     ///< in the help
  Option& in(int least, int greatest);
  Option& one_of(const std::vector<std::string>& words);
  /// Values that completions offer; it may have others.
  Option& offers(const std::vector<std::string>& words);
  Option& existing_folder();
  Option& not_empty();
  /// `why_not` tells what is wrong with a value; nothing where it is right.
  Option& check(const std::function<std::string(const std::string& value)>& why_not);
  Option& or_environment(const std::string& variable);
  Option& excludes(const Option& other);
  Option& one_value_each();  ///< where it may be given more than once; what follows is another argument

 private:
  CLI::Option* option_;
  OptionRow* row_;
};

/// The options of the program or of one of its commands: rows of the table, and beside it a thin layer over
/// CLI11, whose header alone takes 9 s to compile.
class Options {
 public:
  Options(CLI::App* app, OptionTable* table, CommandRow* command)
      : app_(app), table_(table), command_(command) {}

  /// Without a group the program's help does not list it.
  Options add_command(const std::string& name, const std::string& help, const std::string& group = "");
  void add_example(const std::string& line);  ///< to the command's help
  // The values must live until the command line was read. Names are as "-o,--output", or "VOLUME" for what
  // has no dashes.
  Option add(const std::string& names, std::string& value, const std::string& help);
  Option add(const std::string& names, int& value, const std::string& help);
  Option add(const std::string& names, std::vector<std::string>& values, const std::string& help);
  void add_flag(const std::string& names, bool& value, const std::string& help);
  /// Called once all options of this command were read; it may throw UsageError.
  void when_read(const std::function<void()>& callback);

  bool is_given(const std::string& name) const;  ///< on the command line, or in the config file
  bool is_typed(const std::string& name) const;  ///< on the command line
  /// Options that have no part in what is asked for get no value from the config file.
  void leave_out(const std::vector<std::string>& names) const;
  /// One option excludes the others: what is typed wins over what the config file sets.
  void prefer_typed(const std::string& one, const std::vector<std::string>& others) const;
  bool has_command() const;  ///< whether one of its commands is chosen
  /// The command with its options, as a shell would be given them; with those of the config file.
  std::string text() const;
  const OptionTable& table() const { return *table_; }

 private:
  OptionRow& row(const std::string& name) const;
  CLI::App* app_;
  OptionTable* table_;
  CommandRow* command_;
};

/// The whole command line: the program's own options, and those of its commands.
class CommandLine {
 public:
  struct Texts {
    std::string description, usage, version;  ///< of the help; of --version
  };
  explicit CommandLine(const Texts& texts);
  ~CommandLine();

  Options options();
  /// Calls what is to be called (Options::when_read). Where only the help or the version was asked for,
  /// prints it and returns false. Throws UsageError.
  bool read(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  OptionTable table_;
  std::string version_;
};

/// A word as a shell would be given it.
std::string shell_word(const std::string& word);

}  // namespace crest
