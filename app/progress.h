#pragma once

#include <signal.h>

#include <chrono>
#include <stop_token>
#include <string_view>
#include <thread>

namespace crest {

/// While it lives, Ctrl-C (SIGINT, or SIGTERM) asks for a stop instead of ending the program; a second one
/// ends it. A signal that was ignored before stays so. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  bool is_requested() const { return stop_.stop_requested(); }

 private:
  struct sigaction before_int_, before_term_;
  std::stop_source stop_;
  std::jthread watcher_;
};

/// How far work is: a line on stderr that is drawn over, and is gone in the end. Nothing where stderr is not
/// a terminal, or where the work takes less than half a second.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done`: share of the whole work, in [0, 1]. `doing`: what is being done, in a few words. One call at a
  /// time.
  void show(double done, std::string_view doing);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_, is_drawn_ = false;
  Clock::time_point began_, next_draw_;
};

/// The line's text: "[####------] 40 % exact answer 'integral', 12 s left".
std::string progress_text(double done, double seconds, std::string_view doing);

}  // namespace crest
