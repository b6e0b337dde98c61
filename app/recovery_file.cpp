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
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::seconds;

constexpr std::string_view format = "crest-recovery";
constexpr int version = 1;
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
  const Document& document = kept.document;
  const auto time = std::chrono::duration_cast<Seconds>(kept.time.time_since_epoch()).count();
  Json json = {{"format", format},
               {"version", version},
               {"time", time},
               {"volume", absolute_source(document.volume_source)},
               {"preset_path", absolute_source(document.preset_path.string())},
               {"library_name", document.library_name}};
  json["preset"] = parse_json(write_preset(document.preset));
  // A name that is no UTF-8 must not cost the edit
  const auto replace = Json::error_handler_t::replace;
  write_file_atomically(path_, json.dump(1, ' ', false, replace) + "\n");
}

KeptDocument RecoveryFile::read() const {
  try {
    const auto json = parse_json(read_file(path_, largest));
    if (json.at("format") != format || json.at("version") != version)
      throw Error("it is of another version of Crest");
    KeptDocument kept;
    kept.time = std::chrono::system_clock::time_point(Seconds(json.at("time").get<std::int64_t>()));
    kept.document.volume_source = json.at("volume").get<std::string>();
    kept.document.preset_path = json.at("preset_path").get<std::string>();
    kept.document.library_name = json.at("library_name").get<std::string>();
    kept.document.preset = parse_preset(json.at("preset").dump(), path_.string());
    return kept;
  } catch (const Json::exception& error) {
    throw Error(fmt::format("{}: {}", path_.string(), error.what()));
  }
}

void RecoveryFile::remove() const {
  std::error_code ignored;
  fs::remove(path_, ignored);
  fs::remove(lock_of(path_), ignored);
}

}  // namespace crest
