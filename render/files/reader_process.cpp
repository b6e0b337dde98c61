#include "render/files/reader_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "presets/error.h"

namespace crest {
namespace {

/// posix_spawn's two structures, which have to be taken apart again.
struct Spawning {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  Spawning() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  ~Spawning() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  Spawning(const Spawning&) = delete;
  Spawning& operator=(const Spawning&) = delete;
};

}  // namespace

ReaderProcess::ReaderProcess(const std::filesystem::path& program, const std::vector<std::string>& words) {
  const auto fail = [&](int fault) {
    throw Error(fmt::format("the program that reads files, {}, cannot be started: {}", program.string(),
                            std::strerror(fault)));
  };
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail(errno);
  output_ = ends[0];
  constexpr int room = 1 << 20;
  ::fcntl(ends[1], F_SETPIPE_SZ, room);  // a bigger pipe is faster; a smaller one does

  Spawning spawning;
  posix_spawn_file_actions_addopen(&spawning.files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&spawning.files, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&spawning.files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&spawning.files, STDERR_FILENO + 1);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&spawning.attributes, &none);
  posix_spawnattr_setsigdefault(&spawning.attributes, &all);
  posix_spawnattr_setflags(&spawning.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::vector<char*> arguments{const_cast<char*>(program.c_str())};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int fault =
      posix_spawn(&pid_, program.c_str(), &spawning.files, &spawning.attributes, arguments.data(), environ);
  ::close(ends[1]);
  if (fault == 0) return;
  ::close(output_);
  fail(fault);
}

ReaderProcess::~ReaderProcess() {
  kill();
  wait();
  ::close(output_);
}

void ReaderProcess::kill() const {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

bool ReaderProcess::is_stopped() const {
  siginfo_t state{};
  return pid_ > 0 && ::waitid(P_PID, id_t(pid_), &state, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
         state.si_pid == pid_ && state.si_code == CLD_STOPPED;
}

int ReaderProcess::wait() {
  const pid_t pid = std::exchange(pid_, -1);
  int status = 0;
  if (pid > 0) {
    while (::waitpid(pid, &status, 0) < 0) {
      if (errno != EINTR) return 0;
    }
  }
  return status;
}

}  // namespace crest
