#include "presets/atomic_file.h"

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {
namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::all);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t files() const {
    return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  template <class F>
  std::string error_of(F&& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  /// The same in a process of a user who is not root.
  template <class F>
  std::string error_as_nobody(F&& work) {
    if (::geteuid() != 0) return error_of(work);
    constexpr uid_t nobody = 65534;
    int pipe[2];
    if (::pipe(pipe) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
      const bool is_nobody = ::setgroups(0, nullptr) == 0 && ::setresgid(nobody, nobody, nobody) == 0 &&
                             ::setresuid(nobody, nobody, nobody) == 0;
      const std::string error = is_nobody ? error_of(work) : "still root";
      ::_exit(::write(pipe[1], error.data(), error.size()) < 0);
    }
    ::close(pipe[1]);
    std::string error(1000, '\0');
    error.resize(std::size_t(std::max<ssize_t>(::read(pipe[0], error.data(), error.size()), 0)));
    ::close(pipe[0]);
    ::waitpid(child, nullptr, 0);
    return error;
  }
  static struct stat state_of(const fs::path& file) {
    struct stat state {};
    ::stat(file.c_str(), &state);
    return state;
  }

  fs::path folder = fs::temp_directory_path() / ("crest-atomic-" + std::to_string(::getpid()));
  fs::path path = folder / "preset.json";
};

TEST_F(AtomicFile, WritesTheWholeContentAndLeavesNothingElse) {
  const std::string content = std::string(3 << 20, 'x') + std::string("\0end", 4);
  write_file_atomically(path, content);
  EXPECT_EQ(read_file(path, 4 << 20), content);
  write_file_atomically(path, "short");
  EXPECT_EQ(read_file(path, 5), "short");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, KeepsThePermissionsOfWhatWasThere) {
  write_file_atomically(path, "a");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0666 & ~mask));
  fs::permissions(path, fs::perms(0640));
  write_file_atomically(path, "b");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, KeepsTheGroupOfWhatWasThere) {
  write_file_atomically(path, "a");
  gid_t groups[64];
  const int count = ::getgroups(64, groups);
  const gid_t other = ::geteuid() == 0 ? 12345 : count > 0 ? groups[count - 1] : ::getegid();
  if (other == ::getegid()) GTEST_SKIP() << "this user has one group";
  ASSERT_EQ(::chown(path.c_str(), uid_t(-1), other), 0);
  fs::permissions(path, fs::perms(0660));
  write_file_atomically(path, "b");
  EXPECT_EQ(state_of(path).st_gid, other);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0660));
}

TEST_F(AtomicFile, GivesAnotherGroupNoMoreThanOthersHave) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of somebody else";
  write_file_atomically(path, "a");
  ASSERT_EQ(::chown(path.c_str(), 12345, 12345), 0);
  fs::permissions(path, fs::perms(0662));
  EXPECT_EQ(error_as_nobody([&] { write_file_atomically(path, "b"); }), "no error");
  EXPECT_EQ(read_file(path, 10), "b");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0622));
}

TEST_F(AtomicFile, FollowsALinkToItsTarget) {
  fs::create_directory(folder / "real");
  fs::create_symlink("real/target.json", folder / "near");  // at first to a file that is not there
  fs::create_symlink(folder / "near", path);
  for (const char* content : {"new", "again"}) {
    write_file_atomically(path, content);
    EXPECT_EQ(fs::read_symlink(path), folder / "near");
    EXPECT_EQ(fs::read_symlink(folder / "near"), "real/target.json");
    EXPECT_EQ(read_file(folder / "real/target.json", 100), content);
  }
  EXPECT_EQ(files(), 3u);
}

TEST_F(AtomicFile, LeavesALinkAloneThatLeadsNowhere) {
  fs::create_symlink("none/target.json", path);
  EXPECT_EQ(error_of([&] { write_file_atomically(path, "x"); }),
            "cannot write " + path.string() + ": its folder does not exist");
  fs::remove(path);
  fs::create_symlink("preset.json", path);  // to itself
  EXPECT_EQ(error_of([&] { write_file_atomically(path, "x"); }),
            "cannot write " + path.string() + ": Too many levels of symbolic links");
  EXPECT_TRUE(fs::is_symlink(path));
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, AFullDiskLeavesWhatWasThere) {
  write_file_atomically(path, "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = error_of([&] { write_file_atomically(path, std::string(1 << 20, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(error, "cannot write " + path.string() + ": File too large");
  EXPECT_EQ(read_file(path, 100), "old");
  EXPECT_EQ(files(), 1u);
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(error_of([] { write_file_atomically("/dev/full", "x"); }),
            "cannot write /dev/full: No space left on device");
}

TEST_F(AtomicFile, SaysWhyItCannotWrite) {
  EXPECT_EQ(error_of([&] { write_file_atomically(folder / "no/file.json", "x"); }),
            "cannot write " + (folder / "no/file.json").string() + ": its folder does not exist");
  EXPECT_EQ(error_of([&] { write_file_atomically(folder, "x"); }),
            "cannot write " + folder.string() + ": Is a directory");
}

TEST_F(AtomicFile, RespectsWhatIsReadOnly) {
  write_file_atomically(path, "old");
  fs::permissions(path, fs::perms(0444));
  const auto save = [&] { write_file_atomically(path, "x"); };
  const auto check = [&] { require_writable(path); };
  EXPECT_EQ(error_as_nobody(save), "cannot write " + path.string() + ": Permission denied");
  EXPECT_EQ(error_as_nobody(check), error_as_nobody(save));
  fs::permissions(path, fs::perms(0666));
  fs::permissions(folder, fs::perms(0555));
  EXPECT_EQ(error_as_nobody(save),
            "cannot write " + path.string() + ": no file can be made in its folder: Permission denied");
  EXPECT_EQ(error_as_nobody(check), error_as_nobody(save));
  fs::permissions(folder, fs::perms(0755));
  EXPECT_EQ(read_file(path, 100), "old");
}

TEST_F(AtomicFile, WritesToADeviceWithoutReplacingIt) {
  write_file_atomically("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, ReadsNoFolderAndNothingTooLarge) {
  EXPECT_EQ(error_of([&] { read_file(path, 10); }),
            "cannot read " + path.string() + ": No such file or directory");
  EXPECT_EQ(error_of([&] { read_file(folder, 10); }), "cannot read " + folder.string() + ": it is a folder");
  write_file_atomically(path, "12345678901");
  EXPECT_EQ(error_of([&] { read_file(path, 10); }),
            "cannot read " + path.string() + ": it is larger than 10 bytes");
  EXPECT_EQ(error_of([&] { read_file("/dev/zero", 1 << 20); }),
            "cannot read /dev/zero: it is larger than 1048576 bytes");
}

TEST_F(AtomicFile, SweepsWhatKilledSavesLeft) {
  const pid_t ended = ::fork();
  if (ended == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(ended, nullptr, 0), ended);
  const auto left = [&](pid_t process, int hours, const std::string& end = ".json") {
    const fs::path name = folder / (".crest-" + std::to_string(process) + "-0" + end);
    std::ofstream(name) << "half";
    fs::last_write_time(name, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    return name;
  };
  const fs::path old = left(ended, 2), young = left(ended, 0, ".png"), ours = left(::getpid(), 2);
  write_file_atomically(path, "x");
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young)) << "it may be another machine's";
  EXPECT_TRUE(fs::exists(ours)) << "its program runs";
}

TEST_F(AtomicFile, APipeIsReadWhereSomebodyWrites) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of([&] { read_file(pipe, 10); }),
            "cannot read " + pipe.string() + ": a pipe that nobody has written into");
  std::thread writer([&] { std::ofstream(pipe) << "content"; });  // waits for who reads
  EXPECT_EQ(read_file(pipe, 10), "content");
  writer.join();
}

TEST_F(AtomicFile, APipeIsWrittenWhereSomebodyReads) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of([&] { write_file_atomically(pipe, "content"); }),
            "cannot write " + pipe.string() + ": a pipe that nobody reads");
  std::string read;
  std::thread reader([&] { std::ifstream(pipe) >> read; });
  write_file_atomically(pipe, "content");
  reader.join();
  EXPECT_EQ(read, "content");
}

TEST_F(AtomicFile, ALargeFileIsRefusedUnread) {
  std::ofstream(path) << "x";
  fs::resize_file(path, std::uintmax_t(1) << 40);
  EXPECT_EQ(error_of([&] { read_file(path, 10); }),
            "cannot read " + path.string() + ": it is larger than 10 bytes");
}

TEST_F(AtomicFile, TellsBeforeWhatCannotBeWritten) {
  EXPECT_NO_THROW(require_writable(path));
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(error_of([&] { require_writable(folder / "none" / "a"); }),
            "cannot write " + (folder / "none" / "a").string() + ": its folder does not exist");
  EXPECT_EQ(error_of([&] { require_writable(folder); }),
            "cannot write " + folder.string() + ": Is a directory");
  EXPECT_NO_THROW(require_writable("/dev/null"));
}

TEST_F(AtomicFile, PresetsAreSavedAndLoaded) {
  Preset preset;
  preset.name = "Saved";
  preset.transfer_function = default_transfer_function();
  save_preset(path, preset);
  EXPECT_EQ(load_preset(path), preset);
  EXPECT_EQ(error_of([&] {
              load_preset((folder / "none").string());
            }).find((folder / "none").string() + ": no such file"),
            0u);
  EXPECT_EQ(error_of([&] { load_preset(folder.string()); }),
            "cannot read " + folder.string() + ": it is a folder");
}

}  // namespace
}  // namespace crest
