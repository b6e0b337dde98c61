#pragma once

#include <cstddef>
#include <deque>

#include "ui/document.h"

namespace crest {

/// Most steps that can be undone.
inline constexpr std::size_t history_length = 200;

/// Undo and redo as snapshots of the document. `record` is called when the person is not in the middle of an
/// edit: all that changed since the last call is one step.
class History {
 public:
  /// Takes a snapshot if the document changed; cuts what could be redone.
  void record(const Document& document);
  /// Puts the document back by one step; an edit that was not recorded yet counts as one. False when there is
  /// none.
  bool undo(Document& document);
  bool redo(Document& document);
  bool can_undo(const Document& document) const;
  bool can_redo() const { return !undone_.empty(); }

 private:
  bool started_ = false;
  Document current_;
  std::deque<Document> done_, undone_;  // the newest at the back
};

}  // namespace crest
