#include "app/recovery_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/error.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest = std::size_t(40) << 20;  // bytes: more than a preset may have, indented

fs::path lock_of(fs::path file) { return file.replace_extension(".lock"); }

bool can_be_read(const RecoveryFile& file) {
  try {
    file.read();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// Names sort by the time at which they were made.
fs::path new_name(const fs::path& folder, int attempt) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
  return folder / fmt::format("{:014}-{}-{}.json", ms, ::getpid(), attempt);
}

}  // namespace

std::optional<FileLock> FileLock::take(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (fd < 0) return std::nullopt;
  FileLock lock(fd);
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return lock;
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileLock::~FileLock() {
  if (fd_ >= 0) ::close(fd_);
}

RecoveryFile::RecoveryFile(fs::path path, FileLock lock) : path_(std::move(path)), lock_(std::move(lock)) {}

RecoveryFile::RecoveryFile(const fs::path& folder)
    : RecoveryFile([&] {
        std::error_code error;
        fs::create_directories(folder, error);
        for (int attempt = 0; attempt < 100; ++attempt) {
          fs::path name = new_name(folder, attempt);
          if (auto lock = FileLock::take(lock_of(name)))
            return RecoveryFile(std::move(name), std::move(*lock));
        }
        throw Error(fmt::format("cannot keep unsaved changes in {}: no file can be made and locked there",
                                folder.string()));
      }()) {}

std::vector<RecoveryFile> RecoveryFile::left_behind(const fs::path& folder) {
  std::vector<fs::path> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (std::error_code ignored; entry->path().extension() == ".json" && entry->is_regular_file(ignored))
      names.push_back(entry->path());
  std::sort(names.rbegin(), names.rend());

  std::vector<RecoveryFile> found;
  std::size_t readable = 0;
  for (fs::path& name : names) {
    auto lock = FileLock::take(lock_of(name));
    if (!lock) continue;  // of a program that runs
    RecoveryFile file(std::move(name), std::move(*lock));
    const bool is_readable = can_be_read(file);
    // Whoever held it may have removed it just now
    if (!fs::exists(file.path_, error) || (is_readable && readable == most_recoveries)) {
      file.remove();
      continue;
    }
    readable += is_readable;
    found.push_back(std::move(file));
  }
  return found;
}

void RecoveryFile::write(const KeptDocument& kept) const {
  KeptDocument absolute = kept;  // the next program may begin elsewhere
  absolute.document.volume_source = absolute_source(kept.document.volume_source);
  absolute.document.preset_path = absolute_source(kept.document.preset_path.string());
  write_file_atomically(path_, recovery_text(absolute));
}

KeptDocument RecoveryFile::read() const { return parse_recovery(read_file(path_, largest), path_.string()); }

void RecoveryFile::remove() const {
  std::error_code ignored;
  fs::remove(path_, ignored);
  fs::remove(lock_of(path_), ignored);
}

}  // namespace crest
