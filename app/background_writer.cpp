#include "app/background_writer.h"

#include <utility>

namespace crest {

namespace {

/// Why it failed; empty where it did not.
std::string written(const BackgroundWriter::Write& write) {
  try {
    write();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

bool BackgroundWriter::has_thread() {
  if (thread_.joinable()) return true;
  try {
    thread_ = std::jthread([this](const std::stop_token& quit) { loop(quit); });
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

void BackgroundWriter::start(Write write) {
  const bool in_thread = has_thread();
  std::string error = in_thread ? "" : written(write);
  const std::scoped_lock lock(mutex_);
  if (in_thread)
    next_ = std::move(write);
  else
    error_ = std::move(error);
  wake_.notify_all();
}

void BackgroundWriter::finish() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return !next_ && !is_writing_; });
}

bool BackgroundWriter::has_error() const {
  const std::scoped_lock lock(mutex_);
  return !error_.empty();
}

std::string BackgroundWriter::take_error() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(error_, "");
}

void BackgroundWriter::loop(const std::stop_token& quit) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, quit, [&] { return next_.has_value(); })) {
    const Write write = *std::exchange(next_, std::nullopt);
    is_writing_ = true;
    lock.unlock();
    std::string error = written(write);
    lock.lock();
    error_ = std::move(error);
    is_writing_ = false;
    wake_.notify_all();
  }
}

}  // namespace crest
