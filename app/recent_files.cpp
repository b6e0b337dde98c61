#include "app/recent_files.h"

#include <algorithm>
#include <filesystem>

#include "app/sources.h"
#include "app/user_folders.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"

namespace crest {
namespace {

constexpr std::size_t most_recent = 12;

std::filesystem::path recent_file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "recent.json";
}

}  // namespace

RecentFiles::RecentFiles() {
  try {
    const auto json = nlohmann::json::parse(read_file(recent_file(), 1 << 20));
    for (const auto& entry : json)
      if (entry.is_string() && list_.size() < most_recent) list_.push_back(entry);
  } catch (const std::exception&) {
    list_.clear();  // no list yet, or not one of ours
  }
}

void RecentFiles::add(const std::string& opened) {
  const std::string source = absolute_source(opened);
  if (!list_.empty() && list_.front() == source) return;
  std::erase(list_, source);
  list_.insert(list_.begin(), source);
  if (list_.size() > most_recent) list_.resize(most_recent);
  const auto path = recent_file();
  if (path.empty()) return;
  writer_.start([path, list = list_] {  // a convenience only: nobody is told of a failure
    std::filesystem::create_directories(path.parent_path());
    write_file_atomically(path, nlohmann::json(list).dump(1) + "\n");
  });
}

}  // namespace crest
