#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "app/thread_priority.h"

namespace crest {

/// Makes results of subjects in a thread of its own, beside the window: of the subject that was given last,
/// since another one stops the work on it. The thread begins with the first subject; no call waits for it.
template <class Subject, class Result>
class BackgroundTask {
 public:
  /// Called in the thread; nothing when it was stopped. May throw.
  using Work = std::function<std::optional<Result>(const Subject&, const std::stop_token&)>;

  explicit BackgroundTask(Work work) : work_(std::move(work)) {}
  ~BackgroundTask() {
    stop();
    thread_.request_stop();  // and waits until the work has noticed
  }
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;

  void start(Subject subject) {
    stop();
    {
      const std::scoped_lock lock(mutex_);
      next_ = std::move(subject);
      run_ = std::stop_source();
      is_running_ = true;
    }
    if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& quit) { loop(quit); });
    wake_.notify_all();
  }
  void stop() {
    const std::scoped_lock lock(mutex_);
    run_.request_stop();
    next_.reset();
    outcome_.reset();
    is_running_ = false;
  }
  bool is_running() const {
    const std::scoped_lock lock(mutex_);
    return is_running_;
  }

  struct Outcome {
    std::optional<Result> result;
    std::string error;  ///< why there is none
  };
  /// What came of the subject, once.
  std::optional<Outcome> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
  }
  bool has_news() const {
    const std::scoped_lock lock(mutex_);
    return outcome_.has_value();
  }

 private:
  void loop(const std::stop_token& quit) {
    lower_thread_priority();
    while (true) {
      std::optional<Subject> subject;
      std::stop_token stopped;
      {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, quit, [&] { return next_.has_value(); })) return;
        subject = std::exchange(next_, std::nullopt);
        stopped = run_.get_token();
      }
      Outcome outcome;
      try {
        outcome.result = work_(*subject, stopped);
      } catch (const std::exception& error) {
        outcome.error = error.what();
      }
      subject.reset();  // what it holds is free before somebody looks
      const std::scoped_lock lock(mutex_);
      if (stopped.stop_requested()) continue;
      outcome_ = std::move(outcome);
      is_running_ = false;
    }
  }

  Work work_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  // Of both threads
  std::optional<Subject> next_;
  std::optional<Outcome> outcome_;
  std::stop_source run_;  ///< stops the work on the subject that was given last
  bool is_running_ = false;

  std::jthread thread_;
};

}  // namespace crest
