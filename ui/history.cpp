#include "ui/history.h"

#include <utility>

namespace crest {

void History::record(const Document& document) {
  if (!started_) {
    started_ = true;
    current_ = document;
    return;
  }
  if (document == current_) return;
  done_.push_back(std::exchange(current_, document));
  undone_.clear();
  if (done_.size() > history_length) done_.pop_front();
}

bool History::undo(Document& document) {
  record(document);
  if (done_.empty()) return false;
  undone_.push_back(std::exchange(current_, std::move(done_.back())));
  done_.pop_back();
  document = current_;
  return true;
}

bool History::redo(Document& document) {
  record(document);
  if (undone_.empty()) return false;
  done_.push_back(std::exchange(current_, std::move(undone_.back())));
  undone_.pop_back();
  document = current_;
  return true;
}

bool History::can_undo(const Document& document) const {
  return !done_.empty() || (started_ && !(document == current_));
}

}  // namespace crest
