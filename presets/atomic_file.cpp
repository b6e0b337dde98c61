#include "presets/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "presets/error.h"

namespace crest {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail_writing(const fs::path& path, int error) {
  const bool no_folder = error == ENOENT || error == ENOTDIR;
  throw Error(fmt::format("cannot write {}: {}", path.string(),
                          no_folder ? "its folder does not exist" : std::strerror(error)));
}

/// What keeps a file from being made in the folder, which is another thing than the file's own permission.
[[noreturn]] void fail_in_folder(const fs::path& path, int error) {
  if (error != EACCES && error != EPERM) fail_writing(path, error);
  throw Error(fmt::format("cannot write {}: no file can be made in its folder: {}", path.string(),
                          std::strerror(error)));
}

/// An open file, and the checks of each call on it. Errors name `path`, which the person knows.
class File {
 public:
  File(int open_file, const fs::path& path) : known_as(path), fd(open_file) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (fd >= 0) ::close(fd);
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(fd, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_writing(known_as, errno);
      content.remove_prefix(std::size_t(written));
    }
  }
  /// Owner and group where that is permitted, and permissions. Another group gets no more than others have.
  void take_after(const struct stat& old) {
    mode_t mode = old.st_mode & 0777;
    if (::fchown(fd, old.st_uid, old.st_gid) != 0 && ::fchown(fd, uid_t(-1), old.st_gid) != 0)
      mode = (mode & 0707) | (mode & 0007) << 3;
    if (::fchmod(fd, mode) != 0) fail_writing(known_as, errno);
  }
  void sync() {
    if (::fsync(fd) != 0 && errno != EINVAL && errno != EROFS) fail_writing(known_as, errno);
  }
  void close() {
    if (::close(std::exchange(fd, -1)) != 0) fail_writing(known_as, errno);
  }

 private:
  fs::path known_as;
  int fd;
};

/// A new, empty file of its own name in the folder of `target`; removed again unless it is renamed. It has an
/// ending of its own, so that who reads all presets of a folder does not read it.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, mode_t mode, const fs::path& path) : known_as(path) {
    for (int attempt = 0; fd < 0; ++attempt) {
      name = target.parent_path() / fmt::format(".crest-{}-{}.part", ::getpid(), attempt);
      fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (fd < 0 && (errno != EEXIST || attempt == 1000)) fail_in_folder(known_as, errno);
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!name.empty()) ::unlink(name.c_str());
  }

  int file() const { return fd; }
  void rename_to(const fs::path& target) {
    if (::rename(name.c_str(), target.c_str()) != 0) fail_writing(known_as, errno);
    name.clear();
  }

 private:
  fs::path name, known_as;
  int fd = -1;
};

/// What stands at `path`, if anything does. Throws Error where nothing could stand there, and for what cannot
/// be written over.
std::optional<struct stat> what_stands_at(const fs::path& path) {
  struct stat existing {};
  if (::stat(path.c_str(), &existing) != 0) {
    if (errno == ENOENT) return std::nullopt;
    fail_writing(path, errno);
  }
  if (S_ISDIR(existing.st_mode)) fail_writing(path, EISDIR);
  if (::access(path.c_str(), W_OK) != 0) fail_writing(path, errno);
  return existing;
}

/// Open for writing. A pipe is not waited for: who reads it gets a second to come.
int open_device(const fs::path& path) {
  constexpr std::chrono::milliseconds for_a_reader{1000}, between{10};
  const auto end = std::chrono::steady_clock::now() + for_a_reader;
  int fd = -1;
  while ((fd = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) < 0) {
    if (errno != ENXIO) fail_writing(path, errno);
    if (std::chrono::steady_clock::now() > end)
      throw Error(fmt::format("cannot write {}: a pipe that nobody reads", path.string()));
    std::this_thread::sleep_for(between);
  }
  ::fcntl(fd, F_SETFL, 0);
  return fd;
}

/// The file that a symbolic link leads to, though it need not exist.
fs::path link_target(fs::path path) {
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(path, error); ++links)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

struct FileToRead {
  explicit FileToRead(const fs::path& path)
      : fd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  FileToRead(const FileToRead&) = delete;
  FileToRead& operator=(const FileToRead&) = delete;
  ~FileToRead() {
    if (fd >= 0) ::close(fd);
  }
  int fd;
};

/// Takes away what saves left in the folder whose programs were killed: of processes that are no more, and an
/// hour old, since those of another machine may be in one's folder too.
void sweep(const fs::path& folder) {
  constexpr std::chrono::hours old{1};
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
    const std::string name = entry->path().filename().string();
    int process = 0, attempt = 0;
    if (std::sscanf(name.c_str(), ".crest-%d-%d", &process, &attempt) != 2 || process <= 0) continue;
    const bool is_over = ::kill(process, 0) != 0 && errno == ESRCH;
    std::error_code ignored;
    if (is_over && entry->is_regular_file(ignored) &&
        fs::file_time_type::clock::now() - entry->last_write_time(ignored) > old)
      fs::remove(entry->path(), ignored);
  }
}

/// So that the new name too survives a power failure. Not every file system can; the content is safe already.
void sync_folder(const fs::path& file) {
  const int fd = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

void write_whole(const fs::path& path, std::string_view content, bool waits_for_disk) {
  const auto existing = what_stands_at(path);
  if (existing && !S_ISREG(existing->st_mode)) {  // a pipe or device: nothing to replace
    File file(open_device(path), path);
    file.write(content);
    return file.close();
  }
  const fs::path target = link_target(path);
  // What was private is so from the first byte on
  TemporaryFile temporary(target, existing ? 0600 : 0666, path);
  File file(temporary.file(), path);
  file.write(content);
  if (existing) file.take_after(*existing);
  if (waits_for_disk) file.sync();
  file.close();
  temporary.rename_to(target);
  if (waits_for_disk) sync_folder(target);
  sweep(folder_of(target));
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_whole(path, content, true);
}

void replace_file(const fs::path& path, std::string_view content) { write_whole(path, content, false); }

void require_writable(const fs::path& path) {
  const auto existing = what_stands_at(path);
  if (existing && !S_ISREG(existing->st_mode)) return;
  const fs::path folder = folder_of(link_target(path));
  struct stat state {};
  if (::stat(folder.c_str(), &state) != 0) fail_writing(path, errno);
  if (!S_ISDIR(state.st_mode)) fail_writing(path, ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail_in_folder(path, errno);
}

std::string read_file(const fs::path& path, std::size_t size_limit) {
  const auto fail = [&](const std::string& what) {
    throw Error(fmt::format("cannot read {}: {}", path.string(), what));
  };
  // Without waiting, or a pipe that nobody writes into would be waited for
  const FileToRead file(path);
  if (file.fd < 0) fail(std::strerror(errno));
  struct stat state {};
  if (::fstat(file.fd, &state) != 0) fail(std::strerror(errno));
  if (S_ISDIR(state.st_mode)) fail("it is a folder");
  const auto too_large = [&] { fail(fmt::format("it is larger than {} bytes", size_limit)); };
  if (S_ISREG(state.st_mode) && std::uint64_t(state.st_size) > size_limit) too_large();
  if (S_ISFIFO(state.st_mode)) {
    constexpr int for_a_writer = 1000;  // ms; who waited for a reader may be about to come
    pollfd pipe{file.fd, POLLIN, 0};
    ::poll(&pipe, 1, for_a_writer);
  }
  ::fcntl(file.fd, F_SETFL, 0);

  std::string content;
  constexpr std::size_t block = 1 << 16;
  while (true) {
    const std::size_t before = content.size();
    content.resize(before + block);
    const ssize_t got = ::read(file.fd, content.data() + before, block);
    if (got < 0 && errno != EINTR) fail(std::strerror(errno));
    content.resize(before + std::size_t(std::max<ssize_t>(got, 0)));
    if (content.size() > size_limit) too_large();
    if (got != 0) continue;
    if (content.empty() && S_ISFIFO(state.st_mode)) fail("a pipe that nobody has written into");
    return content;
  }
}

}  // namespace crest
