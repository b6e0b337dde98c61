#include "presets/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>

#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {
namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
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

TEST_F(AtomicFile, FollowsALinkToItsTarget) {
  fs::create_directory(folder / "real");
  fs::create_symlink("real/target.json", path);
  for (const char* content : {"new", "again"}) {
    write_file_atomically(path, content);
    EXPECT_TRUE(fs::is_symlink(path));
    EXPECT_EQ(read_file(folder / "real/target.json", 100), content);
  }
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

TEST_F(AtomicFile, AWriterThatFailsLeavesWhatWasThere) {
  write_file_atomically(path, "old");
  const auto failing = [](const fs::path& temporary) {
    EXPECT_EQ(temporary.extension(), ".json");
    std::ofstream(temporary) << "half";
    throw Error("no more");
  };
  EXPECT_EQ(error_of([&] { write_file_atomically(path, failing); }), "no more");
  EXPECT_EQ(read_file(path, 100), "old");
  EXPECT_EQ(files(), 1u);
  write_file_atomically(path, [](const fs::path& temporary) { std::ofstream(temporary) << "whole"; });
  EXPECT_EQ(read_file(path, 100), "whole");
}

TEST_F(AtomicFile, SaysWhyItCannotWrite) {
  EXPECT_EQ(error_of([&] { write_file_atomically(folder / "no/file.json", "x"); }),
            "cannot write " + (folder / "no/file.json").string() + ": its folder does not exist");
  EXPECT_EQ(error_of([&] { write_file_atomically(folder, "x"); }),
            "cannot write " + folder.string() + ": Is a directory");
}

TEST_F(AtomicFile, RespectsAReadOnlyFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  write_file_atomically(path, "old");
  fs::permissions(path, fs::perms(0444));
  EXPECT_EQ(error_of([&] { write_file_atomically(path, "x"); }),
            "cannot write " + path.string() + ": Permission denied");
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
