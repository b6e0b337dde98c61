#include "app/options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <regex>

namespace crest {
namespace {

/// The options before a command are the program's own; the command would pass them over.
void require_none_before_command(const CLI::App& app) {
  if (app.get_subcommands().empty()) return;
  const std::string command = app.get_subcommands().front()->get_name();
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0)
      throw UsageError(option->get_name(),
                       fmt::format("is given before the command; what is for {0} comes after {0}", command));
}

}  // namespace

Option& Option::required() { return option_->required(), *this; }
Option& Option::type_name(const std::string& name) { return option_->type_name(name), *this; }
Option& Option::shows_default() { return option_->capture_default_str(), *this; }
Option& Option::in(int least, int greatest) { return option_->check(CLI::Range(least, greatest)), *this; }
Option& Option::one_of(const std::vector<std::string>& words) {
  return option_->check(CLI::IsMember(words)), *this;
}
Option& Option::existing_folder() { return option_->check(CLI::ExistingDirectory), *this; }
Option& Option::not_empty() {
  return check([](const std::string& text) { return text.empty() ? "it is empty" : ""; });
}
Option& Option::check(const std::function<std::string(const std::string& value)>& why_not) {
  return option_->check(why_not), *this;
}
Option& Option::or_environment(const std::string& variable) { return option_->envname(variable), *this; }
Option& Option::excludes(const Option& other) { return option_->excludes(other.option_), *this; }
Option& Option::one_value_each() { return option_->allow_extra_args(false), *this; }

Options Options::add_command(const std::string& name, const std::string& help) {
  return Options(app_->add_subcommand(name, help));
}

// An empty value is a variable of a script that has none, and would be taken for an option that is not there.
Option Options::add(const std::string& names, std::string& value, const std::string& help) {
  Option option(app_->add_option(names, value, help));
  return names.starts_with('-') ? option.not_empty() : option;
}

Option Options::add(const std::string& names, int& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::add(const std::string& names, std::vector<std::string>& values, const std::string& help) {
  return Option(app_->add_option(names, values, help)).not_empty();
}

void Options::add_flag(const std::string& names, bool& value, const std::string& help) {
  app_->add_flag(names, value, help);
}

void Options::when_read(const std::function<void()>& callback) { app_->callback(callback); }

bool Options::is_given(const std::string& name) const { return app_->count(name) > 0; }
bool Options::has_command() const { return !app_->get_subcommands().empty(); }

std::string Options::text() const {
  std::string text = "crest " + app_->get_name();
  for (const CLI::Option* option : app_->get_options()) {
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) text += fmt::format(" {}", option->get_name());
      if (option->get_items_expected_max() > 0) text += fmt::format(" {}", shell_word(value));
    }
  }
  return text;
}

CommandLine::CommandLine(const Texts& texts) : app_(std::make_unique<CLI::App>(texts.description)) {
  app_->set_version_flag("--version", texts.version);
  app_->footer(texts.footer);
  app_->require_subcommand(0, 1);
  app_->get_formatter()->column_width(34);
}
CommandLine::~CommandLine() = default;

Options CommandLine::options() { return Options(app_.get()); }

bool CommandLine::read(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    require_none_before_command(*app_);
    return true;
  } catch (const CLI::Success& success) {
    app_->exit(success);  // --help and --version
    return false;
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
