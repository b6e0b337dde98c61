#include "app/output_folder.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;
namespace {

/// The innermost first; one with files in it stays, and those above it.
void remove_empty(std::vector<fs::path> folders) {
  std::error_code ignored;
  for (; !folders.empty(); folders.pop_back()) fs::remove(folders.back(), ignored);
}

}  // namespace

std::vector<fs::path> make_folder(const fs::path& path) {
  std::error_code fault;
  std::vector<fs::path> missing, made;
  fs::path folder = fs::absolute(path).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // it ended with a slash
  for (; !fs::exists(folder, fault); folder = folder.parent_path()) missing.push_back(folder);
  const auto fail = [&](const std::string& what) {
    remove_empty(made);
    throw Error(fmt::format("{}: cannot be made a folder: {}", path.string(), what));
  };
  if (!fs::is_directory(folder, fault)) fail(fault ? fault.message() : folder.string() + " is a file");
  for (; !missing.empty(); missing.pop_back()) {
    folder = missing.back();
    if (!fs::create_directory(folder, fault)) fail(fault.message());
    made.push_back(folder);
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{}: cannot be written into: {}", path.string(), std::strerror(errno)));
  return made;
}

OutputFolder::~OutputFolder() { remove_empty(made_); }

}  // namespace crest
