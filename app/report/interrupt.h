#pragma once

#include <signal.h>

#include <stop_token>
#include <thread>

namespace crest {

/// While it lives, Ctrl-C (SIGINT, or SIGTERM) asks for a stop instead of ending the program; a second one
/// ends it. Make it before other threads are started.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  sigset_t signals_, before_;
  std::stop_source stop_;
  std::jthread watcher_;
};

}  // namespace crest
