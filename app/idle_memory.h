#pragma once

#include <chrono>

namespace crest {

/// Gives memory that is free, and that the C library keeps, back to the system once a program rests: after an
/// hour of pictures and volumes that is a third of what it has (docs/measured.md). It takes some ten
/// milliseconds.
class IdleMemory {
 public:
  using Clock = std::chrono::steady_clock;

  void note_work() { is_given_back_ = false; }
  /// To be called again and again at rest. It is given back once after work, and not each time of many.
  void rest(Clock::time_point now, Clock::time_point last_input);

 private:
  bool is_given_back_ = false;
  Clock::time_point given_back_at_{};
};

}  // namespace crest
