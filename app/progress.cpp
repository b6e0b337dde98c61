#include "app/progress.h"

#include <fmt/core.h>
#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace crest {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds before_first_draw{500}, between_draws{100};
constexpr std::chrono::milliseconds same_interrupt{500};  // it may come to the process and to its group
constexpr int interrupted = 130;                          // 128 + SIGINT, as shells have it

/// All that a signal's handler may do is to post a semaphore, and it knows no object that this could belong
/// to.
sem_t signalled;

extern "C" void post_signal(int) { sem_post(&signalled); }

void handle(int signal, struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = post_signal;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, &before);
  if (before.sa_handler == SIG_IGN) sigaction(signal, &before, nullptr);
}

void watch(std::stop_source stop, const std::stop_token& end) {
  for (Clock::time_point first;;) {
    while (sem_wait(&signalled) != 0) continue;
    if (end.stop_requested()) return;
    if (stop.request_stop())
      first = Clock::now();
    else if (Clock::now() - first > same_interrupt)
      std::_Exit(interrupted);
  }
}

}  // namespace

Interrupt::Interrupt() {
  sem_init(&signalled, 0, 0);
  handle(SIGINT, before_int_);
  handle(SIGTERM, before_term_);
  watcher_ = std::jthread([stop = stop_](const std::stop_token& end) { watch(stop, end); });
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &before_int_, nullptr);
  sigaction(SIGTERM, &before_term_, nullptr);
  watcher_.request_stop();
  sem_post(&signalled);
  watcher_.join();
  sem_destroy(&signalled);
}

ProgressBar::ProgressBar()
    : is_terminal_(isatty(STDERR_FILENO) != 0),
      began_(Clock::now()),
      next_draw_(began_ + before_first_draw) {}

ProgressBar::~ProgressBar() {
  if (is_drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(double done, std::string_view doing) {
  const Clock::time_point now = Clock::now();
  if (!is_terminal_ || now < next_draw_) return;
  next_draw_ = now + between_draws;
  is_drawn_ = true;
  const double seconds = std::chrono::duration<double>(now - began_).count();
  fmt::print(stderr, "\r\033[K{}", progress_text(done, seconds, doing));
  std::fflush(stderr);
}

std::string progress_text(double done, double seconds, std::string_view doing) {
  constexpr int width = 24;
  done = std::clamp(done, 0.0, 1.0);
  const int filled = int(done * width);
  std::string text =
      fmt::format("[{:#>{}}{:->{}}] {:3.0f} % {}", "", filled, "", width - filled, 100 * done, doing);
  if (done > 0) text += fmt::format(", {:.0f} s left", seconds * (1 - done) / done);
  return text;
}

}  // namespace crest
