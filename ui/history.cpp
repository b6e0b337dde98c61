#include "ui/history.h"

#include <utility>

#include "ui/document_changes.h"

namespace crest {
namespace {

/// Whether nothing but the file is another.
bool is_saved_as(const Document& before, const Document& after) {
  return !after.preset_path.empty() && !is_same_preset_file(before, after) && before.preset == after.preset &&
         before.volume_source == after.volume_source;
}

}  // namespace

void History::move_to_file(const Document& document) {
  const Document old = steps_[present_].document;
  const auto move = [&](HistoryStep& step) {
    if (!is_same_preset_file(step.document, old)) return false;
    step.document.preset_path = document.preset_path;
    step.document.library_name = document.library_name;
    return true;
  };
  for (std::size_t i = present_ + 1; i < steps_.size() && move(steps_[i]); ++i) continue;
  for (std::size_t i = present_ + 1; i-- > 0 && move(steps_[i]);) continue;
}

void History::record(const Document& document) {
  if (steps_.empty()) {
    steps_.push_back({document, "Start"});
    return;
  }
  const Document& current = steps_[present_].document;
  if (document == current) return;
  if (is_saved_as(current, document)) return move_to_file(document);
  std::string name = describe_step(current, document);
  steps_.erase(steps_.begin() + std::ptrdiff_t(present_) + 1, steps_.end());
  steps_.push_back({document, std::move(name)});
  if (steps_.size() > history_length + 1) steps_.pop_front();
  present_ = steps_.size() - 1;
}

bool History::go_to(std::size_t step, Document& document) {
  if (step >= steps_.size()) return false;
  present_ = step;
  document = steps_[step].document;
  return true;
}

bool History::undo(Document& document) {
  record(document);
  return present_ > 0 && go_to(present_ - 1, document);
}

bool History::redo(Document& document) {
  record(document);
  return can_redo() && go_to(present_ + 1, document);
}

bool History::can_undo(const Document& document) const {
  return present_ > 0 || (!steps_.empty() && !(document == steps_[present_].document));
}

}  // namespace crest
