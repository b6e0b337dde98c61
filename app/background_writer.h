#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace crest {

/// Writes a file in a thread, so that the window does not wait for a disk that is busy, or far away. What was
/// given last is written in the end, also when this object dies: that waits for it.
class BackgroundWriter {
 public:
  /// May throw.
  using Write = std::function<void()>;

  BackgroundWriter() = default;
  ~BackgroundWriter() { finish(); }
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// In place of one that has not begun. Where no thread is to be had, it is written at once.
  void start(Write write);
  /// Waits until it is written.
  void finish();
  bool has_error() const;
  /// Why the last one failed, once; empty where it did not.
  std::string take_error();

 private:
  void loop(const std::stop_token& quit);
  bool has_thread();

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  // Of both threads
  std::optional<Write> next_;
  bool is_writing_ = false;
  std::string error_;

  std::jthread thread_;
};

}  // namespace crest
