#include "render/files/folder_cache.h"

#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "presets/atomic_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

std::uint64_t hash_of(std::string_view text) { return XXH64(text.data(), text.size(), 0); }

/// Takes away the files that were used longest ago, until `room` bytes are free below the limit.
void make_room(const fs::path& folder, const fs::path& extension, std::uintmax_t limit_bytes,
               std::uintmax_t room) {
  struct File {
    fs::file_time_type used;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t total = room;
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != extension || !entry.is_regular_file(fault)) continue;
    files.push_back({entry.last_write_time(fault), entry.file_size(fault), entry.path()});
    if (fault)
      files.pop_back();  // another program took it away
    else
      total += files.back().bytes;
  }
  std::ranges::sort(files, {}, &File::used);
  for (const File& file : files) {
    if (total <= limit_bytes) return;
    fs::remove(file.path, fault);
    total -= file.bytes;
  }
}

}  // namespace

// The content is followed by its hash.
std::optional<std::string> read_cached(const fs::path& file, std::uintmax_t most_bytes) {
  std::error_code fault;
  const std::uintmax_t bytes = fs::is_regular_file(file, fault) ? fs::file_size(file, fault) : 0;
  std::uint64_t hash = 0;
  if (fault || bytes < sizeof hash || bytes - sizeof hash > most_bytes) return std::nullopt;
  try {
    std::string content = read_file(file, bytes);
    std::memcpy(&hash, content.data() + content.size() - sizeof hash, sizeof hash);
    content.resize(content.size() - sizeof hash);
    if (hash != hash_of(content)) return std::nullopt;
    fs::last_write_time(file, fs::file_time_type::clock::now(), fault);  // it was used
    return content;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void write_cached(const fs::path& file, std::string content, std::uintmax_t limit_bytes) {
  const std::uint64_t hash = hash_of(content);
  content.append(reinterpret_cast<const char*>(&hash), sizeof hash);
  if (content.size() > limit_bytes) return;
  try {
    if (fs::exists(file) && !fs::is_regular_file(file)) return;  // a pipe would be written into
    fs::create_directories(file.parent_path());
    make_room(file.parent_path(), file.extension(), limit_bytes, content.size());
    write_file_atomically(file, content);
  } catch (const std::exception&) {
    // It is made again next time.
  }
}

}  // namespace crest
