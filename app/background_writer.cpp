#include "app/background_writer.h"

#include <utility>

namespace crest {

void BackgroundWriter::start(Write write) {
  const std::scoped_lock lock(mutex_);
  next_ = std::move(write);
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& quit) { loop(quit); });
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
    std::string error;
    try {
      write();
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    lock.lock();
    error_ = std::move(error);
    is_writing_ = false;
    wake_.notify_all();
  }
}

}  // namespace crest
