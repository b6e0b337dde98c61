#include "app/man_page.h"

#include <fmt/core.h>

#include "app/option_help.h"
#include "render/volume/query.h"

namespace crest {
namespace {

/// Text as roff takes it: no backslash, no minus for a hyphen, no line that begins as a request does.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool begins_line = result.empty() || result.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

/// Each line of a text as one of its own.
std::string lines(const std::string& text) {
  std::string result;
  for (const std::string_view line : split(text, '\n'))
    result += (result.empty() ? "" : "\n.br\n") + roff(std::string(line));
  return result;
}

std::string example_lines(const std::vector<std::string>& examples) {
  std::string text = ".PP\n.nf\n";
  for (const std::string& example : examples) text += roff(example) + "\n";
  return text + ".fi\n";
}

std::string command_section(const CommandRow& command) {
  std::string text = fmt::format(".SS {}\n{}.\n", roff(usage_line(command)), roff(command.help));
  for (const OptionRow* row : in_order(command))
    text += fmt::format(".TP\n.B {}\n{}\n", roff(option_text(*row)), lines(option_meaning(*row)));
  return command.examples.empty() ? text : text + example_lines(command.examples);
}

constexpr const char* tail = R"(.SH FILES
.TP
.I $XDG_CONFIG_HOME/crest/config.json
Defaults of the command line (~/.config/crest/config.json). The command line goes before the environment, that before this
file, and this before what is built in.
.TP
.I $XDG_CACHE_HOME/crest
Exact answers, compiled shaders and thumbnails (~/.cache/crest). It can be deleted at any time.
.TP
.I $XDG_DATA_HOME/crest/presets
Presets of your own (~/.local/share/crest/presets).
.SH EXIT STATUS
0 done; 1 the work failed; 2 the command line is wrong.
)";

}  // namespace

std::string man_page(const OptionTable& table) {
  std::string text =
      ".TH CREST 1\n.SH NAME\ncrest \\- design transfer functions for volume rendering\n.SH SYNOPSIS\n"
      ".B crest\n[\\fIVOLUME\\fR] [\\fIOPTIONS\\fR]\n.br\n.B crest\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n"
      ".SH DESCRIPTION\n" +
      roff(table.description) + "\n.PP\n.nf\n" + roff(table.usage) + ".fi\n.SH COMMANDS\n";
  for (const CommandRow& command : table.commands)
    if (!command.group.empty()) text += command_section(command);
  return text + tail;
}

}  // namespace crest
