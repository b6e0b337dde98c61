#include "app/command_line.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "app/commands.h"
#include "presets/error.h"

namespace crest {
namespace {

/// One line on stderr, whatever the text was.
void report(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (auto& c : text)
    if (c == '\n') c = ' ';
  fmt::print(stderr, "crest: {}\n", text);
}

void describe(CLI::App& app) {
  app.description("Crest, a transfer-function design studio for volume rendering");
  app.set_version_flag("--version", "crest " CREST_VERSION);
  app.footer(
      "VOLUME is a file (NRRD, MetaImage, NIfTI, MRC, VTK, RAW), a folder (a DICOM series or an image "
      "stack), or\n"
      "builtin:NAME?key=value&... (crest list volumes).\n"
      "Examples:\n"
      "  crest head.nrrd --preset dirac-shell\n"
      "  crest render builtin:plume?n=128 --preset dirac-shell -o plume.png --json\n"
      "  crest compare 'head.raw?size=64x64x93&type=int16' --preset my.json --set rendering.step=0.25 -o "
      "modes.png\n"
      "Exit codes: 0 done; 1 the work failed; 2 the command line is wrong.");
  app.require_subcommand(0, 1);
  app.get_formatter()->column_width(34);
}

/// The options before a command are the studio's; a command would pass them over.
void require_no_studio_options(const CLI::App& app) {
  if (app.get_subcommands().empty()) return;
  const std::string command = app.get_subcommands().front()->get_name();
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0)
      throw CLI::ValidationError(
          option->get_name(),
          fmt::format("is given before the command; what is for {0} comes after {0}", command));
}

/// What was printed is out, or it is an error (a full disk).
void flush_output() {
  if (std::fflush(stdout) != 0)
    throw Error(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

}  // namespace

int run_command_line(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of its writer
  CLI::App app;
  Action chosen;
  describe(app);
  add_studio(app, chosen);
  add_render_command(app, chosen);
  add_compare_command(app, chosen);
  add_stability_command(app, chosen);
  add_peaks_command(app, chosen);
  add_info_command(app, chosen);
  add_export_command(app, chosen);
  add_list_command(app, chosen);
  try {
    app.parse(argc, argv);
    require_no_studio_options(app);
    chosen();
    flush_output();
    return 0;
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help and --version
  } catch (const CLI::ParseError& error) {
    report(fmt::format("{} (see crest --help)", error.what()));
    return 2;
  } catch (const std::bad_alloc&) {
    report("out of memory");
  } catch (const std::exception& error) {
    report(error.what());
  }
  return 1;
}

}  // namespace crest
