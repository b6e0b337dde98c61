#include "app/output_folder.h"

#include <fmt/format.h>

#include <utility>

#include "presets/error.h"

namespace crest {

bool make_folder(const std::filesystem::path& folder) {
  std::error_code fault;
  const bool is_new = std::filesystem::create_directories(folder, fault);
  if (fault || !std::filesystem::is_directory(folder))
    throw Error(fmt::format("{}: cannot be made a folder: {}", folder.string(),
                            fault ? fault.message() : "it is a file"));
  return is_new;
}

OutputFolder::OutputFolder(std::filesystem::path folder)
    : folder_(std::move(folder)), is_new_(make_folder(folder_)) {}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (is_new_) std::filesystem::remove(folder_, ignored);  // only an empty one goes
}

}  // namespace crest
