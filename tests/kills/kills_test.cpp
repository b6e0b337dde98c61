#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "disk_calls.h"
#include "render/files/file_modules.h"
#include "savers.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;

constexpr int never = -1;

struct Ended {
  bool is_whole = false, is_killed = false;  ///< neither: the save threw
  int answer = 0;
};

/// Saves in a process of its own, which is killed before its `kill_before`-th call to the disk. Where it
/// comes to the end, the answer is what `look` makes of its calls.
Ended save_apart(
    const Saver& saver, const fs::path& folder, int version, int kill_before,
    const std::function<int(const std::vector<DiskCall>&)>& look = [](const auto&) { return 0; }) {
  int pipe[2];
  if (::pipe(pipe) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);  // rather than wait for it for ever
    watch_disk_calls(kill_before);
    try {
      saver.save(folder, version);
      const int answer = look(watched_disk_calls());
      ::_exit(::write(pipe[1], &answer, sizeof answer) == sizeof answer ? 0 : 1);
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}: {}\n", saver.name, error.what());
      ::_exit(1);
    }
  }
  ::close(pipe[1]);
  Ended ended;
  ended.is_whole = ::read(pipe[0], &ended.answer, sizeof ended.answer) == sizeof ended.answer;
  ::close(pipe[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  ended.is_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  return ended;
}

bool is_half_saved(const fs::path& file) { return file.filename().string().starts_with(".crest-"); }

/// By their names below the folder; without what is half saved.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !is_half_saved(entry.path())) {
      std::ifstream file(entry.path(), std::ios::binary);
      contents[entry.path().lexically_relative(folder)] = {std::istreambuf_iterator<char>(file), {}};
    }
  return contents;
}

std::vector<fs::path> half_saved_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (is_half_saved(entry.path())) found.push_back(entry.path());
  return found;
}

class Kills : public testing::TestWithParam<Saver> {
 protected:
  /// The folder before the save that is killed, and after one that is not.
  Kills() {
    image_module();  // loaded once; no process that saves shares anything else with this one
    fs::remove_all(folder_);
    fs::create_directories(before_);
    EXPECT_TRUE(save_apart(GetParam(), before_, 1, never).is_whole);
    fs::copy(before_, after_, fs::copy_options::recursive);
  }
  ~Kills() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() / fmt::format("crest-kills-{}", ::getpid());
  fs::path before_ = folder_ / "before", after_ = folder_ / "after", killed_ = folder_ / "killed";
};

// After each of CREST_KILLS kills (or 5) at a random moment of a save.
TEST_P(Kills, LeaveTheOldFileOrTheNewOne) {
  const char* asked = std::getenv("CREST_KILLS");
  const int kills = asked ? std::atoi(asked) : 5;
  const int calls =
      save_apart(GetParam(), after_, 2, never, [](const auto& made) { return int(made.size()); }).answer;
  ASSERT_GT(calls, 3);
  const auto old_files = contents_of(before_), new_files = contents_of(after_);
  ASSERT_NE(old_files, new_files);

  std::mt19937 random(2009);
  int within = 0, still_old = 0, already_new = 0;
  for (int i = 0; i < kills; ++i) {
    const int moment = std::uniform_int_distribution<int>(0, calls - 1)(random);
    SCOPED_TRACE(fmt::format("killed before call {} of {}", moment, calls));
    fs::remove_all(killed_);
    fs::copy(before_, killed_, fs::copy_options::recursive);
    ASSERT_TRUE(save_apart(GetParam(), killed_, 2, moment).is_killed);
    const auto files = contents_of(killed_);
    for (const auto& [name, content] : files) {
      ASSERT_TRUE(new_files.contains(name)) << name;
      const bool is_old = old_files.contains(name) && content == old_files.at(name);
      EXPECT_TRUE(is_old || content == new_files.at(name)) << name << " is neither the old nor the new one";
    }
    for (const auto& [name, content] : old_files) EXPECT_TRUE(files.contains(name)) << name << " is gone";
    still_old += files == old_files;
    already_new += files == new_files;

    const auto half_saved = half_saved_in(killed_);
    within += !half_saved.empty();
    // Young ones are left alone: another machine may be writing them
    for (const fs::path& file : half_saved)
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(2));
    EXPECT_TRUE(save_apart(GetParam(), killed_, 3, never).is_whole);
    EXPECT_TRUE(half_saved_in(killed_).empty()) << "the next save sweeps";
  }
  fmt::print("{}: {} kills at {} moments: {} with a file half written, {} old, {} new\n", GetParam().name,
             kills, calls, within, still_old, already_new);
  EXPECT_GT(within, kills / 2) << "most kills come while a file is being written";
}

enum Syncing { nothing_is_renamed, all_is_synced, file_is_not_synced, folder_is_not_synced };

/// Whether each file is on the disk before it gets its name, and the folder at once after.
int syncing_of(const std::vector<DiskCall>& calls) {
  int found = nothing_is_renamed;
  for (auto call = calls.begin(); call != calls.end(); ++call) {
    if (call->kind != DiskCall::rename) continue;
    const auto last = std::find_if(std::make_reverse_iterator(call), calls.rend(),
                                   [&](const DiskCall& before) { return before.path == call->path; });
    if (last == calls.rend() || last->kind != DiskCall::sync) return file_is_not_synced;
    const auto next = std::next(call);
    if (next == calls.end() || next->kind != DiskCall::sync || next->path != fs::path(call->to).parent_path())
      return folder_is_not_synced;
    found = all_is_synced;
  }
  return found;
}

TEST_P(Kills, FindFileAndFolderSynced) {
  EXPECT_EQ(save_apart(GetParam(), after_, 2, never, syncing_of).answer, all_is_synced);
}

INSTANTIATE_TEST_SUITE_P(OfEverySave, Kills, testing::ValuesIn(savers()), [](const auto& saver) {
  std::string name = saver.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
});

}  // namespace
}  // namespace crest::test
