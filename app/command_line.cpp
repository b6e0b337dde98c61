#include "app/command_line.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/last_words.h"
#include "presets/error.h"
#include "presets/printable.h"

namespace crest {
namespace {

/// One line on stderr, whatever the text was, where there is a stderr.
void report(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  const std::string line = "crest: " + printable(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
  end_crashes_silently();
}

constexpr const char* description =
    "Crest: design transfer functions for volume rendering. Finds the peaks of a\n"
    "transfer function, draws them as surfaces, compares what renderers make of it.";

constexpr const char* usage =
    "Examples:\n"
    "  crest head.nrrd --preset dirac-shell\n"
    "  crest render builtin:plume?n=128 --preset dirac-shell -o plume.png\n"
    "  crest compare 'head.raw?size=64x64x93&type=int16' --preset my.json -o head.png\n"
    "VOLUME is a file (NRRD, MetaImage, NIfTI, MRC, VTK, VTK XML, NumPy, DICOM, TIFF,\n"
    "RAW), a folder (DICOM, image stack), or builtin:NAME?key=value&... (crest list\n"
    "volumes).\n"
    "Exit codes: 0 done; 1 the work failed; 2 the command line is wrong.\n\n";

/// A closed standard stream would be the next file that is opened, and be printed into. What goes to stdout
/// then is an error; what goes to stderr is lost.
void open_standard_streams() {
  for (const auto& [stream, mode] :
       {std::pair(STDIN_FILENO, O_WRONLY), {STDOUT_FILENO, O_RDONLY}, {STDERR_FILENO, O_WRONLY}}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", mode);  // the lowest number that is free
  }
}

/// What was printed is out, or it is an error (a full disk).
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

}  // namespace

namespace {

void read_and_run(int argc, char** argv, const std::string& version) {
  CommandLine line({description, usage, "crest " + version});
  const Options options = line.options();
  Command chosen;
  add_studio(options, chosen);
  add_render_command(options, chosen);
  add_compare_command(options, chosen);
  add_report_command(options, chosen);
  add_stability_command(options, chosen);
  add_peaks_command(options, chosen);
  add_info_command(options, chosen);
  add_export_command(options, chosen);
  add_import_command(options, chosen);
  add_match_command(options, chosen);
  add_list_command(options, chosen);
  if (line.read(argc, argv)) chosen();
  flush_output();
}

}  // namespace

int run_command_line(int argc, char** argv, const std::string& version) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of its writer
  open_standard_streams();
  end_crashes_with_a_line();
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);  // what cannot be drawn with is said in our words
  tell_driver_of_cache();
  try {
    read_and_run(argc, argv, version);
    return 0;
  } catch (const UsageError& error) {
    report(fmt::format("{} (see crest --help)", error.what()));
    return 2;
  } catch (const std::bad_alloc&) {
    report("out of memory");
  } catch (const std::filesystem::filesystem_error& error) {  // whose text names the function that failed
    report(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {  // fmt's, or of a thread
    report(fmt::format(
        "{}: {}",
        std::ferror(stdout) != 0 ? "cannot write to the standard output" : "the system gives no more threads",
        error.code().message()));
  } catch (const std::exception& error) {
    report(error.what());
  }
  return 1;
}

}  // namespace crest
