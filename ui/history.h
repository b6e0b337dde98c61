#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "ui/document.h"

namespace crest {

/// Most steps that can be undone.
inline constexpr std::size_t history_length = 200;

struct HistoryStep {
  Document document;
  std::string name;  ///< what led here, in a sentence
};

/// Undo and redo as snapshots of the document. `record` is called when the person is not in the middle of an
/// edit: all that changed since the last call is one step.
class History {
 public:
  /// Takes a snapshot if the document changed; cuts what could be redone. Saving under another name is no
  /// step: those that the preset went through now belong to its new file.
  void record(const Document& document);
  /// Puts the document back by one step; an edit that was not recorded yet counts as one. False when there is
  /// none.
  bool undo(Document& document);
  bool redo(Document& document);
  /// Makes the document what it was at one of steps().
  bool go_to(std::size_t step, Document& document);

  /// The oldest first; empty until the first record().
  const std::deque<HistoryStep>& steps() const { return steps_; }
  std::size_t present() const { return present_; }  ///< which of them the document is
  bool can_undo(const Document& document) const;
  bool can_redo() const { return present_ + 1 < steps_.size(); }

 private:
  void move_to_file(const Document& document);

  std::deque<HistoryStep> steps_;
  std::size_t present_ = 0;
};

}  // namespace crest
