#include "app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <regex>

#include "app/config_file.h"
#include "app/option_help.h"
#include "app/unknown_word.h"
#include "render/volume/query.h"

namespace crest {
namespace {

std::vector<std::string> names_in(const std::string& names) { return CLI::detail::split(names, ','); }

/// The row of a command's table, and how CLI11 is told of it.
Option add_row(CLI::Option* option, CommandRow& command, const std::string& names, const std::string& help,
               decltype(OptionRow::value) value, const std::string& value_name) {
  OptionRow& row = command.options.emplace_back();
  row.names = names_in(names);
  row.help = help;
  row.value = value;
  row.value_name = row.is_argument() ? names : value_name;
  return {option, &row};
}

/// What every command has.
void add_help_and_config(CLI::App& app, CommandRow& command) {
  bool* const none = nullptr;
  add_row(app.add_flag("--no-config"), command, "--no-config", "Pass over the config file", none, "");
  add_row(app.get_help_ptr(), command, "-h,--help", "Print this", none, "");
}

/// The options before a command are the program's own; the command would pass them over. --no-config is for
/// all.
void require_none_before_command(const CLI::App& app) {
  if (app.get_subcommands().empty()) return;
  const std::string command = app.get_subcommands().front()->get_name();
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->check_name("--no-config"))
      throw UsageError(option->get_name(),
                       fmt::format("is given before the command; what is for {0} comes after {0}", command));
}

const CommandRow& chosen_command(const CLI::App& app, const OptionTable& table) {
  const auto chosen = app.get_subcommands();
  const std::string name = chosen.empty() ? "" : chosen.front()->get_name();
  return *std::ranges::find(table.commands, name, &CommandRow::name);
}

/// Whether a run only tells of itself, or is to pass over the config file.
bool needs_no_config(int argc, char** argv) {
  static const std::vector<std::string> words = {"--no-config", "--help", "-h", "--version"};
  return std::any_of(argv + 1, argv + argc,
                     [](const char* word) { return std::ranges::find(words, word) != words.end(); });
}

[[noreturn]] void fail_on_extra_words(const CLI::App& app, const OptionTable& table) {
  std::string first;
  const CLI::Option* argument = app.get_option("VOLUME");
  if (app.get_subcommands().empty() && argument->count() > 0) first = argument->results().front();
  throw UsageError(about_extra_word(table, chosen_command(app, table), app.remaining(true).front(), first));
}

}  // namespace

Option& Option::check(const std::function<std::string(const std::string& value)>& why_not) {
  row_->checks.push_back(why_not);
  return option_->check(why_not), *this;
}
Option& Option::required() {
  row_->is_required = true;
  return option_->required(), *this;
}
Option& Option::type_name(const std::string& name) {
  if (!row_->is_argument()) row_->value_name = name;
  return *this;
}
Option& Option::shows_default() {
  if (const auto* text = std::get_if<std::string*>(&row_->value)) row_->default_text = **text;
  if (const auto* number = std::get_if<int*>(&row_->value)) row_->default_text = std::to_string(**number);
  return *this;
}
Option& Option::in(int least, int greatest) {
  return check([least, greatest](const std::string& text) -> std::string {
    const auto number = to_integer(text);  // a leading 0 would make it octal to the parser
    if (!number || (text.size() > 1 && text.front() == '0'))
      return fmt::format("'{}' is not a whole number, as in {}", text, std::max(least, 10));
    return *number >= least && number <= greatest
               ? ""
               : fmt::format("{} is not in [{}, {}]", text, least, greatest);
  });
}
Option& Option::one_of(const std::vector<std::string>& words) {
  offers(words);
  row_->has_other_values = false;
  return check([words](const std::string& word) { return why_not_one_of(word, words); });
}
Option& Option::offers(const std::vector<std::string>& words) {
  row_->words = words;
  return *this;
}
Option& Option::existing_folder() {
  if (!row_->is_argument()) row_->value_name = "DIR";
  return check([](const std::string& path) -> std::string {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored) ? "" : fmt::format("{} is no folder", path);
  });
}
Option& Option::not_empty() {
  return check([](const std::string& text) { return text.empty() ? "it is empty" : ""; });
}
Option& Option::or_environment(const std::string& variable) {
  row_->help += fmt::format("; without it ${}", variable);
  return option_->envname(variable), *this;
}
Option& Option::excludes(const Option& other) { return option_->excludes(other.option_), *this; }
Option& Option::one_value_each() { return option_->allow_extra_args(false), *this; }

Options Options::add_command(const std::string& name, const std::string& help, const std::string& group) {
  CLI::App* app = app_->add_subcommand(name);
  CommandRow& command = table_->commands.emplace_back();
  command.name = name;
  command.help = help;
  command.group = group;
  add_help_and_config(*app, command);
  return {app, table_, &command};
}

void Options::add_example(const std::string& line) { command_->examples.push_back(line); }

// An empty value is a variable of a script that has none, and would be taken for an option that is not there.
Option Options::add(const std::string& names, std::string& value, const std::string& help) {
  return add_row(app_->add_option(names, value), *command_, names, help, &value, "TEXT").not_empty();
}

Option Options::add(const std::string& names, int& value, const std::string& help) {
  return add_row(app_->add_option(names, value), *command_, names, help, &value, "N");
}

Option Options::add(const std::string& names, std::vector<std::string>& values, const std::string& help) {
  Option option = add_row(app_->add_option(names, values), *command_, names, help, &values, "TEXT");
  command_->options.back().may_repeat = true;
  return option.not_empty();
}

void Options::add_flag(const std::string& names, bool& value, const std::string& help) {
  add_row(app_->add_flag(names, value), *command_, names, help, &value, "");
}

void Options::when_read(const std::function<void()>& callback) { app_->callback(callback); }

OptionRow& Options::row(const std::string& name) const {
  const auto found = std::ranges::find(command_->options, name, &OptionRow::long_name);
  if (found == command_->options.end()) throw std::logic_error(name + " is no option of this command");
  return *found;
}
bool Options::is_given(const std::string& name) const { return is_typed(name) || row(name).is_set; }
bool Options::is_typed(const std::string& name) const { return app_->count(name) > 0; }

void Options::leave_out(const std::vector<std::string>& names) const {
  for (const std::string& name : names)
    if (OptionRow& left_out = row(name); !is_typed(name) && left_out.is_set) {
      left_out.unset();
      left_out.is_set = false;
    }
}

void Options::prefer_typed(const std::string& one, const std::vector<std::string>& others) const {
  const auto asks_for = [&](const std::string& name) {  // --auto=false does not
    const auto* const flag = std::get_if<bool*>(&row(name).value);
    return is_typed(name) && (!flag || **flag);
  };
  if (std::ranges::any_of(others, asks_for)) leave_out({one});
  if (asks_for(one)) leave_out(others);
}

bool Options::has_command() const { return !app_->get_subcommands().empty(); }

std::string Options::text() const {
  std::string text = "crest " + app_->get_name();
  for (const OptionRow& row : command_->options) {
    const CLI::Option* option = app_->get_option(row.long_name());
    const auto values = option->count() == 0 && row.is_set ? values_of(row) : option->results();
    for (const std::string& value : values) {
      if (!row.is_argument()) text += fmt::format(" {}", row.long_name());
      if (!row.is_flag()) text += fmt::format(" {}", shell_word(value));
    }
  }
  return text;
}

CommandLine::CommandLine(const Texts& texts)
    : app_(std::make_unique<CLI::App>()),
      table_{texts.description, texts.usage, std::deque<CommandRow>(1)},
      version_(texts.version) {
  app_->require_subcommand(0, 1);
  CommandRow& program = table_.commands.front();
  add_help_and_config(*app_, program);
  bool* const none = nullptr;
  add_row(app_->set_version_flag("--version", version_), program, "--version", "Print the version", none, "");
}
CommandLine::~CommandLine() = default;

Options CommandLine::options() { return {app_.get(), &table_, &table_.commands.front()}; }

bool CommandLine::read(int argc, char** argv) {
  if (!needs_no_config(argc, argv)) read_config_file(table_);
  try {
    app_->parse(argc, argv);
    require_none_before_command(*app_);
    return true;
  } catch (const CLI::CallForHelp&) {
    const CommandRow& command = chosen_command(*app_, table_);
    fmt::print("{}", command.name.empty() ? program_help(table_) : command_help(command));
    return false;
  } catch (const CLI::CallForVersion&) {
    fmt::print("{}\n", version_);
    return false;
  } catch (const CLI::ExtrasError&) {
    fail_on_extra_words(*app_, table_);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string text = error.what(), name = text.substr(0, text.find(':'));
    if (text.find("At Most 1") != text.npos) throw UsageError(name, "is given more than once");
    throw UsageError(text);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

std::string shell_word(const std::string& word) {
  static const std::regex plain(R"([\w./:,=+-]+)");
  if (std::regex_match(word, plain)) return word;
  return fmt::format("'{}'", std::regex_replace(word, std::regex("'"), R"('\'')"));
}

}  // namespace crest
