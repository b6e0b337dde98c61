#include "app/autosave.h"

#include <utility>

namespace crest {

bool Autosave::is_writing() const {
  return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void Autosave::begin_writing(const Document& document) {
  writing_ = std::async(std::launch::async, [this, document, time = std::chrono::system_clock::now()] {
    if (!file_) file_.emplace(folder_);
    file_->write({document, time});
  });
}

std::string Autosave::update(const Document& document, bool has_unsaved_changes, Clock::time_point now) {
  if (folder_.empty() || is_writing()) return "";
  std::string error;
  try {
    if (writing_.valid()) writing_.get();
  } catch (const std::exception& failure) {
    if (failure.what() != told_) error = told_ = failure.what();
    // It is tried again, after a rest
    waits_ = true;
    first_change_ = last_change_ = now;
  }
  if (!has_unsaved_changes) {
    end();
    return error;
  }
  if (!(document == seen_)) {
    seen_ = document;
    last_change_ = now;
    if (!std::exchange(waits_, true)) first_change_ = now;
  }
  if (waits_ && (now - last_change_ >= rest || now - first_change_ >= longest)) {
    waits_ = false;
    try {
      begin_writing(document);
    } catch (const std::exception&) {  // no thread: perhaps later
      waits_ = true;
      first_change_ = last_change_ = now;
    }
  }
  return error;
}

void Autosave::adopt(RecoveryFile file, const Document& document) {
  end();
  file_ = std::move(file);
  seen_ = document;
}

void Autosave::leave_behind(const Document& document) {
  try {
    if (writing_.valid()) writing_.get();
    if (!file_) file_.emplace(folder_);
    file_->write({document, std::chrono::system_clock::now()});
  } catch (const std::exception&) {
    // The undo history still has it
  }
  file_.reset();
  end();
}

void Autosave::end() {
  if (writing_.valid()) writing_.wait();
  writing_ = {};
  if (file_) file_->remove();
  file_.reset();
  seen_ = {};
  waits_ = false;
}

}  // namespace crest
