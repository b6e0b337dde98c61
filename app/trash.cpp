#include "app/trash.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

#include "presets/error.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw Error(fmt::format("cannot move {} to the bin: {}", file.string(), what));
}

/// As in a URL: all but letters, digits and some signs is written %XX.
std::string escaped(const std::string& path) {
  constexpr std::string_view plain = "-_.~/";
  std::string text;
  for (const char c : path) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    text += is_letter || plain.find(c) != plain.npos ? std::string(1, c)
                                                     : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

std::string info_of(const fs::path& file) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  return fmt::format("[Trash Info]\nPath={}\nDeletionDate={:%Y-%m-%dT%H:%M:%S}\n",
                     escaped(fs::absolute(file).lexically_normal().string()), local);
}

/// A name that is free in the bin, whose info file is there now: who makes that owns the name.
fs::path claim_name(const fs::path& trash, const fs::path& file) {
  const std::string info = info_of(file);
  for (int i = 1; i < 10000; ++i) {
    const std::string name = i == 1
                                 ? file.filename().string()
                                 : fmt::format("{}.{}{}", file.stem().string(), i, file.extension().string());
    const fs::path info_file = trash / "info" / (name + ".trashinfo");
    const int fd = ::open(info_file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (fd < 0 && errno == EEXIST) continue;
    if (fd < 0) fail(file, std::strerror(errno));
    const bool is_written = ::write(fd, info.data(), info.size()) == ssize_t(info.size());
    ::close(fd);
    if (is_written) return name;
    ::unlink(info_file.c_str());
    fail(file, "the disk is full");
  }
  fail(file, "there are too many of its name");
}

}  // namespace

void move_to_trash(const fs::path& file, const fs::path& data_home) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file, error))) fail(file, "there is no such file");
  const fs::path trash = data_home / "Trash";
  const bool is_new = !fs::exists(trash, error);
  for (const char* part : {"files", "info"}) {
    fs::create_directories(trash / part, error);
    if (error) fail(file, error.message());
  }
  if (is_new)
    fs::permissions(trash, fs::perms::owner_all, error);  // what lies there is nobody else's business
  const fs::path name = claim_name(trash, file);
  fs::rename(file, trash / "files" / name, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(trash / "info" / (name.string() + ".trashinfo"), ignored);
  fail(file, error.message());
}

}  // namespace crest
