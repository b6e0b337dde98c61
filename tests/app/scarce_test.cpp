#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <thread>

#include "app/last_words.h"
#include "app/room_to_draw.h"
#include "presets/error.h"
#include "program.h"

namespace crest::test {
namespace {

/// A system that gives the program little.
class Scarce : public ProgramTest {};

TEST_F(Scarce, MemoryEndsInALine) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer needs the address space";
#endif
  for (const int megabytes : {200, 240, 480, 600, 960, 1000})
    expect_error(1, {"render", "builtin:sphere?n=8", "--size", "8x8", "-o", path("a.png")},
                 {"address space", "ulimit -v"}, "ulimit -v " + std::to_string(megabytes * 1024) + ";");
}

TEST_F(Scarce, ACrashIsALine) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer tells of it";
#endif
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
    const auto crash = [&](rlim_t memory) {
      const rlimit limit{memory, RLIM_INFINITY}, no_core{0, 0};
      setrlimit(RLIMIT_AS, &limit);
      setrlimit(RLIMIT_CORE, &no_core);
      end_crashes_with_a_line();
      std::raise(signal);
    };
    const std::string line = "^crest: [^\n]*\n$";
    EXPECT_EXIT(crash(rlim_t(1) << 46), ::testing::ExitedWithCode(1), line) << signal;
    if (signal == SIGXCPU) continue;
    EXPECT_EXIT(crash(RLIM_INFINITY), ::testing::KilledBySignal(signal), line) << signal << ", as without it";
  }
  const auto throw_in_a_thread = [] {
    end_crashes_with_a_line();
    std::thread([] { throw std::bad_alloc(); }).join();
  };
  EXPECT_EXIT(throw_in_a_thread(), ::testing::ExitedWithCode(1), "^crest: out of memory[^\n]*\n$");
}

TEST_F(Scarce, ThreadsEndInALine) {
  const auto draw = [] {
    if (geteuid() == 0 && setuid(54321) != 0) return;  // root may start any number
    const rlimit one{1, 1};
    setrlimit(RLIMIT_NPROC, &one);
    try {
      require_room_to_draw();
    } catch (const Error& error) {
      std::fputs(error.what(), stderr);
      _exit(1);
    }
  };
  EXPECT_EXIT(draw(), ::testing::ExitedWithCode(1), "^drawing takes .* threads, .*ulimit -u");
}

TEST_F(Scarce, ACacheThatCannotBeIsNoNews) {
  write("file", "");
  for (const char* cache : {"$PWD/file", "/dev/null", "/dev/full/none"}) {
    const Outcome outcome =
        run({"render", "builtin:sphere?n=8", "--preset", "onion", "--size", "8x8", "-o", path("a.png")},
            std::string("export XDG_CACHE_HOME=") + cache + ";");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "") << cache;
  }
}

TEST_F(Scarce, FoldersThatAreRelativeAreNone) {
  std::filesystem::create_directories(path("folder/crest"));
  write("folder/crest/config.json", "no JSON");
  EXPECT_EQ(run({"list", "presets"}, "export XDG_CONFIG_HOME=folder;").exit_code, 0);
  EXPECT_EQ(run({"list", "presets"}, "export XDG_CONFIG_HOME=$PWD/folder;").exit_code, 1);
}

}  // namespace
}  // namespace crest::test
