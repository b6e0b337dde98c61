#include "tests/gpu/child.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/measure/timing.h"

namespace crest::gpu {

Child::Child(std::vector<std::string> words, std::filesystem::path output, double limit_s)
    : output_(std::move(output)), limit_s_(limit_s), began_(steady_seconds()) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, 1, 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int fault = posix_spawn(&id_, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (fault != 0) throw Error(fmt::format("{}: cannot be started: {}", arguments[0], std::strerror(fault)));
}

Child::~Child() {
  if (is_over_) return;
  kill(-id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

bool Child::is_over() {
  if (is_over_) return true;
  seconds_ = steady_seconds() - began_;
  if (waitpid(id_, &status_, WNOHANG) == id_) {
    is_over_ = true;
  } else if (seconds_ > limit_s_) {
    kill(-id_, SIGKILL);
    waitpid(id_, &status_, 0);
    is_over_ = timed_out_ = true;
  }
  return is_over_;
}

void Child::wait() {
  while (!is_over()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

std::string Child::end() const {
  if (timed_out_) return fmt::format("stopped after {:.0f} s", seconds_);
  if (WIFSIGNALED(status_)) return fmt::format("signal {}", WTERMSIG(status_));
  return fmt::format("exit code {}", WEXITSTATUS(status_));
}

std::string Child::output() const {
  constexpr std::size_t most = std::size_t(64) << 20;
  return read_file(output_, most);
}

}  // namespace crest::gpu
