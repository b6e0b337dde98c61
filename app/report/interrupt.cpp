#include "app/report/interrupt.h"

#include <cstdlib>

namespace crest {
namespace {

constexpr timespec poll_time{0, 100'000'000};
constexpr int interrupted = 130;  // 128 + SIGINT, as shells have it

}  // namespace

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  watcher_ = std::jthread([signals = signals_, stop = stop_](std::stop_token end) mutable {
    while (!end.stop_requested())
      if (sigtimedwait(&signals, nullptr, &poll_time) > 0 && !stop.request_stop()) std::_Exit(interrupted);
  });
}

Interrupt::~Interrupt() {
  watcher_.request_stop();
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace crest
