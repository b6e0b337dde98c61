#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace crest {

/// Where the manual may lie: beside the program where it is installed (share/doc/crest/docs), and in the
/// sources that it was built from.
std::vector<std::filesystem::path> docs_folders();
/// Of the sources.
std::filesystem::path docs_of_sources();

/// The file of a page, in the first of the folders that has it; else that of the manual's beginning, which an
/// empty name stands for. A folder has manual/PAGE.md. Empty where there is no manual.
std::filesystem::path manual_page(const std::string& page, std::span<const std::filesystem::path> folders);

/// Opens a file with what the desktop opens it with; does not wait. Returns whether that could be asked for.
bool open_on_desktop(const std::filesystem::path& file);

/// Opens a page of the manual. Returns what to tell: where it is, also if it does not open.
struct ManualOpened {
  std::string message;
  bool is_error = false;
};
ManualOpened open_manual(const std::string& page);

}  // namespace crest
