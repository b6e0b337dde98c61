#include "app/manual.h"

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace crest {

namespace fs = std::filesystem;

std::vector<fs::path> docs_folders() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  std::vector<fs::path> folders;
  if (!unknown) folders.push_back(program.parent_path().parent_path() / "share" / "doc" / "crest" / "docs");
  folders.push_back(docs_of_sources());
  return folders;
}

fs::path manual_page(const std::string& page, std::span<const fs::path> folders) {
  const auto found = [&](const fs::path& name) -> fs::path {
    std::error_code unreadable;
    for (const fs::path& folder : folders)
      if (fs::is_regular_file(folder / name, unreadable)) return folder / name;
    return {};
  };
  if (!page.empty())
    if (const fs::path file = found(fs::path("manual") / (page + ".md")); !file.empty()) return file;
  return found(fs::path("manual") / "index.md");
}

bool open_on_desktop(const fs::path& file) {
  // The shell ends at once, and what it started is nobody's to wait for
  const std::string path = file.string();
  const char* const arguments[] = {
      "sh", "-c", "command -v xdg-open >/dev/null || exit 1; xdg-open \"$0\" >/dev/null 2>&1 &", path.c_str(),
      nullptr};
  pid_t shell = 0;
  if (posix_spawnp(&shell, "sh", nullptr, nullptr, const_cast<char* const*>(arguments), environ) != 0)
    return false;
  int status = 1;
  return waitpid(shell, &status, 0) == shell && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

ManualOpened open_manual(const std::string& page) {
  const fs::path file = manual_page(page, docs_folders());
  if (file.empty()) return {"The manual is not there: it comes with Crest's sources, as docs/manual", true};
  if (!open_on_desktop(file))
    return {fmt::format("No program to open it with was found; the manual is {}", file.string()), true};
  return {fmt::format("The manual is {}", file.string())};
}

}  // namespace crest
