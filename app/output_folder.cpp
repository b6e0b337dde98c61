#include "app/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
  try {
    make();
  } catch (...) {
    remove_empty();
    throw;
  }
}

OutputFolder::~OutputFolder() { remove_empty(); }

void OutputFolder::make() {
  std::error_code fault;
  std::vector<fs::path> missing;
  fs::path folder = fs::absolute(path_).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // it ended with a slash
  for (; !fs::exists(folder, fault); folder = folder.parent_path()) missing.push_back(folder);
  const auto fail = [&](const std::string& what) {
    throw Error(fmt::format("{}: cannot be made a folder: {}", path_.string(), what));
  };
  if (!fs::is_directory(folder, fault)) fail(fault ? fault.message() : folder.string() + " is a file");
  for (; !missing.empty(); missing.pop_back()) {
    folder = missing.back();
    if (!fs::create_directory(folder, fault)) fail(fault.message());
    made_.push_back(folder);
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{}: cannot be written into: {}", path_.string(), std::strerror(errno)));
}

void OutputFolder::remove_empty() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), ignored);  // one with files in it stays
}

}  // namespace crest
