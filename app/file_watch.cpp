#include "app/file_watch.h"

#include <algorithm>
#include <utility>

namespace crest {
namespace fs = std::filesystem;

std::vector<FileWatch::Look> FileWatch::look_at(const std::vector<fs::path>& files) {
  std::vector<Look> looks;
  for (const fs::path& file : files) {
    std::error_code error, no_size;
    Look& look = looks.emplace_back();
    look.time = fs::last_write_time(file, error);
    look.is_there = !error;
    if (fs::is_regular_file(file, no_size)) look.size = fs::file_size(file, no_size);
  }
  return looks;
}

bool FileWatch::has_changed(const std::vector<fs::path>& files) {
  std::vector<Look> now = look_at(files);
  if (files != files_) {
    files_ = files;
    told_ = last_ = std::move(now);
    return false;
  }
  const bool rests = now == last_ && std::ranges::all_of(now, &Look::is_there);
  last_ = std::move(now);
  if (!rests || last_ == told_) return false;
  told_ = last_;
  return true;
}

}  // namespace crest
